#include "ui/widgets/widgets.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/number_text.h"
#include "ui/widgets/curve_editor.h"
#include "ui/widgets/row_table.h"
#include "ui/widgets/typed_number.h"

namespace erg::ui {
namespace {

constexpr float label_share = 0.46f;      // of a row's width
constexpr float entry_end = 0.97f;        // leaves room for the reset button
constexpr double wide_range = 1000;       // largest / smallest from which a slider runs logarithmically
constexpr std::int64_t sliding = 100000;  // whole numbers beyond are typed

// The part of a label that is shown.
std::string_view shown(std::string_view label) { return label.substr(0, label.find("##")); }

float reset_width() { return ImGui::GetFrameHeight(); }

// Label on the left; afterwards the cursor and the width stand for the entry.
void begin_row(const Row& row) {
  const Theme& theme = Gui::current().theme();
  ImGui::PushID(row.label.c_str());
  const float left = ImGui::GetCursorPosX();
  const float whole = ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, row.unavailable.empty() ? theme.text : theme.faint);
  const float wide = whole * label_share - ImGui::GetStyle().ItemSpacing.x;
  const float text_wide = ImGui::CalcTextSize(row.label.c_str()).x;
  ImGui::TextUnformatted(row.label.c_str());
  ImGui::PopStyleColor();
  tooltip(row.tooltip);
  // A long label has a line of its own.
  if (text_wide <= wide) ImGui::SameLine();
  ImGui::SetCursorPosX(left + whole * label_share);
  ImGui::SetNextItemWidth(whole * (entry_end - label_share) - reset_width());
  ImGui::BeginDisabled(!row.unavailable.empty());
}

// Dot and reset button behind the entry.
RowEvent end_row(const Row& row, RowEvent event) {
  const Gui& gui = Gui::current();
  mark(row.label);
  ImGui::EndDisabled();
  tooltip(row.unavailable.empty() ? row.tooltip : row.tooltip + "\n\n" + row.unavailable);
  const bool can_reset = row.changed && row.unavailable.empty();
  if (row.changed) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - reset_width());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = reset_width();
    ImGui::BeginDisabled(!can_reset);
    if (ImGui::InvisibleButton("reset", {side, side})) event = RowEvent::reset;
    ImGui::EndDisabled();
    mark(row.label + " reset");
    const bool hot = can_reset && ImGui::IsItemHovered();
    const ImVec2 middle{corner.x + 0.5f * side, corner.y + 0.5f * side};
    const ImVec4& tone = row.needs_new_terrain ? gui.theme().cool : gui.theme().accent;
    if (hot) {
      const char* const arrow = "\u21ba";
      const ImVec2 size = ImGui::CalcTextSize(arrow);
      ImGui::GetWindowDrawList()->AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y},
                                          ImGui::GetColorU32(tone), arrow);
    } else {
      ImGui::GetWindowDrawList()->AddCircleFilled(middle, gui.px(3), ImGui::GetColorU32(tone));
    }
    tooltip(row.needs_new_terrain ? "Changed; takes hold with CREATE. Press to go back to the default."
                                  : "Changed. Press to go back to the default.");
  }
  ImGui::PopID();
  return event;
}

// Sliders open for typing with a double click too, which ImGui has for drags only: Ctrl and a click does it there.
class TypingOnDoubleClick {
 public:
  TypingOnDoubleClick() : ctrl_(ImGui::GetIO().KeyCtrl), modifiers_(ImGui::GetIO().KeyMods) {
    ImGuiIO& io = ImGui::GetIO();
    if (!io.MouseDoubleClicked[0]) return;
    io.KeyCtrl = true;
    io.KeyMods |= ImGuiKeyModFlags_Ctrl;
  }
  ~TypingOnDoubleClick() {
    ImGui::GetIO().KeyCtrl = ctrl_;
    ImGui::GetIO().KeyMods = modifiers_;
  }
  TypingOnDoubleClick(const TypingOnDoubleClick&) = delete;
  TypingOnDoubleClick& operator=(const TypingOnDoubleClick&) = delete;

 private:
  bool ctrl_;
  ImGuiKeyModFlags modifiers_;
};

ImGuiSliderFlags slider_flags(double minimum, double maximum) {
  const bool wide = minimum >= 0 && maximum > wide_range * std::max(minimum, 1.0 / wide_range);
  return ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
}

// How a number is shown in its entry: with its unit.
std::string with_unit(const char* number, const std::string& unit) {
  std::string format = number;
  if (!unit.empty()) format += " ";
  for (const char letter : unit_text(unit)) format += letter == '%' ? std::string("%%") : std::string(1, letter);
  return format;
}

void add_to_map(std::string_view name, ImVec2 low, ImVec2 high, ImGuiItemFlags flags) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImRect& clip = context.CurrentWindow->ClipRect;
  if (!clip.Overlaps({low, high})) return;
  const ImVec2 seen_low{std::max(low.x, clip.Min.x), std::max(low.y, clip.Min.y)};
  const ImVec2 seen_high{std::min(high.x, clip.Max.x), std::min(high.y, clip.Max.y)};
  Gui::current().widgets().add(shown(name), seen_low, seen_high, (flags & ImGuiItemFlags_Disabled) == 0);
}

/// A curve of points under its label; a row to itself.
RowEvent curve_row(const Row& row, const Parameter& parameter, PiecewiseLinear& curve) {
  ImGui::TextUnformatted(row.label.c_str());
  mark(row.label);
  tooltip(row.tooltip);
  const WidgetScope scope(row.label);
  ImGui::BeginDisabled(!row.unavailable.empty());
  const std::vector<CurvePoint>& standard = std::get<PiecewiseLinear>(parameter.default_value).vertices;
  CurveFrame frame;
  frame.x_label = parameter.x_label;
  frame.y_label = unit_text(parameter.unit);
  frame.x = {std::min(standard.front().x, curve.vertices.front().x),
             std::max(standard.back().x, curve.vertices.back().x)};
  frame.y = {parameter.minimum, parameter.maximum};
  frame.height = Gui::current().px(170);
  const bool changed = edit_points("points", curve.vertices, standard, frame);
  ImGui::EndDisabled();
  return changed ? RowEvent::changed : RowEvent::none;
}

/// A curve between two values, bent by its control points.
RowEvent bezier_row(const Row& row, BezierCurve& curve) {
  ImGui::TextUnformatted(row.label.c_str());
  tooltip(row.tooltip);
  CurveFrame frame;
  frame.x = {0, 1};
  frame.y = {0, 1};
  frame.height = Gui::current().px(170);
  return edit_curve(row.label.c_str(), curve, frame) ? RowEvent::changed : RowEvent::none;
}

}  // namespace

void mark(std::string_view name) {
  Gui::current().need(name);
  const ImGuiLastItemData& item = ImGui::GetCurrentContext()->LastItemData;
  add_to_map(name, item.Rect.Min, item.Rect.Max, item.InFlags);
}

void mark(std::string_view name, ImVec2 low, ImVec2 high) {
  add_to_map(name, low, high, ImGui::GetCurrentContext()->CurrentItemFlags);
}

WidgetScope::WidgetScope(std::string_view name) {
  Gui::current().widgets().enter(name);
  ImGui::PushID(name.data(), name.data() + name.size());
}

WidgetScope::~WidgetScope() {
  ImGui::PopID();
  Gui::current().widgets().leave();
}

void tooltip(std::string_view text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (ImGui::GetCurrentContext()->HoveredIdTimer < 0.4f && ImGui::GetItemID() != 0) return;
  Gui::current().need(text);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(Gui::current().px(360));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void heading(std::string_view text) {
  const Gui& gui = Gui::current();
  ImGui::PushFont(gui.heading_font());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
  ImGui::Separator();
}

bool section(const char* label, bool open_at_first) {
  ImGui::SetNextItemOpen(open_at_first, ImGuiCond_FirstUseEver);
  ImGui::PushFont(Gui::current().heading_font());
  const bool open = ImGui::CollapsingHeader(label);
  ImGui::PopFont();
  mark(label);
  return open;
}

void explain(std::string_view text) { say(text, Gui::current().theme().faint); }

void say(std::string_view text, const ImVec4& colour) {
  Gui::current().need(text);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool button(const char* label, const ButtonInfo& info) {
  const Theme& theme = Gui::current().theme();
  int colours = 0;
  const auto set = [&](ImGuiCol which, ImVec4 colour) {
    ImGui::PushStyleColor(which, colour);
    ++colours;
  };
  if (info.look == ButtonLook::accent && info.unavailable.empty()) {
    set(ImGuiCol_Button, theme.accent);
    set(ImGuiCol_ButtonHovered, {theme.accent.x, theme.accent.y, theme.accent.z, 0.85f});
    set(ImGuiCol_ButtonActive, {theme.accent.x, theme.accent.y, theme.accent.z, 0.7f});
    set(ImGuiCol_Text, theme.on_accent);
  } else if (info.look == ButtonLook::quiet) {
    set(ImGuiCol_Button, {0, 0, 0, 0});
  }
  ImGui::BeginDisabled(!info.unavailable.empty());
  const bool pressed = ImGui::Button(label, info.size);
  mark(info.name.empty() ? std::string_view(label) : info.name);
  ImGui::EndDisabled();
  ImGui::PopStyleColor(colours);
  tooltip(info.unavailable.empty()
              ? std::string(info.tooltip)
              : std::string(info.tooltip) + (info.tooltip.empty() ? "" : "\n\n") + std::string(info.unavailable));
  return pressed;
}

float share_of_width(int count) {
  const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x;
  return (ImGui::GetContentRegionAvail().x - gaps) / static_cast<float>(count);
}

RowEvent real_row(const Row& row, double& value, double minimum, double maximum) {
  begin_row(row);
  const TypingOnDoubleClick typing;
  take_typed_number("##value");
  double entered = value;
  bool changed = false;
  if (minimum < maximum) {
    changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &entered, &minimum, &maximum,
                                  with_unit("%.4g", row.unit).c_str(), slider_flags(minimum, maximum));
  } else {
    changed = ImGui::InputDouble("##value", &entered, 0, 0, with_unit("%.6g", row.unit).c_str());
  }
  changed = changed && entered != value && std::isfinite(entered);
  if (changed) value = entered;
  return end_row(row, changed ? RowEvent::changed : RowEvent::none);
}

RowEvent integer_row(const Row& row, std::int64_t& value, std::int64_t minimum, std::int64_t maximum) {
  begin_row(row);
  const TypingOnDoubleClick typing;
  take_typed_number("##value");
  std::int64_t entered = value;
  if (minimum < maximum && maximum - minimum <= sliding && minimum > -sliding) {
    ImGui::SliderScalar("##value", ImGuiDataType_S64, &entered, &minimum, &maximum, with_unit("%lld", row.unit).c_str(),
                        slider_flags(static_cast<double>(minimum), static_cast<double>(maximum)));
  } else {
    ImGui::InputScalar("##value", ImGuiDataType_S64, &entered, nullptr, nullptr, with_unit("%lld", row.unit).c_str());
    if (minimum < maximum) entered = std::clamp(entered, minimum, maximum);
  }
  const bool changed = entered != value;
  value = entered;
  return end_row(row, changed ? RowEvent::changed : RowEvent::none);
}

RowEvent switch_row(const Row& row, bool& value) {
  begin_row(row);
  const bool changed = ImGui::Checkbox("##value", &value);
  return end_row(row, changed ? RowEvent::changed : RowEvent::none);
}

RowEvent choice_row(const Row& row, std::string& value, std::span<const std::string> choices) {
  begin_row(row);
  RowEvent event = RowEvent::none;
  const bool open = ImGui::BeginCombo("##value", value.c_str());
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  if (open) {
    for (const std::string& choice : choices) {
      if (ImGui::Selectable(choice.c_str(), choice == value) && choice != value) {
        value = choice;
        event = RowEvent::changed;
      }
      mark(row.label + "=" + choice);
    }
    ImGui::EndCombo();
    // The list was the last item; the row's own entry is what its name stands for.
    ImGui::GetCurrentContext()->LastItemData.Rect = {low, high};
  }
  return end_row(row, event);
}

RowEvent text_row(const Row& row, std::string& value) {
  begin_row(row);
  Gui::current().need(value);
  const bool changed = ImGui::InputText("##value", &value);
  return end_row(row, changed ? RowEvent::changed : RowEvent::none);
}

std::string parameter_tooltip(const Parameter& parameter) {
  std::string text = parameter.meaning;
  const auto add = [&](const std::string& name, const std::string& words) {
    if (!words.empty()) text += "\n" + name + ": " + words;
  };
  if (parameter.kind() != ParameterKind::boolean && parameter.kind() != ParameterKind::path) {
    add("range", accepted_with_unit(parameter));
  }
  add("default", value_text(parameter.default_value));
  add("source", parameter.source);
  add("key", parameter.key);
  return text;
}

RowEvent parameter_row(const Parameter& parameter, ParameterValue& value, bool needs_new_terrain,
                       std::string unavailable) {
  const Row row{
      parameter.label,   parameter.unit,        parameter_tooltip(parameter), value != parameter.default_value,
      needs_new_terrain, std::move(unavailable)};
  RowEvent event = RowEvent::none;
  switch (parameter.kind()) {
    case ParameterKind::real: {
      // A real parameter may hold a whole number from a file.
      double number = std::holds_alternative<double>(value) ? std::get<double>(value)
                                                            : static_cast<double>(std::get<std::int64_t>(value));
      event = real_row(row, number, parameter.minimum, parameter.maximum);
      if (event == RowEvent::changed) value = number;
      break;
    }
    case ParameterKind::integer: {
      const auto whole = [](double bound) {
        constexpr double most = 9.2e18;
        return static_cast<std::int64_t>(std::clamp(bound, -most, most));
      };
      event = integer_row(row, std::get<std::int64_t>(value), whole(parameter.minimum), whole(parameter.maximum));
      break;
    }
    case ParameterKind::boolean:
      event = switch_row(row, std::get<bool>(value));
      break;
    case ParameterKind::choice:
      event = choice_row(row, std::get<std::string>(value), parameter.choices);
      break;
    case ParameterKind::path:
      event = text_row(row, std::get<std::string>(value));
      break;
    case ParameterKind::curve:
      event = curve_row(row, parameter, std::get<PiecewiseLinear>(value));
      break;
    case ParameterKind::bezier:
      event = bezier_row(row, std::get<BezierCurve>(value));
      break;
    case ParameterKind::rows:
      event = rows_row(row, parameter, std::get<RowList>(value));
      break;
  }
  if (event == RowEvent::reset) value = parameter.default_value;
  return event;
}

}  // namespace erg::ui
