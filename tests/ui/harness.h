// The interface without a window: frames on demand, a hand that clicks and types, and widgets found by name.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "ui/widgets/gui.h"

namespace erg::test {

class UiHarness {
 public:
  /// `draw` makes one frame of the interface, ImGui windows included.
  explicit UiHarness(std::function<void()> draw, ImVec2 size = {1280, 800}, float scale = 1);

  ui::Gui& gui() { return gui_; }
  /// Draws so many frames, each 1/60 s.
  void frames(int count = 1);

  bool has(const std::string& name) const { return gui_.widgets().find(name).has_value(); }
  /// The widget of this name (see WidgetMap::find). Throws std::runtime_error with all names when it is not there.
  ui::WidgetPlace place(const std::string& name) const;

  void move(ImVec2 point);
  void press(int button = 0);
  void release(int button = 0);
  void click(ImVec2 point, int button = 0);
  /// Clicks the middle of a widget.
  void click(const std::string& name);
  void double_click(const std::string& name);
  /// Presses at one point, moves to another in steps, releases.
  void drag(ImVec2 from, ImVec2 to, int steps = 4);
  /// Drags within a widget: from and to are shares of its width and height.
  void drag(const std::string& name, ImVec2 from, ImVec2 to);
  void scroll(float lines);
  /// Types characters.
  void type(const std::string& text);
  /// Presses and releases a key, by its place (ui/widgets/gui.h: keys).
  void key(int place);
  /// The same for a key that is named by its character, with Ctrl held or not.
  void shortcut(char letter, bool ctrl = true);
  /// Replaces what an entry holds: opens a slider for typing, selects all, types, Enter.
  void enter(const std::string& name, const std::string& text);

  /// The last frame as a PNG, drawn without a window, for looking at.
  void save_png(const std::filesystem::path& path);

 private:
  mutable ui::Gui gui_;
  std::function<void()> draw_;
  ImVec2 size_;
};

}  // namespace erg::test
