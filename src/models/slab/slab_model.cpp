#include "models/slab/slab_model.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "core/units.h"
#include "kernels/shadow.h"
#include "models/slab/terrain_heights.h"

namespace erg::models {
namespace {

ReposeSteps repose_steps(const SlabValues& values, double cell_size) {
  return ReposeSteps::of_angle(values.repose_angle, cell_size, values.slab_height);
}

}  // namespace

Binding<SlabValues> slab_binding(const SlabFamily& family) {
  Binding<SlabValues>::Entries parameters{
      {&SlabValues::slab_height,
       {.key = "slab_height",
        .label = "Slab height",
        .unit = "m",
        .default_value = family.slab_height,
        .minimum = 0.001,
        .maximum = 100,
        .meaning = "Height of one slab: the smallest amount of sand that moves.",
        .source = "Werner 1995",
        .at_start = true}},
      {&SlabValues::repose_angle,
       {.key = "repose_angle",
        .label = "Angle of repose",
        .unit = "deg",
        .default_value = family.repose_angle,
        .minimum = 1,
        .maximum = 80,
        .meaning = "Slopes steeper than this slide. Slabs are coarse: the step in slabs that it means is "
                   "tan(angle) * cell_size / slab_height, rounded up.",
        .source = family.repose_angle == 30 ? "Werner 1995" : "Momiji et al. 2000"}},
      {&SlabValues::shadow_angle,
       {.key = "shadow_angle",
        .label = "Shadow angle",
        .unit = "deg",
        .default_value = 15.0,
        .minimum = 1,
        .maximum = 80,
        .meaning = "Angle of the shadow line behind a crest; slabs that reach the shadow stay.",
        .source = "Werner 1995"}},
      {&SlabValues::p_sand,
       {.key = "p_sand",
        .label = "Deposition on sand",
        .default_value = 0.6,
        .minimum = 0,
        .maximum = 1,
        .meaning = "Chance that a slab stays where sand lies.",
        .source = "Werner 1995; Cimbura 2022, table 6.1"}},
      {&SlabValues::p_bare,
       {.key = "p_bare",
        .label = "Deposition on bare ground",
        .default_value = 0.4,
        .minimum = 0,
        .maximum = 1,
        .meaning = "Chance that a slab stays on ground without sand.",
        .source = "Werner 1995; Cimbura 2022, table 6.1"}}};
  if (family.hop_grows_with_height) {
    parameters.push_back({&SlabValues::linear,
                          {.key = "linear",
                           .label = "Linear speed-up C1",
                           .unit = "cells/slab",
                           .default_value = 0.4,
                           .minimum = 0,
                           .maximum = 100,
                           .meaning = "How much longer a hop is for each slab above the reference height.",
                           .source = "Momiji et al. 2000; Cimbura 2022, table 6.2"}});
    parameters.push_back({&SlabValues::quadratic,
                          {.key = "quadratic",
                           .label = "Quadratic speed-up C2",
                           .unit = "cells/slab^2",
                           .default_value = 0.002,
                           .minimum = 0,
                           .maximum = 100,
                           .meaning = "Further growth with the square of the height above the reference.",
                           .source = "Momiji et al. 2000; Cimbura 2022, table 6.2"}});
  }
  parameters.push_back({&SlabValues::polling,
                        {.key = "polling",
                         .label = "Polling",
                         .default_value = family.polling,
                         .choices = {"repeated", "nonrepeated"},
                         .meaning = "repeated: cells are polled at random, some twice and some never; nonrepeated: "
                                    "each exactly once a step, which forms dunes faster and sharper.",
                         .source = "Nield & Baas 2008"}});
  parameters.push_back({&SlabValues::forced_erosion,
                        {.key = "forced_erosion",
                         .label = "Forced erosion",
                         .default_value = false,
                         .meaning = "Poll until as many slabs have been lifted as the grid has cells.",
                         .source = "Cimbura 2022, algorithm 2"}});
  parameters.push_back({&SlabValues::obstacles,
                        {.key = "obstacles",
                         .label = "Obstacles stop slabs",
                         .default_value = true,
                         .meaning = "A flying slab drops before bedrock that stands too steeply; off, slabs cross.",
                         .source = "Cimbura 2022, algorithm 7"}});
  parameters.push_back({&SlabValues::neighbours,
                        {.key = "neighbours",
                         .label = "Sliding to neighbours",
                         .default_value = "4",
                         .choices = {"4", "8"},
                         .meaning = "4: sand slides along rows and columns, as in print; 8: along diagonals too, which "
                                    "gives round cones."}});
  if (family.timed_by_flux) {
    parameters.push_back(
        {&SlabValues::sand_flux,
         {.key = "sand_flux",
          .label = "Sand flux",
          .unit = "m²/year",
          .default_value = 50.0,
          .minimum = 0.001,
          .maximum = 100000,
          .meaning = "Sand (volume with its pores, per metre across the wind) that passes over flat sand in a year. It "
                     "changes no "
                     "dune: it says how long a step is.",
          .source = "the default: about what Paris et al. 2019 imply (hops of 8 m, slabs of 0.1 m, p 0.6, steps of 10 "
                    "days)"}});
  }
  return Binding<SlabValues>(parameters);
}

std::vector<std::string> explain_slabs(const SlabValues& values, double cell_size) {
  const ReposeSteps steps = repose_steps(values, cell_size);
  const double slab = values.slab_height;
  char repose[160];
  std::snprintf(repose, sizeof repose, "repose %g°: a step of %d slab%s (%.1f°) stands, a larger one slides",
                values.repose_angle, steps.straight, steps.straight == 1 ? "" : "s",
                degrees(std::atan(steps.straight * slab / cell_size)));
  char shadow[120];
  std::snprintf(shadow, sizeof shadow, "shadow %g°: the shadow line falls %.3f slabs a cell", values.shadow_angle,
                kernels::shadow_fall(values.shadow_angle, cell_size, slab));
  return {repose, shadow};
}

double slab_flux(const SlabValues& values, double cell_size, double strength) {
  const double p_sand = values.p_sand;
  return p_sand > 0 ? strength / p_sand * values.slab_height * cell_size : 0;
}

StepScale slab_step_scale(const SlabValues& values, double cell_size, double strength) {
  const double flux = slab_flux(values, cell_size, strength);
  return {flux / values.sand_flux * seconds_a_year, flux};
}

SlabModel::SlabModel(const SlabFamily& family, const SlabValues& values) : family_(family), values_(values) {}

double SlabModel::quantum() const { return values_.slab_height; }

void SlabModel::begin(Terrain& terrain) { check_height(terrain); }

double SlabModel::shadow_fall(double cell_size) const {
  return erg::kernels::shadow_fall(values_.shadow_angle, cell_size, quantum());
}

SlabLaw SlabModel::law(const Terrain& terrain) const {
  SlabLaw law;
  if (family_.hop_grows_with_height) {
    law.hop = {values_.linear, values_.quadratic, family_.deviation_weight};
  }
  law.p_sand = values_.p_sand;
  law.p_bare = values_.p_bare;
  law.shadow_fall = shadow_fall(terrain.cell_size());
  law.lift_in_shadow = family_.lift_in_shadow;
  law.bare = law.covered = repose_steps(values_, terrain.cell_size());
  law.neighbours = values_.neighbours;
  law.repeated_polling = values_.polling == Polling::repeated;
  law.forced_erosion = values_.forced_erosion;
  law.obstacles = values_.obstacles;
  law.inflow = terrain.inflow();
  return law;
}

StepReport SlabModel::step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) {
  return move_slabs(executor, terrain, law(terrain), wind, key);
}

ModelType slab_model_type(ModelInfo info, SlabFamily family) {
  info.step = slab_step;
  info.strength_label = slab_strength;
  constexpr int growing_steps = 300;
  const std::string steady = "wind.spread=0";
  info.bench_scenes = {{.name = "dunes", .steps = growing_steps, .settings = {steady}},
                       {.name = "swinging wind", .steps = growing_steps},
                       {.name = "oblique wind", .steps = growing_steps, .oblique = true, .settings = {steady}},
                       {.name = "obstacles", .steps = growing_steps, .settings = {steady, "scene.kind=rocks"}}};
  return ModelOf<SlabValues>{
      .info = std::move(info),
      .parameters = slab_binding(family),
      .make = [family](const SlabValues& values) { return std::make_unique<SlabModel>(family, values); },
      .explain = explain_slabs,
      .step_scale = slab_step_scale};
}

}  // namespace erg::models
