#include "ui/panels/unsaved_panel.h"

#include <utility>

#include "ui/panels/panels.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::AppModel;
using session::Export;
using session::UnsavedItem;

namespace {

class UnsavedPanel final : public Panel {
 public:
  explicit UnsavedPanel(std::optional<Parting>& parting) : parting_(parting) {}

  const char* title() const override { return unsaved_title; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {560, 130}; }
  void draw(PanelContext& context) override;

 private:
  void draw_buttons(PanelContext& context, const UnsavedItem& work);
  void save(AppModel& app, const UnsavedItem& work);
  void take_file(PanelContext& context, const UnsavedItem& work);
  void go_on(PanelContext& context);

  std::optional<Parting>& parting_;
  bool saving_ = false;  // SAVE was pressed
  FilePopup config_{{.title = "SAVE THE SETUP", .action = "SAVE", .endings = {".json"}, .saving = true}};
  FilePopup checkpoint_{{.title = "SAVE THE LAND", .action = "SAVE", .endings = {".checkpoint"}, .saving = true}};
};

void UnsavedPanel::go_on(PanelContext& context) {
  context.close(title());
  if (const std::optional<Parting> parting = std::exchange(parting_, std::nullopt)) parting->act();
}

void UnsavedPanel::save(AppModel& app, const UnsavedItem& work) {
  saving_ = true;
  app.set_active(work.run);
  if (work.terrain) {
    checkpoint_.ask(app.settings(), app.suggested_name("-" + std::to_string(app.now().step()) + ".checkpoint"));
  } else if (app.has_own_file()) {
    app.save_config(app.file());
  } else {
    config_.ask(app.settings(), app.suggested_name(".json"));
  }
}

void UnsavedPanel::draw_buttons(PanelContext& context, const UnsavedItem& work) {
  const Export* const running = context.app.running_export();
  const bool writing = running != nullptr && running->state() == Export::State::writing;
  if (writing) {
    ImGui::ProgressBar(static_cast<float>(running->progress()), {-1, 0}, running->path().filename().c_str());
  }
  if (button("SAVE",
             {.tooltip = work.terrain ? "Asks for a file: a checkpoint, which holds terrain and setup to go on from"
                                      : "Saves the setup as a config",
              .unavailable = writing ? "A file is being written." : "",
              .look = ButtonLook::accent})) {
    save(context.app, work);
  }
  ImGui::SameLine();
  const std::string without = parting_->what + " WITHOUT SAVING";
  if (button(without.c_str(), {.tooltip = "What is in no file is lost.", .name = "WITHOUT SAVING"}))
    return go_on(context);
  ImGui::SameLine();
  if (button("CANCEL", {.tooltip = "Everything stays as it is."})) {
    parting_.reset();
    context.close(title());
  }
}

void UnsavedPanel::take_file(PanelContext& context, const UnsavedItem& work) {
  if (const auto file = config_.draw(context.app)) {
    if (!context.app.save_config(*file)) context.open(panel_title::log);
  }
  if (const auto file = checkpoint_.draw(context.app)) {
    context.app.set_active(work.run);
    context.app.start_export(*file, "checkpoint");
  }
}

void UnsavedPanel::draw(PanelContext& context) {
  if (!parting_) return context.close(title());
  if (ImGui::IsWindowAppearing()) saving_ = false;
  const std::optional<UnsavedItem> work = context.app.unsaved_work(parting_->leaves);
  if (!work && saving_) return go_on(context);
  if (!work)
    return context.close(title());  // it was saved or taken back elsewhere: nobody has said that it should go on
  say(work->what, Gui::current().theme().text);
  ImGui::Spacing();
  draw_buttons(context, *work);
  take_file(context, *work);
}

}  // namespace

std::unique_ptr<Panel> make_unsaved_panel(std::optional<Parting>& parting) {
  return std::make_unique<UnsavedPanel>(parting);
}

}  // namespace erg::ui
