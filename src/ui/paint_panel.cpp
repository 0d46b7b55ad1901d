// PAINT: brushes of sand and rock.
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "studio/studio.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace erg {
namespace {

constexpr std::int64_t most_amount = 50;

class PaintPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::paint; }
  Dock dock() const override { return Dock::right; }
  void draw(Desk& desk) override;

 private:
  void draw_brush(const Studio& studio);
  void choose(const char* label, bool& chosen, bool value, const std::string& hint) const;
  static void draw_undo(Studio& studio);
  void stroke(Desk& desk);
  void mark_rim(Desk& desk) const;

  bool on_ = false;
  bool rock_ = false;
  bool takes_ = false;
  double radius_ = 8;
  std::int64_t amount_ = 2;
  std::uint64_t stroke_ = 0;
  std::optional<CellPlace> last_;
};

void PaintPanel::choose(const char* label, bool& chosen, bool value, const std::string& hint) const {
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  const ButtonLook look = chosen == value ? ButtonLook::accent : ButtonLook::plain;
  const float width = value ? -1.0f : half;
  if (button(label, {.tooltip = hint, .look = look, .size = {width, 0}})) chosen = value;
}

void PaintPanel::draw_brush(const Studio& studio) {
  const bool snow =
      studio.now().has_runs() && find_model(studio.now().runs.front().config->model).info.material == Material::snow;
  choose(snow ? "SNOW##mobile" : "SAND##mobile", rock_, false, "What the wind moves.");
  ImGui::SameLine();
  choose("ROCK", rock_, true, "Bedrock, which nothing moves. What lies on it is lifted along.");
  choose("PUT", takes_, false, "Each touch adds.");
  ImGui::SameLine();
  choose("TAKE", takes_, true, "Each touch takes away.");
  real_row({.label = "radius", .unit = "cells", .tooltip = "From the middle of the brush to its rim."}, radius_, 1,
           128);
  integer_row(
      {.label = "amount", .unit = "slabs", .tooltip = "Slabs at the middle for each touch; fewer toward the rim."},
      amount_, 1, most_amount);
}

void PaintPanel::draw_undo(Studio& studio) {
  const Snapshot& now = studio.now();
  const auto count_text = [](std::size_t count, const char* what) {
    return std::to_string(count) + (count == 1 ? " edit can be " : " edits can be ") + what + ".";
  };
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (button("UNDO", {.tooltip = "The ground exactly as it was before the last stroke, the clock too. " +
                                 count_text(now.undo_count, "undone"),
                      .unavailable = now.undo_count == 0 ? "Nothing was painted." : "",
                      .size = {half, 0}})) {
    studio.runner().undo();
  }
  ImGui::SameLine();
  if (button("REDO", {.tooltip = count_text(now.redo_count, "done again"),
                      .unavailable = now.redo_count == 0 ? "Nothing was undone." : "",
                      .size = {half, 0}})) {
    studio.runner().redo();
  }
}

void PaintPanel::stroke(Desk& desk) {
  const LandPointer& land = desk.land;
  if (land.pressed) {
    ++stroke_;
    last_.reset();
  }
  if (!(land.pressed || land.held) || !land.cell || land.cell == last_) return;
  // A dab every half radius is enough: the brush falls off smoothly.
  if (last_ && std::hypot(land.cell->x - last_->x, land.cell->y - last_->y) < 0.5 * radius_) return;
  last_ = land.cell;
  Dab dab;
  dab.material = rock_ ? BrushMaterial::rock : BrushMaterial::sand;
  dab.x = land.cell->x + 0.5;
  dab.y = land.cell->y + 0.5;
  dab.radius = radius_;
  dab.amount = static_cast<std::int32_t>(takes_ ? -amount_ : amount_);
  desk.studio.runner().paint(desk.studio.shown(), dab, stroke_);
}

void PaintPanel::mark_rim(Desk& desk) const {
  if (!desk.land.cell) return;
  LandMark rim;
  rim.closed = true;
  constexpr int corners = 48;
  for (int corner = 0; corner < corners; ++corner) {
    const double angle = radians(360.0 * corner / corners);
    rim.points.push_back(
        {desk.land.cell->x + radius_ * std::cos(angle), desk.land.cell->y + radius_ * std::sin(angle)});
  }
  desk.marks.push_back(rim);
}

void PaintPanel::draw(Desk& desk) {
  if (!desk.studio.now().has_runs()) {
    explain("There is no land to paint on yet.");
    return;
  }
  if (button(on_ ? "PUT THE BRUSH DOWN" : "TAKE THE BRUSH",
             {.tooltip = on_ ? "The mouse turns the view again." : "Then drag over the land; it may run meanwhile.",
              .look = on_ ? ButtonLook::accent : ButtonLook::plain,
              .size = {-1, 0}})) {
    on_ = !on_;
  }
  draw_brush(desk.studio);
  draw_undo(desk.studio);
  if (!on_) return;
  desk.tool = LandTool::paint;
  stroke(desk);
  mark_rim(desk);
}

}  // namespace

std::unique_ptr<Panel> make_paint_panel() { return std::make_unique<PaintPanel>(); }

}  // namespace erg
