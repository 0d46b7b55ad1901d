#include "ui/window/screen_scale.h"

#include <X11/Xlib.h>
#include <X11/Xresource.h>
#include <X11/extensions/Xrandr.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace erg::ui {
namespace {

constexpr double usual_dpi = 96;
constexpr double usual_height = 1080;
constexpr double millimetres_of_inch = 25.4;

Monitor whole_screen(::Display* display) {
  const int screen = DefaultScreen(display);
  return {0, 0, DisplayWidth(display, screen), DisplayHeight(display, screen), DisplayHeightMM(display, screen), true};
}

bool tells_monitors(::Display* display) {
  int ignored = 0;
  int major = 0;
  int minor = 0;
  if (XRRQueryExtension(display, &ignored, &ignored) == 0) return false;
  return XRRQueryVersion(display, &major, &minor) != 0 && (major > 1 || minor >= 5);
}

}  // namespace

std::vector<Monitor> monitors_of(_XDisplay* display) {
  std::vector<Monitor> found;
  int count = 0;
  XRRMonitorInfo* const told =
      tells_monitors(display) ? XRRGetMonitors(display, DefaultRootWindow(display), True, &count) : nullptr;
  for (int i = 0; i < count && told != nullptr; ++i) {
    const XRRMonitorInfo& one = told[i];
    found.push_back({one.x, one.y, one.width, one.height, one.mheight, one.primary != 0});
  }
  if (told != nullptr) XRRFreeMonitors(told);
  if (found.empty()) found.push_back(whole_screen(display));
  return found;
}

const Monitor& monitor_at(const std::vector<Monitor>& monitors, int x, int y) {
  const auto holds = [&](const Monitor& one) {
    return x >= one.left && y >= one.top && x < one.left + one.width && y < one.top + one.height;
  };
  auto found = std::ranges::find_if(monitors, holds);
  if (found == monitors.end()) found = std::ranges::find_if(monitors, &Monitor::primary);
  return found == monitors.end() ? monitors.front() : *found;
}

double desktop_dpi(_XDisplay* display) {
  const char* const resources = XResourceManagerString(display);
  if (resources == nullptr) return 0;
  XrmInitialize();
  const XrmDatabase database = XrmGetStringDatabase(resources);
  if (database == nullptr) return 0;
  char* kind = nullptr;
  XrmValue value{};
  const bool there = XrmGetResource(database, "Xft.dpi", "Xft.Dpi", &kind, &value) != 0 && value.addr != nullptr;
  const double dpi = there ? std::strtod(value.addr, nullptr) : 0;
  XrmDestroyDatabase(database);
  return std::isfinite(dpi) && dpi > 0 ? dpi : 0;
}

double suggested_scale(double desktop_dpi, const Monitor& monitor) {
  double wanted = desktop_dpi / usual_dpi;
  if (desktop_dpi <= 0) {
    wanted = monitor.height / usual_height;
    if (monitor.millimetres > 0) {
      wanted = std::min(wanted, monitor.height / (monitor.millimetres / millimetres_of_inch) / usual_dpi);
    }
  }
  return std::clamp(std::round(4 * wanted) / 4, 1.0, 3.0);
}

}  // namespace erg::ui
