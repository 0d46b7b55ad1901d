// PAINT: brushes of sand, rock and plants.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/units.h"
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using models::find_model;
using session::AppModel;
using session::BrushMaterial;
using session::RunSnapshot;

namespace {

constexpr double most_slabs = 1000;  // of one touch
constexpr double least_strength = 0.01;
// So that a stroke is seen at once, on a small terrain and on a large one: shares of the terrain's shorter side and of
// the brush's radius. Such a heap is a hill, and its sides are less steep than sand stands.
constexpr double usual_radius = 1.0 / 24;
constexpr double usual_height = 0.12;
constexpr double spacing = 0.25;             // of the radius, from stamp to stamp of a stroke
constexpr double seconds_of_a_stamp = 0.12;  // while the brush is held still
constexpr int most_stamps = 400;             // between two frames

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
  void draw(PanelContext& context) override;

 private:
  void draw_materials(const RunSnapshot& run);
  void draw_layers(const RunSnapshot& run);
  void draw_brush(const RunSnapshot& run);
  void draw_amount(const Terrain& terrain);
  static void draw_undo(AppModel& app);
  void stroke(PanelContext& context);
  void put_stamp(AppModel& app, double x, double y) const;
  double radius(const Terrain& terrain) const;
  double amount(const Terrain& terrain) const;
  void mark_rim(PanelContext& context) const;

  bool on_ = false;
  BrushMaterial material_ = BrushMaterial::sand;
  std::string field_;  // the layer's key, for BrushMaterial::field
  bool takes_ = false;
  std::optional<double> radius_;  ///< cells; none: as suits the terrain
  std::optional<double> amount_;  ///< m; none: as suits the radius
  double strength_ = 0.25;
  std::uint64_t stroke_ = 0;
  std::optional<std::array<double, 2>> last_;  ///< cells: where the stroke's last stamp went
  double held_still_ = 0;                      ///< s since that stamp
};

double PaintPanel::radius(const Terrain& terrain) const {
  const double usual = std::clamp(std::round(usual_radius * std::min(terrain.nx(), terrain.ny())), 3.0, 64.0);
  return radius_.value_or(usual);
}

double PaintPanel::amount(const Terrain& terrain) const {
  const double usual = usual_height * radius(terrain) * terrain.cell_size();
  const double slab = terrain.quantum();
  return amount_.value_or(slab * std::clamp(std::round(usual / slab), 1.0, most_slabs));
}

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
  double cells = radius(*run.terrain);
  const RowEvent event = real_row({.label = "radius",
                                   .unit = "cells",
                                   .tooltip = "From the middle of the brush to its rim. A cell is " +
                                              figure_text(run.terrain->cell_size()) + " m wide.",
                                   .changed = radius_.has_value()},
                                  cells, 1, 128);
  if (event == RowEvent::changed) radius_ = cells;
  if (event == RowEvent::reset) radius_.reset();
  if (material_ != BrushMaterial::field) return draw_amount(*run.terrain);
  const FieldInfo& info = find_field(run.terrain->fields(), field_)->info;
  real_row({.label = "strength",
            .unit = info.unit,
            .tooltip = "What each touch adds at the middle; less toward the rim. It stays within the layer's range."},
           strength_, least_strength, info.maximum - info.minimum);
}

void PaintPanel::draw_amount(const Terrain& terrain) {
  const double slab = terrain.quantum();
  double metres = amount(terrain);
  const RowEvent event =
      real_row({.label = "amount",
                .unit = "m",
                .tooltip = "Height at the middle for each touch; less toward the rim. Holding the brush still goes on "
                           "touching. It is put in whole slabs of " +
                           figure_text(slab) + " m.",
                .changed = amount_.has_value()},
               metres, slab, most_slabs * slab);
  if (event == RowEvent::changed) amount_ = slab * std::max(1.0, std::round(metres / slab));
  if (event == RowEvent::reset) amount_.reset();
}

void PaintPanel::draw_undo(AppModel& app) {
  const session::Snapshot& now = app.now();
  const auto count_text = [](std::size_t count, const char* what) {
    return std::to_string(count) + (count == 1 ? " edit can be " : " edits can be ") + what + ".";
  };
  const float half = share_of_width(2);
  if (button("UNDO", {.tooltip = "The ground exactly as it was before the last stroke, the clock too. " +
                                 count_text(now.undo_count, "undone"),
                      .unavailable = now.undo_count == 0 ? "Nothing was painted." : "",
                      .size = {half, 0}})) {
    app.runner().undo();
  }
  ImGui::SameLine();
  if (button("REDO", {.tooltip = count_text(now.redo_count, "done again"),
                      .unavailable = now.redo_count == 0 ? "Nothing was undone." : "",
                      .size = {half, 0}})) {
    app.runner().redo();
  }
}

void PaintPanel::stroke(PanelContext& context) {
  const TerrainPointer& pointer = context.pointer;
  if (pointer.pressed) {
    ++stroke_;
    last_.reset();
  }
  if (!pointer.cell) last_.reset();  // what comes in again elsewhere begins there
  if (!(pointer.pressed || pointer.held) || !pointer.cell) return;
  const std::array<double, 2> here{pointer.cell->x + 0.5, pointer.cell->y + 0.5};
  held_still_ += static_cast<double>(ImGui::GetIO().DeltaTime);
  if (!last_ || held_still_ >= seconds_of_a_stamp) {
    put_stamp(context.app, here[0], here[1]);
    last_ = here;
    held_still_ = 0;
    return;
  }
  // However far the pointer has come since the last frame, the stroke has no gaps.
  const double gap = std::max(1.0, spacing * radius(*context.app.active_run()->terrain));
  const std::array<double, 2> from = *last_;
  const double way = std::hypot(here[0] - from[0], here[1] - from[1]);
  const int stamps = std::min(static_cast<int>(way / gap), most_stamps);
  for (int stamp = 1; stamp <= stamps; ++stamp) {
    const double part = stamp * gap / way;
    last_ = {from[0] + part * (here[0] - from[0]), from[1] + part * (here[1] - from[1])};
    put_stamp(context.app, (*last_)[0], (*last_)[1]);
    held_still_ = 0;
  }
}

void PaintPanel::put_stamp(AppModel& app, double x, double y) const {
  const Terrain& terrain = *app.active_run()->terrain;
  const auto slabs = static_cast<std::int32_t>(std::lround(amount(terrain) / terrain.quantum()));
  session::BrushStamp stamp;
  stamp.material = material_;
  stamp.x = x;
  stamp.y = y;
  stamp.radius = radius(terrain);
  stamp.amount = takes_ ? -slabs : slabs;
  stamp.field = field_;
  stamp.strength = takes_ ? -strength_ : strength_;
  app.runner().paint(app.shown(), stamp, stroke_);
}

void PaintPanel::mark_rim(PanelContext& context) const {
  if (!context.pointer.cell) return;
  const double reach = radius(*context.app.active_run()->terrain);
  TerrainMark rim;
  rim.closed = true;
  constexpr int corners = 48;
  for (int corner = 0; corner < corners; ++corner) {
    const double angle = radians(360.0 * corner / corners);
    rim.points.push_back(
        {context.pointer.cell->x + reach * std::cos(angle), context.pointer.cell->y + reach * std::sin(angle)});
  }
  context.marks.push_back(rim);
}

void PaintPanel::draw(PanelContext& context) {
  if (!context.app.now().has_runs()) {
    explain("There is no terrain to paint on yet.");
    return;
  }
  if (button(on_ ? "PUT THE BRUSH DOWN" : "TAKE THE BRUSH",
             {.tooltip = on_ ? "The mouse turns the view again." : "Then drag over the terrain; it may run meanwhile.",
              .look = on_ ? ButtonLook::accent : ButtonLook::plain,
              .size = {-1, 0}})) {
    on_ = !on_;
  }
  const RunSnapshot& run = *context.app.active_run();
  draw_materials(run);
  draw_brush(run);
  draw_undo(context.app);
  if (!on_) return;
  context.tool = TerrainTool::paint;
  stroke(context);
  mark_rim(context);
}

}  // namespace

std::unique_ptr<Panel> make_paint_panel() { return std::make_unique<PaintPanel>(); }

}  // namespace erg::ui
