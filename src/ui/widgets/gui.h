// ImGui with Erg's fonts and colours: everything that panels need to draw themselves, with no window behind it.
#pragma once

#include <imgui.h>

#include <functional>
#include <list>
#include <set>
#include <string>
#include <string_view>

#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_map.h"

namespace erg::ui {

/// Places of keys in ImGuiIO::KeysDown: letters as capitals and other characters as themselves; the rest from 256 on.
namespace keys {
inline constexpr int backspace = 8, tab = 9, enter = 13, escape = 27, space = 32, remove = 127;
inline constexpr int left = 256, right = 257, up = 258, down = 259, page_up = 260, page_down = 261, home = 262,
                     end = 263, insert = 264;
inline constexpr int function = 270;  ///< F1 is function + 1
}  // namespace keys

/// An ImGui context, which is current from its making on. Needs no OpenGL: what it draws is data.
class Gui {
 public:
  explicit Gui(ThemeKind theme = ThemeKind::dark, float scale = 1);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// The one whose context is current.
  static Gui& current();

  /// Between frames only; takes hold at once.
  void set_theme(ThemeKind theme);
  /// The same; text of another size needs a new texture (`font_version`).
  void set_scale(float scale);

  const Theme& theme() const { return theme_; }
  /// Times the usual size.
  float scale() const { return scale_; }
  /// A length at scale 1 in pixels of this interface.
  float px(float length) const { return length * scale_; }
  ImFont* heading_font() const { return heading_font_; }
  WidgetMap& widgets() { return widgets_; }
  /// Counts up whenever the texture of the fonts has to be uploaded again.
  int font_version() const { return font_version_; }

  /// Says that this text, UTF-8, is to be drawn: letters that are not loaded yet are from the next frame on, where any
  /// font of the machine has them. Cheap for letters that are there. For words that come from people and files.
  void need(std::string_view text);
  /// Letters that no font has, since this was last asked: each with its number in Unicode; "" when there are none.
  std::string take_missing_letters();

  /// Draws one frame of this size in pixels; `seconds` since the last one.
  void frame(ImVec2 size, float seconds, const std::function<void()>& draw);

 private:
  void load_fonts();
  void load_more_letters(const ImFontConfig& like);
  void note_missing_letters();

  ImGuiContext* context_ = nullptr;
  Theme theme_;
  float scale_ = 1;
  ImFont* heading_font_ = nullptr;
  WidgetMap widgets_;
  int font_version_ = 0;
  FontFinder fonts_;
  std::list<ImVector<ImWchar>> font_ranges_;
  std::set<char32_t> more_letters_;  ///< beyond those that are always loaded
  std::set<char32_t> no_font_has_;
  std::string missing_;  ///< of those, what nobody was told yet
  bool fonts_stale_ = false;
};

}  // namespace erg::ui
