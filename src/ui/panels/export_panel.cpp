// EXPORT: the run as a file of every kind.
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Export;
using session::export_formats;
using session::ExportFormat;

namespace {

class ExportPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::export_files; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {560, 560}; }
  void draw(PanelContext& context) override;

 private:
  void draw_formats();
  static void draw_export(Export& running);

  std::size_t format_ = 0;
  FilePopup file_{{.title = "EXPORT TO", .action = "SAVE", .endings = {}, .saving = true}};
};

void ExportPanel::draw_formats() {
  const std::vector<ExportFormat>& formats = export_formats();
  for (std::size_t index = 0; index < formats.size(); ++index) {
    if (ImGui::RadioButton(formats[index].label.c_str(), index == format_)) format_ = index;
    mark(formats[index].key);
    ImGui::Indent();
    explain(formats[index].meaning);
    ImGui::Unindent();
  }
}

void ExportPanel::draw_export(Export& running) {
  const Theme& theme = Gui::current().theme();
  const std::string name = running.path().filename().string();
  switch (running.state()) {
    case Export::State::writing:
      ImGui::ProgressBar(static_cast<float>(running.progress()), {-Gui::current().px(90), 0}, name.c_str());
      mark("progress");
      ImGui::SameLine();
      if (button("STOP", {.tooltip = "Nothing is left of the file.", .size = {-1, 0}})) running.stop();
      break;
    case Export::State::done:
      say("Saved " + running.path().string() + ".", theme.good);
      break;
    case Export::State::stopped:
      explain("Stopped; no file was written.");
      break;
    case Export::State::failed:
      say(running.problem() + " Nothing was written; the run is as it was.", theme.lost);
      break;
  }
}

void ExportPanel::draw(PanelContext& context) {
  session::AppModel& app = context.app;
  if (!app.now().has_runs()) {
    explain("There is nothing to export yet. Open a preset from the gallery, or press CREATE.");
    return;
  }
  draw_formats();
  ImGui::Spacing();
  const ExportFormat& format = export_formats()[format_];
  Export* running = app.running_export();
  const bool busy = running != nullptr && running->state() == Export::State::writing;
  if (button("EXPORT", {.tooltip = "Asks where to, then writes while the run goes on.",
                        .unavailable = busy ? "One file is being written." : "",
                        .look = ButtonLook::accent})) {
    file_.set_endings({format.ending});
    file_.ask(app.settings(),
              app.suggested_name("-" + std::to_string(app.now().step()) + format.suffix + format.ending));
  }
  if (running != nullptr) draw_export(*running);
  if (const auto file = file_.draw(app)) app.start_export(*file, format.key);
}

}  // namespace

std::unique_ptr<Panel> make_export_panel() { return std::make_unique<ExportPanel>(); }

}  // namespace erg::ui
