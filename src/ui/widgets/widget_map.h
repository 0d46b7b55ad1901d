// Where every widget of the last frame lay, by name: how tests find what they click.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace erg::ui {

/// One widget on the screen.
struct WidgetPlace {
  std::string name;  ///< its panel and label: "SETUP/model"
  ImVec2 low;        ///< left upper corner, pixels
  ImVec2 high;       ///< right lower corner
  bool enabled = true;

  ImVec2 middle() const { return {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}; }
  bool operator==(const WidgetPlace& other) const;
};

/// All of a frame.
class WidgetMap {
 public:
  /// Forgets the last frame.
  void begin_frame();
  /// What is added until `leave` stands under "scope/".
  void enter(std::string_view scope);
  void leave();
  /// Adds a widget by its label and its corners in pixels.
  void add(std::string_view label, ImVec2 low, ImVec2 high, bool enabled);

  const std::vector<WidgetPlace>& places() const { return places_; }
  /// The widget of this whole name, else the first whose name ends in "/" + name.
  std::optional<WidgetPlace> find(std::string_view name) const;
  /// One line a widget: name, left, top, right, bottom, "on" or "off", with tabs between.
  std::string text() const;

 private:
  std::vector<std::string> scopes_;
  std::vector<WidgetPlace> places_;
};

}  // namespace erg::ui
