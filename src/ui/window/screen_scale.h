// How large an interface should be on this screen, by what the desktop says and by the monitor itself.
#pragma once

#include <vector>

struct _XDisplay;  // as X names it

namespace erg::ui {

/// One of the monitors that a screen is made of.
struct Monitor {
  int left = 0;  ///< pixels, within the screen
  int top = 0;
  int width = 0;
  int height = 0;
  int millimetres = 0;  ///< its height; 0: unknown
  bool primary = false;
};

/// The monitors of a display; the whole screen as one where X does not tell them apart. At least one.
std::vector<Monitor> monitors_of(_XDisplay* display);
/// The one in which this point lies, or else the primary one, or the first. `monitors` must not be empty.
const Monitor& monitor_at(const std::vector<Monitor>& monitors, int x, int y);

/// What the desktop's resource Xft.dpi says, dots an inch; 0: nothing.
double desktop_dpi(_XDisplay* display);

/// How many times its usual size an interface is made, in quarters, 1 to 3. A desktop's own setting counts, 96 dots an
/// inch being 1. Without one it is what the monitor's pixels from top to bottom (1080: 1) and their closeness (96 an
/// inch: 1) both ask for, so neither two monitors above each other nor a small sharp one enlarge the letters by
/// themselves.
double suggested_scale(double desktop_dpi, const Monitor& monitor);

}  // namespace erg::ui
