// PAINT: brushes of sand, rock and plants.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/units.h"
#include "studio/studio.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace erg {
namespace {

constexpr std::int64_t most_amount = 50;
constexpr double least_strength = 0.01;

// A button that stays down while `chosen`; true when it was pressed.
bool choice(const std::string& label, bool chosen, float width, const std::string& hint) {
  const ButtonLook look = chosen ? ButtonLook::accent : ButtonLook::plain;
  return button(label.c_str(), {.tooltip = hint, .look = look, .size = {width, 0}});
}

std::string capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::toupper(letter); });
  return text;
}

class PaintPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::paint; }
  Dock dock() const override { return Dock::right; }
  void draw(Desk& desk) override;

 private:
  void draw_materials(const RunSnapshot& run);
  void draw_layers(const RunSnapshot& run);
  void draw_brush(const RunSnapshot& run);
  static void draw_undo(Studio& studio);
  void stroke(Desk& desk);
  void mark_rim(Desk& desk) const;

  bool on_ = false;
  BrushMaterial material_ = BrushMaterial::sand;
  std::string field_;  // the layer's key, for BrushMaterial::field
  bool takes_ = false;
  double radius_ = 8;
  std::int64_t amount_ = 2;
  double strength_ = 0.25;
  std::uint64_t stroke_ = 0;
  std::optional<CellPlace> last_;
};

void PaintPanel::draw_materials(const RunSnapshot& run) {
  const bool snow = find_model(run.config->model).info.material == Material::snow;
  const float half = share_of_width(2);
  if (choice(snow ? "SNOW##mobile" : "SAND##mobile", material_ == BrushMaterial::sand, half, "What the wind moves.")) {
    material_ = BrushMaterial::sand;
  }
  ImGui::SameLine();
  if (choice("ROCK", material_ == BrushMaterial::rock, half,
             "Bedrock, which nothing moves. What lies on it is lifted along.")) {
    material_ = BrushMaterial::rock;
  }
  draw_layers(run);
}

// The layers of the model that can be painted, in a row.
void PaintPanel::draw_layers(const RunSnapshot& run) {
  const std::vector<std::string>& keys = find_model(run.config->model).info.painted;
  if (material_ == BrushMaterial::field && std::ranges::find(keys, field_) == keys.end()) {
    material_ = BrushMaterial::sand;  // another model, without that layer
  }
  if (keys.empty()) return;
  const float width = share_of_width(static_cast<int>(keys.size()));
  for (const std::string& key : keys) {
    if (key != keys.front()) ImGui::SameLine();
    const FieldInfo& info = find_field(run.terrain->fields(), key)->info;
    const bool chosen = material_ == BrushMaterial::field && field_ == key;
    if (!choice(capitals(info.label) + "##" + key, chosen, width, info.meaning)) continue;
    material_ = BrushMaterial::field;
    field_ = key;
  }
}

void PaintPanel::draw_brush(const RunSnapshot& run) {
  const float half = share_of_width(2);
  if (choice("PUT", !takes_, half, "Each touch adds.")) takes_ = false;
  ImGui::SameLine();
  if (choice("TAKE", takes_, half, "Each touch takes away.")) takes_ = true;
  real_row({.label = "radius", .unit = "cells", .tooltip = "From the middle of the brush to its rim."}, radius_, 1,
           128);
  if (material_ != BrushMaterial::field) {
    integer_row(
        {.label = "amount", .unit = "slabs", .tooltip = "Slabs at the middle for each touch; fewer toward the rim."},
        amount_, 1, most_amount);
    return;
  }
  const FieldInfo& info = find_field(run.terrain->fields(), field_)->info;
  real_row({.label = "strength",
            .unit = info.unit,
            .tooltip = "What each touch adds at the middle; less toward the rim. It stays within the layer's range."},
           strength_, least_strength, info.maximum - info.minimum);
}

void PaintPanel::draw_undo(Studio& studio) {
  const Snapshot& now = studio.now();
  const auto count_text = [](std::size_t count, const char* what) {
    return std::to_string(count) + (count == 1 ? " edit can be " : " edits can be ") + what + ".";
  };
  const float half = share_of_width(2);
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
  dab.material = material_;
  dab.x = land.cell->x + 0.5;
  dab.y = land.cell->y + 0.5;
  dab.radius = radius_;
  dab.amount = static_cast<std::int32_t>(takes_ ? -amount_ : amount_);
  dab.field = field_;
  dab.strength = takes_ ? -strength_ : strength_;
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
  const RunSnapshot& run = *desk.studio.active_run();
  draw_materials(run);
  draw_brush(run);
  draw_undo(desk.studio);
  if (!on_) return;
  desk.tool = LandTool::paint;
  stroke(desk);
  mark_rim(desk);
}

}  // namespace

std::unique_ptr<Panel> make_paint_panel() { return std::make_unique<PaintPanel>(); }

}  // namespace erg
