// OPEN and SAVE AS.
#include "studio/studio.h"
#include "ui/file_browser.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace erg {
namespace {

/// A name for the file of a config: its own, or its title without what names cannot hold.
std::string suggested_name(Studio& studio) {
  if (!studio.file().empty()) return studio.file().filename().string();
  std::string name;
  for (const char letter : studio.setup().config().title) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    const bool capital = letter >= 'A' && letter <= 'Z';
    if (plain || capital) {
      name += capital ? static_cast<char>(letter - 'A' + 'a') : letter;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  return (name.empty() ? "dunes" : name) + ".json";
}

class OpenPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::open; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {760, 480}; }
  void draw(Desk& desk) override {
    const auto file = browser_.draw(desk.studio);
    if (file && !desk.studio.open(*file)) desk.open(panel_title::log);  // the log says what is wrong with it
    if (file || browser_.cancelled()) desk.close(title());
  }

 private:
  FileBrowser browser_{{.title = "OPEN", .action = "OPEN", .endings = {".json", ".checkpoint"}}};
};

class SavePanel final : public Panel {
 public:
  const char* title() const override { return panel_title::save; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {760, 480}; }
  void draw(Desk& desk) override {
    const bool opened = ImGui::IsWindowAppearing();
    if (opened) browser_.start(desk.studio.settings(), suggested_name(desk.studio));
    const auto file = browser_.draw(desk.studio);
    if (file && !desk.studio.save_config(*file)) desk.open(panel_title::log);
    if (file || browser_.cancelled()) desk.close(title());
  }

 private:
  FileBrowser browser_{{.title = "SAVE AS", .action = "SAVE", .endings = {".json"}, .saving = true}};
};

}  // namespace

std::unique_ptr<Panel> make_open_panel() { return std::make_unique<OpenPanel>(); }
std::unique_ptr<Panel> make_save_panel() { return std::make_unique<SavePanel>(); }

}  // namespace erg
