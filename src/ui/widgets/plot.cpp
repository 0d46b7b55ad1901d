#include "ui/widgets/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

constexpr float tick_gap = 4;

ImU32 faint(ImGuiCol colour, float opacity) { return ImGui::GetColorU32(colour, opacity); }

int tick_room(float pixels, float each) { return std::max(2, static_cast<int>(pixels / each)); }

float widest_tick(const Ticks& ticks) {
  float widest = 0;
  for (int tick = 0; tick < ticks.count; ++tick) {
    widest = std::max(widest, ImGui::CalcTextSize(tick_text(ticks.at(tick), ticks.step).c_str()).x);
  }
  return widest;
}

void draw_ticks_up(const PlotArea& area, const Ticks& ticks) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half_line = ImGui::GetTextLineHeight() / 2;
  for (int tick = 0; tick < ticks.count; ++tick) {
    const ImVec2 place = area.at(area.x.low, ticks.at(tick));
    const std::string text = tick_text(ticks.at(tick), ticks.step);
    list.AddLine({area.upper_left.x, place.y}, {area.lower_right.x, place.y}, faint(ImGuiCol_TextDisabled, 0.25f));
    list.AddText({area.upper_left.x - tick_gap - ImGui::CalcTextSize(text.c_str()).x, place.y - half_line},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
  }
}

void draw_ticks_across(const PlotArea& area, const Ticks& ticks, float right_end) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_from = -std::numeric_limits<float>::max();
  for (int tick = 0; tick < ticks.count; ++tick) {
    const ImVec2 place = area.at(ticks.at(tick), area.y.low);
    const std::string text = tick_text(ticks.at(tick), ticks.step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    list.AddLine({place.x, area.lower_right.y}, {place.x, area.lower_right.y + tick_gap},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const float left = std::min(place.x - width / 2, right_end - width);
    if (left < free_from) continue;
    list.AddText({left, area.lower_right.y + tick_gap}, ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
    free_from = left + width + 2 * tick_gap;
  }
}

void draw_band(const PlotArea& area, const PlotBand& band, bool shaded) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = area.at(band.from, area.y.high);
  const ImVec2 end = area.at(band.to, area.y.low);
  if (band.active) {
    list.AddRectFilled(corner, end, faint(ImGuiCol_CheckMark, 0.16f));
  } else if (shaded) {
    list.AddRectFilled(corner, end, faint(ImGuiCol_TextDisabled, 0.14f));
  }
  const float width = ImGui::CalcTextSize(band.label.c_str()).x;
  if (width + tick_gap > end.x - corner.x) return;  // no room: the season's row says it
  list.AddText({(corner.x + end.x - width) / 2, corner.y + 2}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
               band.label.c_str());
}

void draw_cursor(const PlotArea& area, double x) {
  const ImVec2 foot = area.at(std::clamp(x, area.x.low, area.x.high), area.y.low);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({foot.x, area.upper_left.y}, foot, ImGui::GetColorU32(ImGuiCol_CheckMark), 2);
  list.AddTriangleFilled({foot.x - 5, area.upper_left.y}, {foot.x + 5, area.upper_left.y},
                         {foot.x, area.upper_left.y + 7}, ImGui::GetColorU32(ImGuiCol_CheckMark));
}

void widen(AxisRange& range, std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
}

AxisRange nothing_yet() { return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}; }

PlotFrame with_ranges(PlotFrame frame, std::span<const PlotLine> lines) {
  AxisRange x = nothing_yet();
  AxisRange y = nothing_yet();
  for (const PlotLine& line : lines) {
    widen(x, line.x);
    widen(y, line.y);
  }
  if (frame.from_zero) widen(y, std::vector<double>{0.0});
  if (!frame.x) frame.x = x.high > x.low ? x : round_range(x, 5);
  if (!frame.y) frame.y = round_range(y, 5);
  // The names of the bands stand above the lines.
  if (!frame.bands.empty()) frame.y->high += 0.3 * (frame.y->high - frame.y->low);
  return frame;
}

/// The legend in rows as wide as the plot.
void draw_legend(std::span<const PlotLine> lines) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float mark = ImGui::GetTextLineHeight();
  bool first = true;
  for (const PlotLine& line : lines) {
    const float width = mark + tick_gap + ImGui::CalcTextSize(line.label.c_str()).x;
    if (!first && ImGui::GetItemRectMax().x + 3 * tick_gap + width < right) ImGui::SameLine(0, 3 * tick_gap);
    first = false;
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({place.x, place.y + mark / 2}, {place.x + mark - tick_gap, place.y + mark / 2},
                                        line.colour, 3);
    ImGui::Dummy({mark - tick_gap, mark});
    ImGui::SameLine(0, tick_gap);
    ImGui::TextUnformatted(line.label.c_str());
  }
}

/// The value of a line at the point nearest to x.
std::optional<double> value_near(const PlotLine& line, double x) {
  const std::size_t count = std::min(line.x.size(), line.y.size());
  if (count == 0) return {};
  auto after = std::lower_bound(line.x.begin(), line.x.begin() + static_cast<std::ptrdiff_t>(count), x);
  if (after == line.x.begin() + static_cast<std::ptrdiff_t>(count)) --after;
  if (after != line.x.begin() && x - *(after - 1) < *after - x) --after;
  const double value = line.y[static_cast<std::size_t>(after - line.x.begin())];
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void show_values(const PlotArea& area, std::span<const PlotLine> lines, const PlotFrame& frame, double x) {
  const ImVec2 foot = area.at(x, area.y.low);
  ImGui::GetWindowDrawList()->AddLine({foot.x, area.upper_left.y}, foot, faint(ImGuiCol_Text, 0.4f));
  ImGui::BeginTooltip();
  ImGui::Text("%s %s", frame.x_label.c_str(), figure_text(x, 5).c_str());
  for (const PlotLine& line : lines) {
    const std::optional<double> value = value_near(line, x);
    if (!value) continue;
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(line.colour), "%s %s", figure_text(*value).c_str(),
                       line.label.empty() ? frame.y_label.c_str() : line.label.c_str());
  }
  ImGui::EndTooltip();
}

}  // namespace

ImVec2 PlotArea::at(double px, double py) const {
  const double across = (px - x.low) / (x.high - x.low);
  const double up = (py - y.low) / (y.high - y.low);
  return {upper_left.x + static_cast<float>(across) * (lower_right.x - upper_left.x),
          lower_right.y - static_cast<float>(up) * (lower_right.y - upper_left.y)};
}

double PlotArea::x_at(float pixel) const {
  return std::lerp(x.low, x.high, static_cast<double>((pixel - upper_left.x) / (lower_right.x - upper_left.x)));
}

ImU32 line_colour(int line) { return ImGui::ColorConvertFloat4ToU32(Gui::current().theme().line(line)); }

PlotArea draw_axes(const char* id, const PlotFrame& frame) {
  ImGui::PushID(id);
  const float line = ImGui::GetTextLineHeight();
  if (!frame.y_label.empty()) ImGui::TextDisabled("%s", frame.y_label.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(120.0f, ImGui::GetContentRegionAvail().x);
  const float height = frame.height > 0 ? frame.height : std::clamp(width * 0.45f, 8 * line, 16 * line);

  PlotArea area;
  area.x = frame.x.value_or(AxisRange{});
  area.y = frame.y.value_or(AxisRange{});
  const float below = tick_gap + line + (frame.x_label.empty() ? 0 : line + tick_gap);
  const Ticks up = round_ticks(area.y, tick_room(height - below, 1.6f * line));
  area.upper_left = {corner.x + widest_tick(up) + tick_gap, corner.y + line / 2};
  area.lower_right = {corner.x + width - 2, corner.y + height - below};

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.upper_left, area.lower_right, ImGui::GetColorU32(ImGuiCol_FrameBg));
  for (std::size_t band = 0; band < frame.bands.size(); ++band) draw_band(area, frame.bands[band], band % 2 == 1);
  draw_ticks_up(area, up);
  draw_ticks_across(area, round_ticks(area.x, tick_room(area.lower_right.x - area.upper_left.x, 3.5f * line)),
                    corner.x + width);
  list.AddLine({area.upper_left.x, area.lower_right.y}, area.lower_right, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  if (!frame.x_label.empty()) {
    const float text = ImGui::CalcTextSize(frame.x_label.c_str()).x;
    list.AddText({area.lower_right.x - text, area.lower_right.y + tick_gap + line},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), frame.x_label.c_str());
  }
  ImGui::Dummy({width, height});
  mark(id, area.upper_left, area.lower_right);
  area.hovered = ImGui::IsItemHovered() && ImGui::IsMouseHoveringRect(area.upper_left, area.lower_right);
  ImGui::PopID();
  return area;
}

void draw_line(const PlotArea& area, const PlotLine& line) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(area.upper_left, area.lower_right, true);
  std::vector<ImVec2> points;
  const auto finish = [&] {
    if (points.size() > 1) {
      list.AddPolyline(points.data(), static_cast<int>(points.size()), line.colour, ImDrawFlags_None, 1.8f);
    } else if (points.size() == 1) {
      list.AddCircleFilled(points.front(), 2.5f, line.colour);
    }
    points.clear();
  };
  int column_points = 0;  // in the column of pixels of the last point: its least and its greatest value are kept
  for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
    if (!std::isfinite(line.y[i])) {
      finish();
      continue;
    }
    const ImVec2 point = area.at(line.x[i], line.y[i]);
    column_points = !points.empty() && std::floor(points.back().x) == std::floor(point.x) ? column_points + 1 : 1;
    if (column_points <= 2) {
      points.push_back(point);
      continue;
    }
    ImVec2& one = points[points.size() - 2];
    ImVec2& other = points.back();
    ImVec2& lowest = one.y < other.y ? one : other;
    ImVec2& highest = one.y < other.y ? other : one;
    lowest.y = std::min(lowest.y, point.y);
    highest.y = std::max(highest.y, point.y);
  }
  finish();
  list.PopClipRect();
}

std::optional<double> draw_plot(const char* id, std::span<const PlotLine> lines, const PlotFrame& frame) {
  const PlotFrame framed = with_ranges(frame, lines);
  if (lines.size() > 1) draw_legend(lines);
  const PlotArea area = draw_axes(id, framed);
  for (const PlotLine& line : lines) draw_line(area, line);
  if (framed.cursor) draw_cursor(area, *framed.cursor);
  if (!area.hovered) return {};
  const double x = std::clamp(area.x_at(ImGui::GetMousePos().x), area.x.low, area.x.high);
  show_values(area, lines, framed, x);
  return x;
}

void draw_histogram(const char* id, std::span<const double> counts, AxisRange range, const PlotFrame& frame) {
  PlotFrame framed = frame;
  framed.x = range;
  const double most = counts.empty() ? 0.0 : *std::max_element(counts.begin(), counts.end());
  if (!framed.y) framed.y = round_range({0, most}, 4);
  const PlotArea area = draw_axes(id, framed);
  const double width = (range.high - range.low) / static_cast<double>(std::max<std::size_t>(1, counts.size()));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t bar = 0; bar < counts.size(); ++bar) {
    const double left = range.low + width * static_cast<double>(bar);
    ImVec2 corner = area.at(left, counts[bar]);
    ImVec2 end = area.at(left + width, 0);
    const bool under_mouse = area.hovered && ImGui::GetMousePos().x >= corner.x && ImGui::GetMousePos().x < end.x;
    if (end.x - corner.x > 3) end.x -= 1;
    list.AddRectFilled(corner, end, under_mouse ? ImGui::GetColorU32(ImGuiCol_Text) : line_colour(0));
    if (!under_mouse) continue;
    ImGui::SetTooltip("%s to %s: %s", figure_text(left).c_str(), figure_text(left + width).c_str(),
                      figure_text(counts[bar]).c_str());
  }
}

}  // namespace erg::ui
