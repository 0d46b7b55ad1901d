// The small things that all panels are made of. Each of them tells the widget map where it lies, under its label and
// within the panel's scope; whoever draws with plain ImGui calls `mark` after the widget.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.h"
#include "ui/widgets/gui.h"

namespace erg::ui {

/// Names the last ImGui item in the widget map.
void mark(std::string_view name);
/// Names a rectangle of the screen in the widget map: parts of a plot that can be grabbed.
void mark(std::string_view name, ImVec2 low, ImVec2 high);

/// Everything named while this lives stands under "scope/"; ImGui's ids too.
class WidgetScope {
 public:
  explicit WidgetScope(std::string_view name);
  ~WidgetScope();
  WidgetScope(const WidgetScope&) = delete;
  WidgetScope& operator=(const WidgetScope&) = delete;
};

/// Explains the last item while the pointer rests on it, disabled or not. Wrapped; "" says nothing.
void tooltip(std::string_view text);

/// A panel's or section's heading, in capitals as given, with a line under it.
void heading(std::string_view text);
/// A heading that folds what stands below it away. True while open.
bool section(const char* label, bool open_at_first = true);
/// A wrapped line of explanation in the faint colour.
void explain(std::string_view text);
/// A wrapped line in a colour.
void say(std::string_view text, const ImVec4& colour);

/// How much a button asks to be pressed.
enum class ButtonLook {
  plain,
  accent,  ///< the one thing that should be done next
  quiet    ///< without a frame until the pointer is on it
};
/// What a button is besides its label.
struct ButtonInfo {
  std::string_view tooltip = {};
  /// Why it cannot be pressed now, shown in its tooltip; "" when it can.
  std::string_view unavailable = {};
  /// In the widget map; "": as the label.
  std::string_view name = {};
  ButtonLook look = ButtonLook::plain;
  ImVec2 size = {0, 0};  ///< pixels; 0: as the label needs, -1: all that is left
};
/// A button; `label` may hold an ImGui id after "##".
bool button(const char* label, const ButtonInfo& info = {});
/// The width of one of so many buttons that share the rest of a line, pixels.
float share_of_width(int count);

/// What a row of a panel says about its value. A row is: label, entry with unit, dot when changed that resets it.
struct Row {
  std::string label;
  std::string unit = {};
  std::string tooltip = {};
  bool changed = false;            ///< shows the dot, and the reset button
  bool needs_new_terrain = false;  ///< marked: takes hold with CREATE only
  std::string unavailable = {};    ///< why it cannot be changed now; "": it can
};

/// What happened to a row in this frame.
enum class RowEvent { none, changed, reset };

/// Numbers are sliders; a double click (or Ctrl and a click) opens them for typing. What is typed is held to the range.
/// Ranges of more than three powers of ten run logarithmically; integers over 100 000 and numbers without a range
/// (minimum == maximum) are typed only.
RowEvent real_row(const Row& row, double& value, double minimum, double maximum);
RowEvent integer_row(const Row& row, std::int64_t& value, std::int64_t minimum, std::int64_t maximum);
RowEvent switch_row(const Row& row, bool& value);
RowEvent choice_row(const Row& row, std::string& value, std::span<const std::string> choices);
/// Changed with every letter.
RowEvent text_row(const Row& row, std::string& value);

/// The row that a declaration asks for: label, unit, range, and a tooltip with meaning, range, default and source.
/// On RowEvent::reset the value is already the default.
RowEvent parameter_row(const Parameter& parameter, ParameterValue& value, bool needs_new_terrain = false,
                       std::string unavailable = {});
/// The tooltip of a declaration.
std::string parameter_tooltip(const Parameter& parameter);

}  // namespace erg::ui
