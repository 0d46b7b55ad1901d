// COMPARE: two to four runs under one wind and clock, and how they differ.
#include <cmath>

#include "core/number_text.h"
#include "io/formats/run_numbers.h"
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::AppModel;
using session::Comparison;
using session::SetupDifference;
using session::Snapshot;

namespace {

constexpr ImGuiTableFlags table_flags =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;

class ComparePanel final : public Panel {
 public:
  const char* title() const override { return panel_title::compare; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {720, 560}; }
  void draw(PanelContext& context) override;

 private:
  static bool begin_table(const char* id, std::size_t runs);
  static void draw_runs(PanelContext& context);
  static void draw_differences(const Comparison& comparison);
  static void draw_numbers(const Snapshot& now);
};

bool ComparePanel::begin_table(const char* id, std::size_t runs) {
  if (!ImGui::BeginTable(id, static_cast<int>(runs) + 1, table_flags)) return false;
  ImGui::TableSetupColumn("", 0, 1.6f);
  for (std::size_t run = 0; run < runs; ++run) {
    ImGui::TableSetupColumn(("run " + std::to_string(run + 1)).c_str(), 0, 1);
  }
  ImGui::TableHeadersRow();
  return true;
}

void ComparePanel::draw_runs(PanelContext& context) {
  AppModel& app = context.app;
  Comparison& comparison = app.comparison();
  for (std::size_t run = 0; run < comparison.size(); ++run) {
    const std::string number = std::to_string(run + 1);
    const bool active = run == app.active();
    if (button(("EDIT RUN " + number).c_str(), {.tooltip = "The panel SETUP then shows this run.",
                                                .look = active ? ButtonLook::accent : ButtonLook::plain})) {
      app.set_active(run);
    }
    ImGui::SameLine();
    const bool removed =
        button(("REMOVE##" + number).c_str(), {.tooltip = "Takes the run out of the comparison, with the next CREATE.",
                                               .unavailable = comparison.size() == 1 ? "One run stays." : "",
                                               .look = ButtonLook::quiet});
    mark("remove " + number);
    ImGui::SameLine();
    const sim::Config& config = comparison.setup(run).config();
    ImGui::Text("%s, %lld x %lld, seed %lld", comparison.setup(run).model().info.title.c_str(),
                static_cast<long long>(config.grid.integer("nx")), static_cast<long long>(config.grid.integer("ny")),
                static_cast<long long>(config.run.integer("seed")));
    if (removed && comparison.remove(run)) {
      app.set_active(std::min(app.active(), comparison.size() - 1));
      break;
    }
  }
  if (button("ADD A COPY",
             {.tooltip = "One more run like the one being edited, with the next seed. Change it in SETUP.",
              .unavailable = comparison.size() == session::most_runs ? "Four runs are the most." : ""})) {
    if (const auto added = comparison.add_copy_of(app.active())) app.set_active(*added);
  }
  ImGui::SameLine();
  if (button("CREATE", {.tooltip = "Makes the terrains of all runs.",
                        .look = app.create_needed() ? ButtonLook::accent : ButtonLook::plain})) {
    context.leave("CREATE", session::Leaves::terrain, [&app] { app.create(); });
  }
}

void ComparePanel::draw_differences(const Comparison& comparison) {
  if (comparison.size() == 1) {
    explain("One run. Add a copy, change it in SETUP, and CREATE: both go by one wind and one clock, side by side.");
    return;
  }
  const std::vector<SetupDifference> differences = comparison.differences();
  if (differences.empty()) {
    explain("All runs are set up alike.");
    return;
  }
  if (!begin_table("differences", comparison.size())) return;
  for (const SetupDifference& difference : differences) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(difference.label.c_str());
    tooltip(difference.name);
    for (const std::string& value : difference.values) {
      ImGui::TableNextColumn();
      ImGui::TextColored(Gui::current().theme().accent, "%s", value.c_str());
    }
  }
  ImGui::EndTable();
}

void ComparePanel::draw_numbers(const Snapshot& now) {
  if (!now.has_runs()) {
    explain("Their numbers appear here once their terrains are made.");
    return;
  }
  if (!begin_table("numbers", now.runs.size())) return;
  for (const session::ComparedNumber& number : session::compared_numbers(now)) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(number.number.label.c_str());
    if (!number.number.unit.empty()) {
      ImGui::SameLine();
      ImGui::TextDisabled("%s", unit_text(number.number.unit).c_str());
    }
    tooltip(number.number.meaning);
    for (const double value : number.values) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(figure_text(value).c_str());
    }
  }
  ImGui::EndTable();
}

void ComparePanel::draw(PanelContext& context) {
  AppModel& app = context.app;
  draw_runs(context);
  if (section("How they differ")) draw_differences(app.comparison());
  if (section("Their numbers")) draw_numbers(app.now());
}

}  // namespace

std::unique_ptr<Panel> make_compare_panel() { return std::make_unique<ComparePanel>(); }

}  // namespace erg::ui
