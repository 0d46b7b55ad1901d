// KEYS and ABOUT.
#include <utility>

#include "studio/studio.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace erg {
namespace {

using KeyLine = std::pair<const char*, const char*>;

constexpr KeyLine run_keys[] = {{"Space", "play and pause"}, {".", "one step"}, {"R", "reset to step 0"}};
constexpr KeyLine view_keys[] = {{"drag", "turn the view"},
                                 {"right drag", "move the land along"},
                                 {"wheel", "nearer and farther, to the cursor"},
                                 {"F", "frame all of the land"},
                                 {"1 to 4", "views: top, oblique, block, side"}};
constexpr KeyLine file_keys[] = {{"G", "gallery"},          {"Ctrl+O", "open"},  {"Ctrl+S", "save"},
                                 {"Ctrl+E", "export"},      {"Ctrl+Z", "undo"},  {"Ctrl+Y", "redo"},
                                 {"F12", "save a picture"}, {"F1", "these keys"}};
constexpr KeyLine edit_keys[] = {{"Shift while dragging", "curve points and the wind dial snap"},
                                 {"double click on a slider", "type a number"},
                                 {"Escape", "close a dialog"}};

template <std::size_t count>
void draw_keys(const char* title, const KeyLine (&keys)[count]) {
  heading(title);
  if (!ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, Gui::current().px(190));
  ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
  for (const auto& [key, meaning] : keys) {
    ImGui::TableNextColumn();
    ImGui::TextColored(Gui::current().theme().accent, "%s", key);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(meaning);
  }
  ImGui::EndTable();
  ImGui::Spacing();
}

class KeysPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::keys; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {520, 560}; }
  void draw(Desk&) override {
    draw_keys("Run", run_keys);
    draw_keys("View", view_keys);
    draw_keys("Files", file_keys);
    draw_keys("Editing", edit_keys);
  }
};

class AboutPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::about; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {520, 300}; }
  void draw(Desk& desk) override {
    heading("Erg " + desk.studio.provenance().version);
    say("Sand dunes and wind-blown snow, grown on a grid.", Gui::current().theme().text);
    ImGui::Spacing();
    explain(
        "Heights are whole slabs, so mass is kept exactly; random numbers are a function of seed, step and cell, so "
        "the "
        "same seed grows the same dunes on any number of threads.");
    ImGui::Spacing();
    explain("Each model names its publication in the tooltip of SETUP / model. MIT licence.");
    explain("Made with Dear ImGui, freeglut, GLEW, Eigen, nlohmann JSON, libpng, zlib and stb.");
  }
};

}  // namespace

std::unique_ptr<Panel> make_keys_panel() { return std::make_unique<KeysPanel>(); }
std::unique_ptr<Panel> make_about_panel() { return std::make_unique<AboutPanel>(); }

}  // namespace erg
