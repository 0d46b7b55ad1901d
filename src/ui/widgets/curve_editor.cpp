#include "ui/widgets/curve_editor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/widgets/typed_number.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

// At scale 1, pixels.
constexpr float handle_size = 7;
constexpr float grab_size = 11;  // large enough for a trackpad

double snapped(double share) { return ImGui::GetIO().KeyShift ? std::round(share * 10) / 10 : share; }

/// A place under the mouse as shares of the area, within it.
CurvePoint share_under_mouse(const PlotArea& area) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const double x = (mouse.x - area.upper_left.x) / (area.lower_right.x - area.upper_left.x);
  const double y = (area.lower_right.y - mouse.y) / (area.lower_right.y - area.upper_left.y);
  return {snapped(std::clamp(x, 0.0, 1.0)), snapped(std::clamp(y, 0.0, 1.0))};
}

enum class Grip { none, dragged, removed };

/// A point to be grabbed. Submitted as an item, so that the window under it stays where it is.
Grip handle(const char* name, ImVec2 place) {
  const Gui& gui = Gui::current();
  const float grab_radius = gui.px(grab_size);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({place.x - grab_radius, place.y - grab_radius});
  ImGui::InvisibleButton(name, {2 * grab_radius, 2 * grab_radius},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  mark(name);
  const bool active = ImGui::IsItemActive();
  const bool hot = active || ImGui::IsItemHovered();
  const bool removed = ImGui::IsItemClicked(ImGuiMouseButton_Right);
  ImGui::SetCursorScreenPos(after);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = gui.px(handle_size + (hot ? 2.0f : 0.0f));
  list.AddCircleFilled(place, radius, ImGui::GetColorU32(gui.theme().accent));
  list.AddCircle(place, radius, ImGui::GetColorU32(gui.theme().panel), 0, gui.px(2));
  if (removed) return Grip::removed;
  return active && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0) ? Grip::dragged : Grip::none;
}

PlotFrame plot_frame(const CurveFrame& frame) {
  PlotFrame plot;
  plot.x_label = frame.x_label;
  plot.y_label = frame.y_label;
  plot.x = frame.x;
  plot.y = AxisRange{std::min(frame.y.low, frame.y.high), std::max(frame.y.low, frame.y.high)};
  plot.height = frame.height;
  return plot;
}

void draw_now(const PlotArea& area, const std::optional<double>& cursor) {
  if (!cursor) return;
  const ImVec2 foot = area.at(std::clamp(*cursor, area.x.low, area.x.high), area.y.low);
  ImGui::GetWindowDrawList()->AddLine({foot.x, area.upper_left.y}, foot, ImGui::GetColorU32(ImGuiCol_CheckMark, 0.6f));
}

/// One number beside the curve; true when it was typed anew.
bool typed_share(const char* name, const char* meaning, double& share) {
  ImGui::SetNextItemWidth(ImGui::CalcTextSize("0.000").x + 2 * ImGui::GetStyle().FramePadding.x);
  double value = share;
  take_typed_number(name);
  const bool edited = ImGui::InputDouble(name, &value, 0, 0, "%.3g");
  mark(name + 2);
  tooltip(meaning);
  if (!edited || !std::isfinite(value)) return false;
  const double held = std::clamp(value, 0.0, 1.0);
  const bool changed = held != share;
  share = held;
  return changed;
}

bool typed_point(const char* name, CurvePoint& point) {
  const WidgetScope scope(name);
  ImGui::AlignTextToFramePadding();
  const float left = ImGui::GetCursorPosX();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(left + ImGui::CalcTextSize("start ").x);
  const bool across = typed_share("##x", "How far along the time the curve is pulled, 0 to 1.", point.x);
  ImGui::SameLine();
  const bool up = typed_share("##y", "How far from the first to the last value it is pulled, 0 to 1.", point.y);
  return across || up;
}

bool reset_button(bool is_standard) {
  return button("RESET", {.tooltip = "Back to the shape it had at first.",
                          .unavailable = is_standard ? "It has that shape." : ""});
}

/// The box of a Bezier and its shares; a strength that falls runs from the upper left to the lower right.
struct CurveBox {
  PlotArea area;
  bool falling = false;
  ImVec2 at(CurvePoint share) const {
    const double up = falling ? 1 - share.y : share.y;
    return {std::lerp(area.upper_left.x, area.lower_right.x, static_cast<float>(share.x)),
            std::lerp(area.lower_right.y, area.upper_left.y, static_cast<float>(up))};
  }
};

bool drag_control(const char* name, CurvePoint& point, const CurveBox& box, ImVec2 anchor) {
  ImGui::GetWindowDrawList()->AddLine(anchor, box.at(point), ImGui::GetColorU32(ImGuiCol_TextDisabled), 1.5f);
  if (handle(name, box.at(point)) != Grip::dragged) return false;
  CurvePoint share = share_under_mouse(box.area);
  if (box.falling) share.y = 1 - share.y;
  const bool moved = !(share == point);
  point = share;
  return moved;
}

void snap_hint(const PlotArea& area) {
  if (!area.hovered || ImGui::IsAnyItemActive()) return;
  ImGui::SetTooltip("drag a point; with Shift it snaps to tenths");
}

bool drag_point(std::vector<CurvePoint>& points, std::size_t point, const PlotArea& area) {
  const CurvePoint share = share_under_mouse(area);
  CurvePoint moved{std::lerp(area.x.low, area.x.high, share.x), std::lerp(area.y.low, area.y.high, share.y)};
  const bool first = point == 0;
  const bool last = point + 1 == points.size();
  // The ends stay at the ends of time; those between stay between their neighbours.
  if (first || last) {
    moved.x = points[point].x;
  } else {
    const double room = (area.x.high - area.x.low) * 0.005;
    moved.x = std::clamp(moved.x, points[point - 1].x + room, points[point + 1].x - room);
  }
  const bool changed = !(moved == points[point]);
  points[point] = moved;
  return changed;
}

bool add_point(std::vector<CurvePoint>& points, const PlotArea& area) {
  if (!area.hovered || ImGui::IsAnyItemHovered() || !ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return false;
  const CurvePoint share = share_under_mouse(area);
  const CurvePoint point{std::lerp(area.x.low, area.x.high, share.x), std::lerp(area.y.low, area.y.high, share.y)};
  const auto after = std::upper_bound(points.begin(), points.end(), point.x,
                                      [](double x, const CurvePoint& other) { return x < other.x; });
  if (after == points.begin() || after == points.end()) return false;
  points.insert(after, point);
  return true;
}

}  // namespace

bool edit_curve(const char* id, BezierCurve& curve, const CurveFrame& frame) {
  const WidgetScope scope(id);
  const PlotFrame plot = plot_frame(frame);
  const CurveBox box{draw_axes("box", plot), frame.y.high < frame.y.low};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 start = box.at({0, 0});
  const ImVec2 end = box.at({1, 1});
  draw_now(box.area, frame.cursor);
  list.AddLine(start, end, ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.35f));
  list.AddBezierCubic(start, box.at(curve.first), box.at(curve.second), end, line_colour(0), 2.5f, 48);
  bool changed = drag_control("first", curve.first, box, start);
  changed = drag_control("second", curve.second, box, end) || changed;
  snap_hint(box.area);
  changed = typed_point("start", curve.first) || changed;
  ImGui::SameLine();
  if (reset_button(curve == BezierCurve{})) {
    curve = {};
    changed = true;
  }
  changed = typed_point("end", curve.second) || changed;
  return changed;
}

bool edit_points(const char* id, std::vector<CurvePoint>& points, const std::vector<CurvePoint>& standard,
                 const CurveFrame& frame) {
  const WidgetScope scope(id);
  const PlotArea area = draw_axes("box", plot_frame(frame));
  draw_now(area, frame.cursor);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 1; i < points.size(); ++i) {
    list.AddLine(area.at(points[i - 1].x, points[i - 1].y), area.at(points[i].x, points[i].y), line_colour(0), 2.5f);
  }
  bool changed = false;
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string name = "point " + std::to_string(i);
    const Grip grip = handle(name.c_str(), area.at(points[i].x, points[i].y));
    if (grip == Grip::dragged) changed = drag_point(points, i, area) || changed;
    if (grip == Grip::removed && i > 0 && i + 1 < points.size()) removed = i;
  }
  changed = add_point(points, area) || changed;
  if (removed) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(*removed));
    changed = true;
  }
  explain("double click adds a point, right click removes it");
  if (reset_button(points == standard)) {
    points = standard;
    changed = true;
  }
  return changed;
}

}  // namespace erg::ui
