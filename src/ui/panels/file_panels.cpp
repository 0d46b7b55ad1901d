// OPEN and SAVE AS.
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

class OpenPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::open; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {760, 480}; }
  void draw(PanelContext& context) override {
    const auto file = browser_.draw(context.app);
    if (file) {
      context.leave("OPEN", session::Leaves::everything, [&context, path = *file] {
        if (!context.app.open_and_play(path)) context.open(panel_title::log);  // it says what is wrong with the file
      });
    }
    if (file || browser_.cancelled()) context.close(title());
  }

 private:
  FileBrowser browser_{{.title = "OPEN", .action = "OPEN", .endings = {".json", ".checkpoint"}}};
};

class SavePanel final : public Panel {
 public:
  const char* title() const override { return panel_title::save; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {760, 480}; }
  void draw(PanelContext& context) override {
    const bool opened = ImGui::IsWindowAppearing();
    if (opened) browser_.start(context.app.settings(), context.app.suggested_name(".json"));
    const auto file = browser_.draw(context.app);
    if (file && !context.app.save_config(*file)) context.open(panel_title::log);
    if (file || browser_.cancelled()) context.close(title());
  }

 private:
  FileBrowser browser_{{.title = "SAVE AS", .action = "SAVE", .endings = {".json"}, .saving = true}};
};

}  // namespace

std::unique_ptr<Panel> make_open_panel() { return std::make_unique<OpenPanel>(); }
std::unique_ptr<Panel> make_save_panel() { return std::make_unique<SavePanel>(); }

}  // namespace erg::ui
