#include "ui/window/actions.h"

#include <algorithm>

#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

std::string key_name(int key) {
  if (key > keys::function && key <= keys::function + 12) return "F" + std::to_string(key - keys::function);
  switch (key) {
    case keys::space:
      return "Space";
    case keys::enter:
      return "Enter";
    case keys::tab:
      return "Tab";
    case keys::escape:
      return "Esc";
    default:
      return {static_cast<char>(key)};
  }
}

std::string why_not(const MenuAction& action) { return action.unavailable ? action.unavailable() : std::string(); }

void draw_item(const MenuAction& action) {
  if (action.line_above) ImGui::Separator();
  const std::string reason = why_not(action);
  const bool checked = action.checked && action.checked();
  if (ImGui::MenuItem(action.label.c_str(), shortcut_text(action).c_str(), checked, reason.empty())) action.act();
  mark(action.label);
  tooltip(reason);
}

}  // namespace

std::string shortcut_text(const MenuAction& action) {
  if (action.key == 0) return {};
  return (action.ctrl ? "Ctrl+" : "") + key_name(action.key);
}

void draw_menus(const std::vector<MenuAction>& actions) {
  std::vector<std::string> menus;
  for (const MenuAction& action : actions) {
    if (std::find(menus.begin(), menus.end(), action.menu) == menus.end()) menus.push_back(action.menu);
  }
  for (const std::string& menu : menus) {
    const bool open = ImGui::BeginMenu(menu.c_str());
    mark("menu " + menu);
    if (!open) continue;
    {
      const WidgetScope scope("menu " + menu);
      for (const MenuAction& action : actions) {
        if (action.menu == menu) draw_item(action);
      }
    }
    ImGui::EndMenu();
  }
}

void press_keys(const std::vector<MenuAction>& actions) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const MenuAction& action : actions) {
    if (action.key == 0 || action.ctrl != io.KeyCtrl || !ImGui::IsKeyPressed(action.key, false)) continue;
    const bool types = action.key < keys::left && (!action.ctrl || action.key == 'Z' || action.key == 'Y');
    if (io.WantTextInput && types) continue;
    if (why_not(action).empty()) action.act();
  }
}

std::vector<KeyHelp> key_help(const std::vector<MenuAction>& actions) {
  std::vector<KeyHelp> help;
  for (const MenuAction& action : actions) {
    if (action.key != 0) help.push_back({action.menu, shortcut_text(action), action.label});
  }
  const std::vector<KeyHelp> terrain{
      {"Terrain", "left drag", "turn the terrain (or use the tool that a panel has switched on)"},
      {"Terrain", "right drag, middle drag, Shift+left drag", "shift the terrain"},
      {"Terrain", "Ctrl+left drag", "look around from where you stand"},
      {"Terrain", "wheel", "come nearer to what is under the pointer, or go away"},
      {"Terrain", "W A S D", "fly forwards, left, back, right"},
      {"Terrain", "Q E", "fly down, up"},
      {"Entries", "double click, Ctrl+click", "type a number into a slider"},
      {"Entries", "Esc", "close the menu, list or dialog on top"},
  };
  help.insert(help.end(), terrain.begin(), terrain.end());
  return help;
}

}  // namespace erg::ui
