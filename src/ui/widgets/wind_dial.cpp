#include "ui/widgets/wind_dial.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/units.h"
#include "forcing/bearing.h"
#include "forcing/wind_schedule.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/typed_number.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using forcing::compass_name;

namespace {

constexpr int compass_points = 16;

/// The pixel at a bearing (clockwise from up) and distance from the middle.
ImVec2 place_at(ImVec2 middle, double bearing, float distance) {
  const double angle = radians(bearing);
  return {middle.x + distance * static_cast<float>(std::sin(angle)),
          middle.y - distance * static_cast<float>(std::cos(angle))};
}

void draw_letters(ImVec2 middle, float distance) {
  constexpr std::array<const char*, 4> letters{"N", "E", "S", "W"};
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const ImVec2 place = place_at(middle, 90.0 * static_cast<double>(i), distance);
    const ImVec2 size = ImGui::CalcTextSize(letters[i]);
    ImGui::GetWindowDrawList()->AddText({place.x - size.x / 2, place.y - size.y / 2},
                                        ImGui::GetColorU32(i == 0 ? ImGuiCol_Text : ImGuiCol_TextDisabled), letters[i]);
  }
}

void draw_compass(ImVec2 middle, float radius) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 64);
  list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_TextDisabled), 64);
  for (int point = 0; point < compass_points; ++point) {
    const double bearing = 360.0 * point / compass_points;
    const float length = point % 4 == 0 ? 0.12f : 0.06f;
    list.AddLine(place_at(middle, bearing, radius), place_at(middle, bearing, radius * (1 - length)),
                 ImGui::GetColorU32(ImGuiCol_TextDisabled));
  }
}

/// From the rim where the wind comes from, through the middle, to a head on the other side.
void draw_hand(ImVec2 middle, double bearing, float radius, bool hot) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_CheckMark);
  const ImVec2 head = place_at(middle, bearing + 180, radius * 0.72f);
  list.AddLine(place_at(middle, bearing, radius), place_at(middle, bearing + 180, radius * 0.6f), colour, 3);
  list.AddTriangleFilled(head, place_at(middle, bearing + 180 - 18, radius * 0.46f),
                         place_at(middle, bearing + 180 + 18, radius * 0.46f), colour);
  const ImVec2 grip = place_at(middle, bearing, radius);
  list.AddCircleFilled(grip, hot ? 9.0f : 7.0f, colour);
  list.AddCircle(grip, hot ? 9.0f : 7.0f, ImGui::GetColorU32(ImGuiCol_WindowBg), 0, 2);
}

double bearing_under_mouse(ImVec2 middle) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const double bearing = fold_bearing(degrees(std::atan2(mouse.x - middle.x, middle.y - mouse.y)));
  constexpr double point = 360.0 / compass_points;
  return ImGui::GetIO().KeyShift ? fold_bearing(std::round(bearing / point) * point)
                                 : fold_bearing(std::round(bearing));
}

/// The outline of a rose: a wedge for each sector.
std::vector<ImVec2> wedge(ImVec2 middle, double bearing, double width, float radius) {
  std::vector<ImVec2> points{middle};
  constexpr int arc = 6;
  for (int i = 0; i <= arc; ++i) points.push_back(place_at(middle, bearing + width * (i / double(arc) - 0.5), radius));
  return points;
}

/// Where a swinging wind comes from: from its first swing to its last. One wedge for each two neighbours, since a wide
/// fan as a whole would not be convex.
void draw_fan(ImVec2 middle, double bearing, double spread, float radius) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto swings = forcing::wind_swings(spread);
  for (std::size_t k = 1; k < swings.size(); ++k) {
    const double mean = bearing + (swings[k - 1] + swings[k]) / 2;
    const std::vector<ImVec2> points = wedge(middle, mean, swings[k] - swings[k - 1], radius);
    list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()),
                             ImGui::GetColorU32(ImGuiCol_CheckMark, 0.25f));
  }
}

void draw_sectors(ImVec2 middle, std::span<const double> shares, double most, float radius, bool filled) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double width = 360.0 / static_cast<double>(std::max<std::size_t>(1, shares.size()));
  for (std::size_t sector = 0; sector < shares.size(); ++sector) {
    if (shares[sector] <= 0) continue;
    const float length = radius * static_cast<float>(shares[sector] / most);
    const std::vector<ImVec2> points = wedge(middle, width * static_cast<double>(sector), width * 0.86, length);
    const int count = static_cast<int>(points.size());
    if (filled) {
      list.AddConvexPolyFilled(points.data(), count, ImGui::GetColorU32(ImGuiCol_CheckMark, 0.75f));
    } else {
      list.AddPolyline(points.data(), count, ImGui::GetColorU32(ImGuiCol_Text, 0.8f), ImDrawFlags_Closed, 1.5f);
    }
  }
}

void tell_sector(ImVec2 middle, std::span<const double> blown, std::span<const double> coming, float radius) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const std::size_t sectors = std::max(blown.size(), coming.size());
  if (sectors == 0 || std::hypot(mouse.x - middle.x, mouse.y - middle.y) > radius) return;
  const double width = 360.0 / static_cast<double>(sectors);
  const double bearing = degrees(std::atan2(mouse.x - middle.x, middle.y - mouse.y));
  const auto sector = static_cast<std::size_t>(fold_bearing(bearing + width / 2) / width) % sectors;
  const auto share = [&](std::span<const double> shares) {
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    return sector < shares.size() && all > 0 ? figure_text(100 * shares[sector] / all, 3) + " %" : std::string("-");
  };
  ImGui::SetTooltip("from %s\n%s of what has blown\n%s of what will blow\n(strength times steps)",
                    compass_name(width * static_cast<double>(sector)).c_str(), share(blown).c_str(),
                    share(coming).c_str());
}

}  // namespace

bool wind_dial(const char* id, double& bearing, float size, double spread) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 middle{corner.x + size / 2, corner.y + size / 2};
  const float letter = ImGui::GetTextLineHeight();
  const float radius = size / 2 - letter - 8;
  ImGui::InvisibleButton(id, {size, size});
  mark(id);
  const bool active = ImGui::IsItemActive();
  const bool hovered = ImGui::IsItemHovered();
  bool changed = false;
  if (active) {
    const double turned = bearing_under_mouse(middle);
    changed = turned != bearing;
    bearing = turned;
  }
  draw_compass(middle, radius);
  draw_letters(middle, radius + letter / 2 + 8);  // beyond the hand's grip
  if (spread > 0) draw_fan(middle, bearing, spread, radius);
  draw_hand(middle, bearing, radius, active || hovered);
  if (!active) tooltip("Drag to where the wind blows from; with Shift to a point of the compass.");
  return changed;
}

bool type_bearing(const char* id, double& bearing) {
  // While it is typed the text is ImGui's; what can be read holds at once.
  std::string text = figure_text(bearing, 5);
  ImGui::SetNextItemWidth(ImGui::CalcTextSize("000.00").x + 2 * ImGui::GetStyle().FramePadding.x + 8);
  const double before = bearing;
  const bool edited = ImGui::InputText((std::string("##") + id).c_str(), &text);
  mark(id);
  tooltip("Where the wind blows from: degrees clockwise from north, or a point of the compass such as W or NNE.");
  if (edited) {
    try {
      bearing = forcing::parse_bearing(as_pasted_number(text), "bearing");
    } catch (const InputError& error) {
      ImGui::SetTooltip("%s", error.mistakes().front().remedy.c_str());
    }
  }
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::Text("%s", ("\u00b0 " + compass_name(bearing)).c_str());
  return bearing != before;
}

void draw_wind_rose(const char* id, std::span<const double> blown, std::span<const double> coming, float size) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 middle{corner.x + size / 2, corner.y + size / 2};
  const float letter = ImGui::GetTextLineHeight();
  const float radius = size / 2 - letter - 2;
  ImGui::PushID(id);
  ImGui::Dummy({size, size});
  const bool hovered = ImGui::IsItemHovered();
  ImGui::PopID();
  draw_compass(middle, radius);
  draw_letters(middle, radius + letter / 2 + 2);
  // Each to its own scale: of a long run's first seasons nothing would be seen beside all that is to come.
  const auto draw = [&](std::span<const double> shares, bool filled) {
    const double most = shares.empty() ? 0 : *std::ranges::max_element(shares);
    if (most > 0) draw_sectors(middle, shares, most, radius * 0.94f, filled);
  };
  draw(blown, true);
  draw(coming, false);
  if (hovered) tell_sector(middle, blown, coming, radius);
}

}  // namespace erg::ui
