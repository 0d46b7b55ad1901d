#include "ui/land/terrain_window.h"

#include <algorithm>
#include <cmath>

#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Activity;
using session::SetupDifference;
using session::Snapshot;

namespace {

constexpr ImGuiWindowFlags bare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
constexpr int run_gap = 2;  // pixels between runs that are compared

// Two beside each other, three and four in two rows.
std::vector<WindowPart> split(const WindowPart& area, std::size_t count) {
  std::vector<WindowPart> parts;
  const int columns = count > 1 ? 2 : 1;
  const int rows = count > 2 ? 2 : 1;
  for (std::size_t index = 0; index < count; ++index) {
    const int column = static_cast<int>(index) % columns;
    const int row = static_cast<int>(index) / columns;
    const bool last_alone = count == 3 && index == 2;
    const int left = column * (area.width + run_gap) / columns;
    const int top = row * (area.height + run_gap) / rows;
    const int width = last_alone ? area.width : (area.width - (columns - 1) * run_gap) / columns;
    parts.push_back({area.left + left, area.top + top, std::max(width, 1),
                     std::max((area.height - (rows - 1) * run_gap) / rows, 1)});
  }
  return parts;
}

bool inside(ImVec2 point, const WindowPart& part) {
  return point.x >= static_cast<float>(part.left) && point.y >= static_cast<float>(part.top) &&
         point.x < static_cast<float>(part.left + part.width) && point.y < static_cast<float>(part.top + part.height);
}

ImVec2 corner_of(const WindowPart& part) { return {static_cast<float>(part.left), static_cast<float>(part.top)}; }
ImVec2 size_of(const WindowPart& part) { return {static_cast<float>(part.width), static_cast<float>(part.height)}; }

double pressed(int forwards, int backwards) {
  return (ImGui::IsKeyDown(forwards) ? 1 : 0) - (ImGui::IsKeyDown(backwards) ? 1 : 0);
}

// A line of text in the middle of what is left of the window's width.
void centred(const std::string& text, const ImVec4& colour) {
  const float wide = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(0.5f * (ImGui::GetWindowWidth() - wide));
  ImGui::TextColored(colour, "%s", text.c_str());
}

/// Number and model of a run that is compared, and the first thing in which it differs from the others.
std::string caption(const sim::Config& config, const std::vector<SetupDifference>& differences, std::size_t run) {
  std::string text = std::to_string(run + 1) + "  " + models::find_model(config.model).info.title;
  const auto first = std::ranges::find_if(differences, [](const SetupDifference& one) { return one.name != "model"; });
  if (first != differences.end() && run < first->values.size()) text += "\n" + first->label + " " + first->values[run];
  return text;
}

}  // namespace

std::vector<TerrainPane> TerrainWindow::panes(const Snapshot& now) const {
  std::vector<TerrainPane> all;
  for (std::size_t index = 0; index < std::min(parts_.size(), now.runs.size()); ++index) {
    all.push_back({parts_[index], &now.runs[index], ground_(index)});
  }
  return all;
}

void TerrainWindow::take_wanted_view(const Snapshot& now, const std::vector<TerrainPane>& panes) {
  if (panes.empty()) return;
  const Terrain& terrain = *panes.front().run->terrain;
  const std::array<double, 2> extent{terrain.nx() * terrain.cell_size(), terrain.ny() * terrain.cell_size()};
  // A terrain of another size is shown whole, from above if the last one was, else as a block.
  if (view_state_.wanted_view.empty() && extent != extent_) {
    view_state_.wanted_view = view_state_.camera.camera().orthographic ? "top" : "block";
  }
  if (view_state_.wanted_view.empty() && now.creations != creations_) view_state_.wanted_view = "frame";
  extent_ = extent;
  creations_ = now.creations;
  if (view_state_.wanted_view.empty()) return;
  const render::TerrainBox box = render::Renderer::box_of(view_of_run(*panes.front().run), view_state_.look);
  view_state_.camera.choose(view_state_.wanted_view, box, panes.front().part.aspect());
  view_state_.wanted_view.clear();
}

void TerrainWindow::take_input(PanelContext& context, WindowPart area) {
  const Snapshot& now = context.app.now();
  area_ = area;
  const std::size_t parts_before = parts_.size();
  parts_ = split(area, now.runs.size());
  // Beside others a run has less room than alone: all of it stays in sight.
  const bool other_room = parts_before > 0 && parts_.size() != parts_before;
  if (other_room && view_state_.wanted_view.empty()) view_state_.wanted_view = "frame";
  tool_ = context.tool;
  context.tool = TerrainTool::camera;  // a panel that wants another says so in every frame
  const std::vector<TerrainPane> all = panes(now);
  take_wanted_view(now, all);

  ImGui::SetNextWindowPos(corner_of(area));
  ImGui::SetNextWindowSize(size_of(area));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin("##terrain", nullptr, bare);
  ImGui::SetCursorScreenPos(corner_of(area));
  ImGui::InvisibleButton(
      "terrain", size_of(area),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  mark("terrain");
  const bool hovered = ImGui::IsItemHovered();
  active_ = ImGui::IsItemActive();
  ImGui::SetItemAllowOverlap();
  ImGui::End();
  ImGui::PopStyleVar(2);

  restless_ = false;
  context.pointer = {};
  if (all.empty()) return;
  if (!active_) {
    for (std::size_t index = 0; index < all.size(); ++index) {
      if (inside(ImGui::GetIO().MousePos, parts_[index])) under_pointer_ = index;
    }
  }
  under_pointer_ = std::min(under_pointer_, all.size() - 1);
  const TerrainPane& pane = all[under_pointer_];
  if (hovered && ImGui::IsMouseClicked(0)) context.app.set_active(under_pointer_);
  if (pane.ground == nullptr) return;
  point(context, pane, hovered);
  move_camera(context, pane, hovered);
}

void TerrainWindow::point(PanelContext& context, const TerrainPane& pane, bool hovered) {
  if (!hovered && !active_) return;
  const render::PicturePoint place = to_picture(ImGui::GetIO().MousePos, pane.part);
  const auto seen = pane.ground->under(view_state_.camera.camera(), place, pane.part.aspect());
  const Terrain& terrain = *pane.run->terrain;
  if (seen) {
    const auto cell = [&](double metres, int count) {
      return std::clamp(static_cast<int>(std::floor(metres / terrain.cell_size())), 0, count - 1);
    };
    context.pointer.cell = session::CellPlace{cell(seen->x(), terrain.nx()), cell(seen->y(), terrain.ny())};
  }
  if (tool_ == TerrainTool::camera || ImGui::GetIO().KeyCtrl) return;
  context.pointer.pressed = seen.has_value() && hovered && ImGui::IsMouseClicked(0);
  context.pointer.held = active_ && ImGui::IsMouseDown(0);
}

void TerrainWindow::move_camera(const PanelContext& context, const TerrainPane& pane, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  CameraInput input;
  input.cursor = to_picture(io.MousePos, pane.part);
  input.seconds = std::min(static_cast<double>(io.DeltaTime), 0.1);
  const bool left = active_ && ImGui::IsMouseDown(0) && (tool_ == TerrainTool::camera || io.KeyCtrl);
  input.look = left && io.KeyCtrl;
  input.orbit = left && !io.KeyCtrl && !io.KeyShift;
  input.pan = active_ && (ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2) || (left && io.KeyShift));
  input.right = io.MouseDelta.x / pane.part.height;
  input.up = -io.MouseDelta.y / pane.part.height;
  if (hovered) input.wheel = io.MouseWheel;
  if (!io.WantTextInput && !io.KeyCtrl && !context.keys_taken) {
    input.forwards = pressed('W', 'S');
    input.sideways = pressed('D', 'A');
    input.rise = pressed('E', 'Q');
  }
  restless_ =
      view_state_.camera.move(input, *pane.ground, pane.part.aspect()) || input.orbit || input.pan || input.look;
}

void TerrainWindow::draw_over(PanelContext& context) {
  ImGui::Begin("##terrain", nullptr, bare);
  {
    const WidgetScope scope("LAND");
    const std::vector<TerrainPane> all = panes(context.app.now());
    if (all.empty()) {
      draw_empty(context);
    } else {
      draw_terrains(context, all);
    }
  }
  context.marks.clear();
  ImGui::End();
}

void TerrainWindow::draw_terrains(const PanelContext& context, const std::vector<TerrainPane>& all) const {
  const picture::Camera& camera = view_state_.camera.camera();
  for (const TerrainPane& pane : all) {
    const ImVec2 corner = corner_of(pane.part);
    const ImVec2 size = size_of(pane.part);
    ImGui::PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
    draw_marks(pane, camera, view_state_.look.exaggeration, context.marks);
    if (view_state_.legend) draw_legend(pane, view_state_.look);
    if (view_state_.legend) draw_wind_rose(pane, camera);
    ImGui::PopClipRect();
  }
  if (all.size() > 1) draw_captions(context, all);
  draw_reading(context, all[std::min(under_pointer_, all.size() - 1)]);
  draw_troubles(context);
}

void TerrainWindow::draw_reading(const PanelContext& context, const TerrainPane& pane) const {
  if (!context.pointer.cell) return;
  const Terrain& terrain = *pane.run->terrain;
  if (context.pointer.cell->x >= terrain.nx() || context.pointer.cell->y >= terrain.ny()) return;
  const Gui& gui = Gui::current();
  const ImVec2 place{static_cast<float>(pane.part.left) + gui.px(12),
                     static_cast<float>(pane.part.top + pane.part.height) - gui.px(12)};
  draw_plate(place, session::read_cell(terrain, *context.pointer.cell).text(), gui.theme().text);
  mark("reading", {place.x, place.y - gui.px(20)}, {place.x + gui.px(200), place.y});
}

void TerrainWindow::draw_captions(const PanelContext& context, const std::vector<TerrainPane>& all) const {
  const Theme& theme = Gui::current().theme();
  const std::vector<SetupDifference> differences = context.app.comparison().differences();
  for (std::size_t index = 0; index < all.size(); ++index) {
    const WindowPart& part = all[index].part;
    const bool chosen = index == context.app.active();
    const ImVec2 corner = corner_of(part);
    ImGui::GetWindowDrawList()->AddRect(
        corner, {corner.x + static_cast<float>(part.width), corner.y + static_cast<float>(part.height)},
        ImGui::GetColorU32(chosen ? theme.accent : theme.edge), 0, 0, Gui::current().px(chosen ? 2.0f : 1.0f));
    const float middle = corner.x + 0.5f * static_cast<float>(part.width);
    const std::string text = caption(*all[index].run->config, differences, index);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    draw_plate({middle - 0.5f * size.x, corner.y + size.y + Gui::current().px(18)}, text,
               chosen ? theme.accent : theme.text);
  }
}

void TerrainWindow::draw_troubles(const PanelContext& context) const {
  const Gui& gui = Gui::current();
  const Snapshot& now = context.app.now();
  const ImVec2 corner{static_cast<float>(area_.left) + gui.px(12),
                      static_cast<float>(area_.top + area_.height) - gui.px(44)};
  float low = corner.y;
  const auto line = [&](const std::string& text, const ImVec4& colour) {
    draw_plate({corner.x, low}, text, colour);
    low -= gui.px(28);
  };
  if (now.activity == Activity::failed) {
    line("The terrain stands as it was before that step. Save it (Export, checkpoint) or Reset.", gui.theme().text);
    line("A step failed: " + now.message, gui.theme().lost);
  }
  if (now.activity == Activity::building) line("Making the terrain \u2026", gui.theme().accent);
}

void TerrainWindow::draw_empty(PanelContext& context) const {
  const Gui& gui = Gui::current();
  const bool building = context.app.now().activity == Activity::building;
  ImGui::SetCursorPosY(0.4f * static_cast<float>(area_.height));
  if (building) {
    centred("Making the terrain \u2026", gui.theme().accent);
    return;
  }
  centred("No terrain yet.", gui.theme().text);
  ImGui::Dummy({0, gui.px(8)});
  const float wide = gui.px(180);
  ImGui::SetCursorPosX(0.5f * (ImGui::GetWindowWidth() - 2 * wide - gui.px(8)));
  if (button("Choose a preset", {.tooltip = "The gallery of terrains that are ready to grow (G)",
                                 .look = ButtonLook::accent,
                                 .size = {wide, 0}})) {
    context.open(panel_title::gallery);
  }
  ImGui::SameLine();
  if (button("Create from the setup",
             {.tooltip = "Make the terrain that the SETUP panel describes", .size = {wide, 0}})) {
    context.app.create();
  }
}

}  // namespace erg::ui
