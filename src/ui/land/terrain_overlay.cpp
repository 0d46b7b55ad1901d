#include "ui/land/terrain_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/number_text.h"
#include "core/units.h"
#include "forcing/bearing.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/gui.h"

namespace erg::ui {

using picture::Camera;

namespace {

constexpr float margin = 12;  // pixels at scale 1, from the edges of the terrain
constexpr float plate_opacity = 0.78f;
constexpr int most_marks = 6;  // of the legend's scale

ImU32 with_opacity(ImVec4 colour, float opacity) {
  colour.w = opacity;
  return ImGui::GetColorU32(colour);
}

// The direction on the screen (to the right, downwards) in which one goes north, east ... seen from above.
ImVec2 on_screen(double bearing, const Camera& camera) {
  // The camera stands at camera.bearing and looks the other way, which is up in the picture.
  const double turn = radians(bearing - camera.bearing - 180);
  return {static_cast<float>(std::sin(turn)), static_cast<float>(-std::cos(turn))};
}

void draw_arrow(ImVec2 middle, ImVec2 way, float length, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 across{-way.y, way.x};
  const auto at = [&](float along, float aside) {
    return ImVec2(middle.x + length * (along * way.x + aside * across.x),
                  middle.y + length * (along * way.y + aside * across.y));
  };
  list.AddLine(at(-0.5f, 0), at(0.3f, 0), colour, 0.09f * length);
  list.AddTriangleFilled(at(0.5f, 0), at(0.12f, 0.2f), at(0.12f, -0.2f), colour);
}

}  // namespace

std::optional<ImVec2> to_window(const Eigen::Vector3d& point, const Camera& camera, const WindowPart& part) {
  const double reach = 1e6;  // depth does not matter here
  const Eigen::Vector4d clip =
      render::projection_matrix(camera, part.aspect(), reach) * render::view_matrix(camera) * point.homogeneous();
  if (!(clip.w() > 1e-9)) return std::nullopt;
  return ImVec2(static_cast<float>(part.left + 0.5 * (clip.x() / clip.w() + 1) * part.width),
                static_cast<float>(part.top + 0.5 * (1 - clip.y() / clip.w()) * part.height));
}

render::PicturePoint to_picture(ImVec2 pixel, const WindowPart& part) {
  return {2.0 * (pixel.x - part.left) / part.width - 1, 1 - 2.0 * (pixel.y - part.top) / part.height};
}

void draw_plate(ImVec2 low_left, const std::string& text, const ImVec4& colour) {
  Gui& gui = Gui::current();
  gui.need(text);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = gui.px(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner{low_left.x, low_left.y - size.y - pad};
  list.AddRectFilled(corner, {corner.x + size.x + 2 * pad, low_left.y}, with_opacity(gui.theme().panel, plate_opacity),
                     gui.px(3));
  list.AddText({corner.x + pad, corner.y + 0.5f * pad}, ImGui::GetColorU32(colour), text.c_str());
}

void draw_legend(const TerrainPane& pane, const render::Look& look) {
  if (look.is_material() && look.contours == 0) return;
  const Gui& gui = Gui::current();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner{static_cast<float>(pane.part.left) + gui.px(margin),
                      static_cast<float>(pane.part.top) + gui.px(margin)};
  if (look.is_material()) {
    draw_plate({corner.x, corner.y + gui.px(24)}, "contours every " + figure_text(look.contours) + " m",
               gui.theme().text);
    return;
  }
  const render::ValueScale scale = render::value_scale(look, view_of_run(*pane.run));
  const float bar = gui.px(14);
  const float high = std::min(gui.px(180), 0.4f * static_cast<float>(pane.part.height));
  const float line = ImGui::GetFontSize();
  const std::string title = scale.label + (scale.unit.empty() ? "" : ", " + unit_text(scale.unit));
  const float wide = std::max(ImGui::CalcTextSize(title.c_str()).x, bar + gui.px(8) + 4.5f * line);
  list.AddRectFilled(corner, {corner.x + wide + gui.px(16), corner.y + high + 2.4f * line + gui.px(8)},
                     with_opacity(gui.theme().panel, plate_opacity), gui.px(3));
  const ImVec2 inner{corner.x + gui.px(8), corner.y + gui.px(6)};
  list.AddText(inner, ImGui::GetColorU32(gui.theme().text), title.c_str());
  const float top = inner.y + 1.5f * line;
  constexpr int parts = 48;
  for (int part = 0; part < parts; ++part) {
    const picture::Colour at = scale.palette.at(1 - (part + 0.5) / parts);
    list.AddRectFilled({inner.x, top + high * static_cast<float>(part) / parts},
                       {inner.x + bar, top + high * static_cast<float>(part + 1) / parts},
                       ImGui::GetColorU32(ImVec4(at.red, at.green, at.blue, 1)));
  }
  const auto mark = [&](double part, const std::string& text) {
    const float y = top + high * static_cast<float>(part);
    list.AddLine({inner.x + bar, y}, {inner.x + bar + gui.px(4), y}, ImGui::GetColorU32(gui.theme().text));
    list.AddText({inner.x + bar + gui.px(8), y - 0.5f * line}, ImGui::GetColorU32(gui.theme().text), text.c_str());
  };
  const Ticks ticks = round_ticks({scale.low, scale.high}, most_marks);
  for (int tick = 0; tick < ticks.count; ++tick) {
    const double value = ticks.at(tick);
    mark((scale.high - value) / (scale.high - scale.low), tick_text(value, ticks.step));
  }
  if (ticks.count == 0) mark(0, figure_text(scale.low));  // one value everywhere
}

void draw_wind_rose(const TerrainPane& pane, const Camera& camera) {
  const Gui& gui = Gui::current();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = gui.px(30);
  const ImVec2 middle{static_cast<float>(pane.part.left + pane.part.width) - gui.px(margin) - radius,
                      static_cast<float>(pane.part.top) + gui.px(margin) + radius};
  list.AddCircleFilled(middle, radius, with_opacity(gui.theme().panel, plate_opacity), 40);
  const ImVec2 north = on_screen(0, camera);
  const float letter = ImGui::GetFontSize();
  const ImVec2 size = ImGui::CalcTextSize("N");
  const float out = radius - 0.55f * letter;
  list.AddText({middle.x + out * north.x - 0.5f * size.x, middle.y + out * north.y - 0.5f * size.y},
               ImGui::GetColorU32(gui.theme().text), "N");
  const double bearing = pane.run->last_wind.mean_bearing();
  const ImVec2 way = on_screen(bearing + 180, camera);
  draw_arrow(middle, way, 1.15f * radius, ImGui::GetColorU32(gui.theme().accent));
}

void draw_marks(const TerrainPane& pane, const Camera& camera, double exaggeration,
                const std::vector<TerrainMark>& marks) {
  const Gui& gui = Gui::current();
  const Terrain& terrain = *pane.run->terrain;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto on_ground = [&](const std::array<double, 2>& cell) {
    const int x = std::clamp(static_cast<int>(std::lround(cell[0])), 0, terrain.nx() - 1);
    const int y = std::clamp(static_cast<int>(std::lround(cell[1])), 0, terrain.ny() - 1);
    const double height = exaggeration * terrain.metres(terrain.height(x, y));
    return Eigen::Vector3d((cell[0] + 0.5) * terrain.cell_size(), (cell[1] + 0.5) * terrain.cell_size(), height);
  };
  for (const TerrainMark& mark : marks) {
    const std::size_t edges = mark.points.size() - (mark.closed || mark.points.empty() ? 0 : 1);
    for (std::size_t edge = 0; edge < edges; ++edge) {
      const auto& from = mark.points[edge];
      const auto& to = mark.points[(edge + 1) % mark.points.size()];
      // In short pieces, so that the line lies on the ground.
      const int pieces = std::clamp(static_cast<int>(std::hypot(to[0] - from[0], to[1] - from[1]) / 2), 1, 256);
      std::optional<ImVec2> last = to_window(on_ground(from), camera, pane.part);
      for (int piece = 1; piece <= pieces; ++piece) {
        const double part = static_cast<double>(piece) / pieces;
        const std::optional<ImVec2> next = to_window(
            on_ground({from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])}), camera, pane.part);
        if (last && next) list.AddLine(*last, *next, ImGui::GetColorU32(gui.theme().accent), gui.px(2));
        last = next;
      }
    }
  }
}

}  // namespace erg::ui
