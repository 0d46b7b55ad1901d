// KEYS and ABOUT.
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

/// The keys of one menu; `first` is the place of its first in the list. Returns the place behind its last.
std::size_t draw_keys(const std::vector<KeyHelp>& keys, std::size_t first) {
  const std::string& menu = keys[first].menu;
  heading(menu);
  std::size_t next = first;
  const bool open = ImGui::BeginTable(menu.c_str(), 2);
  if (open) {
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, Gui::current().px(190));
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  }
  for (; next < keys.size() && keys[next].menu == menu; ++next) {
    if (!open) continue;
    ImGui::TableNextColumn();
    say(keys[next].keys, Gui::current().theme().accent);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", keys[next].what.c_str());
  }
  if (open) ImGui::EndTable();
  ImGui::Spacing();
  return next;
}

class KeysPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::keys; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {520, 700}; }
  void draw(PanelContext& context) override {
    for (std::size_t next = 0; next < context.keys.size();) next = draw_keys(context.keys, next);
    explain("In the panels: Shift while dragging snaps curve points and the wind's dial.");
  }
};

class AboutPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::about; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {520, 210}; }
  void draw(PanelContext& context) override {
    heading("Erg " + context.app.provenance().version);
    say("Sand dunes and wind-blown snow, grown on a grid.", Gui::current().theme().text);
    ImGui::Spacing();
    explain(
        "Heights are whole slabs, so mass is kept exactly; random numbers are a function of seed, step and cell, so "
        "the same seed grows the same dunes on any number of threads.");
    ImGui::Spacing();
    explain("Each model names its publication in the tooltip of SETUP / model. MIT licence.");
    explain("Made with Dear ImGui, freeglut, GLEW, Eigen, nlohmann JSON, libpng, zlib and stb.");
  }
};

}  // namespace

std::unique_ptr<Panel> make_keys_panel() { return std::make_unique<KeysPanel>(); }
std::unique_ptr<Panel> make_about_panel() { return std::make_unique<AboutPanel>(); }

}  // namespace erg::ui
