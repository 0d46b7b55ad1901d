// Colours and measures of the window, dark and light.
#pragma once

#include <imgui.h>

namespace erg::ui {

/// Light text on dark ground, or the other way round.
enum class ThemeKind { dark, light };

/// Colours by what they mean.
struct Theme {
  ThemeKind kind = ThemeKind::dark;
  ImVec4 ground;     ///< behind everything
  ImVec4 panel;      ///< panels, menus
  ImVec4 field;      ///< entries, sliders
  ImVec4 edge;       ///< lines between things
  ImVec4 text;       ///< what is read
  ImVec4 faint;      ///< what is read second: units, explanations
  ImVec4 accent;     ///< the active thing: sand
  ImVec4 on_accent;  ///< text on the accent
  ImVec4 cool;       ///< snow, and the second line of a plot
  ImVec4 good;       ///< what is as it should be
  ImVec4 lost;       ///< what is lost or failed; nothing else is red

  /// The theme of a kind.
  static Theme make(ThemeKind kind);
  /// Colours of lines in a plot, told apart by people who see fewer colours too.
  ImVec4 line(int index) const;
};

/// Text sizes at scale 1, pixels.
inline constexpr float text_size = 15;
inline constexpr float heading_size = 17;

/// Makes ImGui's style that of the theme, for an interface this many times its usual size.
void apply_theme(const Theme& theme, float scale);

}  // namespace erg::ui
