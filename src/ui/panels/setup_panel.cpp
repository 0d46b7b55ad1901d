// SETUP: what the run is made of.
#include "session/app_model.h"
#include "session/step_cost.h"
#include "ui/panels/panels.h"
#include "ui/panels/setup_rows.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using models::ModelType;
using session::AppModel;
using session::Settings;
using session::Setup;
using sim::Config;

namespace {

/// The config that runs now in the place of the setup under edit; null before there is one.
const Config* running_config(const AppModel& app) {
  const session::Snapshot& now = app.now();
  return app.active() < now.runs.size() ? now.runs[app.active()].config.get() : nullptr;
}

/// What waits for CREATE, for its tooltip.
std::string waiting_for_create(const Setup& setup, const Config* running) {
  if (running == nullptr) return "Makes the terrain.";
  if (setup.config().model != running->model) return "Makes a new terrain for another model.";
  std::string waiting;
  for (const char* group : {"grid", "scene", "parameters", "run"}) {
    for (const session::SetupRow& row : setup.rows(group, running)) {
      if (row.pending && row.needs_new_terrain) waiting += "\n- " + row.parameter->label;
    }
  }
  return waiting.empty() ? "Makes the terrain again." : "Makes a new terrain. These changes wait for it:" + waiting;
}

class SetupPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::setup; }
  Dock dock() const override { return Dock::left; }
  void draw(PanelContext& context) override;

 private:
  static void draw_run_choice(AppModel& app);
  void draw_buttons(PanelContext& context, const Config* running);
  static void draw_cost(std::optional<double> seconds);
  static void draw_model(Setup& setup);
  void draw_groups(Setup& setup, const Config* running, const Settings& settings);
  void draw_rows(Setup& setup, const std::string& group, const Config* running, const Settings& settings);
  static void draw_seed(Setup& setup);

  session::StepCost cost_;
  std::string picture_group_;  ///< group and key of the path that the browser is asked for
  std::string picture_key_;
  FilePopup picture_{{.title = "CHOOSE A PICTURE", .action = "CHOOSE", .endings = {".png"}}};
};

void SetupPanel::draw_run_choice(AppModel& app) {
  const std::size_t runs = app.comparison().size();
  if (runs < 2) return;
  for (std::size_t run = 0; run < runs; ++run) {
    if (run > 0) ImGui::SameLine();
    const std::string label = "run " + std::to_string(run + 1);
    const bool active = run == app.active();
    if (button(label.c_str(), {.tooltip = "The rows below are those of this run.",
                               .look = active ? ButtonLook::accent : ButtonLook::plain})) {
      app.set_active(run);
    }
  }
}

void SetupPanel::draw_buttons(PanelContext& context, const Config* running) {
  AppModel& app = context.app;
  const std::vector<Mistake> mistakes = app.setup().mistakes();
  const bool needed = app.create_needed();
  const float half = share_of_width(2);
  if (button("CREATE", {.tooltip = waiting_for_create(app.setup(), running),
                        .unavailable = mistakes.empty() ? "" : "Something stands against it; see below.",
                        .look = needed ? ButtonLook::accent : ButtonLook::plain,
                        .size = {half, 0}})) {
    context.leave("CREATE", session::Leaves::terrain, [&app] { app.create(); });
  }
  ImGui::SameLine();
  if (button("RESET DEFAULT",
             {.tooltip = "Every value back to its default, the wind too; the model stays.", .size = {half, 0}})) {
    app.setup().reset_all();
  }
  for (const Mistake& mistake : mistakes) say(mistake.text(), Gui::current().theme().lost);
  draw_cost(needed && mistakes.empty() ? cost_.of(app.setup().config()) : std::nullopt);
}

/// What will crawl says so before it is made. The line's place is kept where there is nothing to say: it becomes known
/// a moment after a change, and rows must not move away under the pointer.
void SetupPanel::draw_cost(std::optional<double> seconds) {
  constexpr double slow = 0.3;  // s a step
  if (!seconds || *seconds < slow) {
    ImGui::Dummy({0, ImGui::GetTextLineHeight()});
    return;
  }
  say("A step: about " + figure_text(*seconds, 2) + " s; fewer cells are faster.", Gui::current().theme().accent);
  mark("cost");
}

void SetupPanel::draw_model(Setup& setup) {
  std::string material = setup.material() == Material::sand ? "sand" : "snow";
  const bool has_snow = !Setup::models_of(Material::snow).empty();
  const std::vector<std::string> materials{"sand", "snow"};
  if (choice_row({.label = "material",
                  .tooltip = "What the wind moves. Each has models of its own.",
                  .unavailable = has_snow ? "" : "All models move sand."},
                 material, materials) == RowEvent::changed) {
    setup.choose_material(material == "sand" ? Material::sand : Material::snow);
  }
  const std::vector<const ModelType*> models = Setup::models_of(setup.material());
  // The whole width: titles are long.
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##model", setup.model().info.title.c_str());
  if (!open) mark("model");
  if (!open) tooltip("The model. " + setup.model().info.citation);
  if (open) {
    for (const ModelType* model : models) {
      if (ImGui::Selectable(model->info.title.c_str(), model == &setup.model())) setup.choose_model(model->info.key);
      mark("model=" + model->info.title);
      tooltip("Makes " + model->info.produces + ".");
    }
    ImGui::EndCombo();
  }
  const models::ModelInfo& info = setup.model().info;
  explain("Makes " + info.produces + ".");
  explain("Leaves out: " + info.limitations + ".");
}

void SetupPanel::draw_seed(Setup& setup) {
  bool fresh = setup.fresh_seed();
  if (switch_row(
          {.label = "fresh seed",
           .tooltip = "Draws another seed with each CREATE, so that each terrain is a new one. Off: the same seed "
                      "gives the same dunes, to the bit."},
          fresh) == RowEvent::changed) {
    setup.set_fresh_seed(fresh);
  }
}

void SetupPanel::draw_rows(Setup& setup, const std::string& group, const Config* running, const Settings& settings) {
  const std::string path = draw_setup_rows(setup, group, running);
  if (path.empty()) return;
  picture_group_ = group;
  picture_key_ = path;
  picture_.ask(settings, "");
}

void SetupPanel::draw_groups(Setup& setup, const Config* running, const Settings& settings) {
  if (section("Model")) {
    draw_rows(setup, "parameters", running, settings);
    for (const std::string& meaning : setup.explanations()) explain(meaning);
  }
  if (section("Scene")) draw_rows(setup, "scene", running, settings);
  if (section("Grid")) draw_rows(setup, "grid", running, settings);
  if (section("Run")) {
    draw_rows(setup, "run", running, settings);
    draw_seed(setup);
  }
}

void SetupPanel::draw(PanelContext& context) {
  AppModel& app = context.app;
  const Config* running = running_config(app);
  draw_run_choice(app);
  draw_buttons(context, running);
  draw_model(app.setup());
  draw_groups(app.setup(), running, app.settings());
  if (const auto file = picture_.draw(app)) app.setup().set(picture_group_, picture_key_, file->string());
}

}  // namespace

std::unique_ptr<Panel> make_setup_panel() { return std::make_unique<SetupPanel>(); }

}  // namespace erg::ui
