// Everything that the menus and keys can do, in one table: menus, keys and the help are made from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/panels/panel.h"

namespace erg::ui {

/// A thing to be done from a menu or with a key.
struct MenuAction {
  std::string menu;   ///< "File"
  std::string label;  ///< in the menu, and in the widget map: "menu File/Open..."
  int key = 0;        ///< place in ImGuiIO::KeysDown (ui/widgets/gui.h: keys); 0: none
  bool ctrl = false;
  std::function<void()> act;
  std::function<std::string()> unavailable = {};  ///< why not now; "" or no function: it can be done
  std::function<bool()> checked = {};             ///< for what is on or off
  bool line_above = false;
};

/// "Ctrl+O", "Space", "F12"; "" without a key.
std::string shortcut_text(const MenuAction& action);

/// The menus, in the order in which their names first appear.
void draw_menus(const std::vector<MenuAction>& actions);

/// Does what the keys pressed in this frame ask for. Letters and space type where something is being typed.
void press_keys(const std::vector<MenuAction>& actions);

/// The keys of the table, and those of the terrain.
std::vector<KeyHelp> key_help(const std::vector<MenuAction>& actions);

}  // namespace erg::ui
