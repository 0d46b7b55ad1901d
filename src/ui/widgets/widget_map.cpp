#include "ui/widgets/widget_map.h"

#include <cmath>

namespace erg::ui {

bool WidgetPlace::operator==(const WidgetPlace& other) const {
  return name == other.name && low.x == other.low.x && low.y == other.low.y && high.x == other.high.x &&
         high.y == other.high.y && enabled == other.enabled;
}

void WidgetMap::begin_frame() {
  scopes_.clear();
  places_.clear();
}

void WidgetMap::enter(std::string_view scope) {
  scopes_.push_back((scopes_.empty() ? std::string() : scopes_.back()) + std::string(scope) + "/");
}

void WidgetMap::leave() { scopes_.pop_back(); }

void WidgetMap::add(std::string_view label, ImVec2 low, ImVec2 high, bool enabled) {
  places_.push_back({(scopes_.empty() ? std::string() : scopes_.back()) + std::string(label), low, high, enabled});
}

std::optional<WidgetPlace> WidgetMap::find(std::string_view name) const {
  const std::string ending = "/" + std::string(name);
  std::optional<WidgetPlace> found;
  for (const WidgetPlace& place : places_) {
    if (place.name == name) return place;
    const bool ends = place.name.size() > ending.size() &&
                      place.name.compare(place.name.size() - ending.size(), ending.size(), ending) == 0;
    if (ends && !found) found = place;
  }
  return found;
}

std::string WidgetMap::text() const {
  std::string lines;
  const auto pixel = [](float place) { return std::to_string(std::lround(place)); };
  for (const WidgetPlace& place : places_) {
    lines += place.name + "\t" + pixel(place.low.x) + "\t" + pixel(place.low.y) + "\t" + pixel(place.high.x) + "\t" +
             pixel(place.high.y) + "\t" + (place.enabled ? "on" : "off") + "\n";
  }
  return lines;
}

}  // namespace erg::ui
