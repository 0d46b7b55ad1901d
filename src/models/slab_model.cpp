#include "models/slab_model.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "core/units.h"
#include "wind/shadow.h"

namespace erg {
namespace {

StandingSteps standing_steps(const ParameterValues& values, double cell_size) {
  return StandingSteps::of_angle(values.real("repose_angle"), cell_size, values.real("slab_height"));
}

}  // namespace

Parameters slab_parameters(const SlabFamily& family) {
  Parameters parameters{
      at_start(real_parameter("slab_height", "Slab height", "m", family.slab_height, 0.001, 100,
                              "Height of one slab: the smallest amount of sand that moves.", "Werner 1995")),
      real_parameter("repose_angle", "Angle of repose", "deg", family.repose_angle, 1, 80,
                     "Slopes steeper than this slide. Slabs are coarse: the step in slabs that it means is "
                     "tan(angle) * cell_size / slab_height, rounded up.",
                     family.repose_angle == 30 ? "Werner 1995" : "Momiji et al. 2000"),
      real_parameter("shadow_angle", "Shadow angle", "deg", 15, 1, 80,
                     "Angle of the shadow line behind a crest; slabs that reach the shadow stay.", "Werner 1995"),
      real_parameter("p_sand", "Deposition on sand", "", 0.6, 0, 1, "Chance that a slab stays where sand lies.",
                     "Werner 1995; Cimbura 2022, table 6.1"),
      real_parameter("p_bare", "Deposition on bare ground", "", 0.4, 0, 1,
                     "Chance that a slab stays on ground without sand.", "Werner 1995; Cimbura 2022, table 6.1")};
  if (family.hop_grows_with_height) {
    parameters.push_back(real_parameter("linear", "Linear speed-up C1", "cells/slab", 0.4, 0, 100,
                                        "How much longer a hop is for each slab above the reference height.",
                                        "Momiji et al. 2000; Cimbura 2022, table 6.2"));
    parameters.push_back(real_parameter("quadratic", "Quadratic speed-up C2", "cells/slab^2", 0.002, 0, 100,
                                        "Further growth with the square of the height above the reference.",
                                        "Momiji et al. 2000; Cimbura 2022, table 6.2"));
  }
  parameters.push_back(choice_parameter("polling", "Polling", family.polling, {"repeated", "nonrepeated"},
                                        "repeated: cells are polled at random, some twice and some never; nonrepeated: "
                                        "each exactly once a step, which forms dunes faster and sharper.",
                                        "Nield & Baas 2008"));
  parameters.push_back(boolean_parameter("forced_erosion", "Forced erosion", false,
                                         "Poll until as many slabs have been lifted as the grid has cells.",
                                         "Cimbura 2022, algorithm 2"));
  parameters.push_back(boolean_parameter(
      "obstacles", "Obstacles stop slabs", true,
      "A flying slab drops before bedrock that stands too steeply; off, slabs cross.", "Cimbura 2022, algorithm 7"));
  parameters.push_back(
      choice_parameter("neighbours", "Sliding to neighbours", "4", {"4", "8"},
                       "4: sand slides along rows and columns, as in print; 8: along diagonals too, which "
                       "gives round cones."));
  if (family.timed_by_flux) {
    parameters.push_back(real_parameter(
        "sand_flux", "Sand flux", "m²/year", 50, 0.001, 100000,
        "Sand (volume with its pores, per metre across the wind) that passes over flat sand in a year. It changes no "
        "dune: it says how long a step is.",
        "the default: about what Paris et al. 2019 imply (hops of 8 m, slabs of 0.1 m, p 0.6, steps of 10 days)"));
  }
  return parameters;
}

std::vector<std::string> explain_slabs(const ParameterValues& values, double cell_size) {
  const StandingSteps steps = standing_steps(values, cell_size);
  const double slab = values.real("slab_height");
  char repose[160];
  std::snprintf(repose, sizeof repose, "repose %g deg: a step of %d slab%s (%.1f deg) stands, a larger one slides",
                values.real("repose_angle"), steps.straight, steps.straight == 1 ? "" : "s",
                degrees(std::atan(steps.straight * slab / cell_size)));
  char shadow[120];
  std::snprintf(shadow, sizeof shadow, "shadow %g deg: the shadow line falls %.3f slabs a cell",
                values.real("shadow_angle"), shadow_fall(values.real("shadow_angle"), cell_size, slab));
  return {repose, shadow};
}

double slab_flux(const ParameterValues& values, double cell_size, double strength) {
  const double p_sand = values.real("p_sand");
  return p_sand > 0 ? strength / p_sand * values.real("slab_height") * cell_size : 0;
}

StepScale slab_step_scale(const ParameterValues& values, double cell_size, double strength) {
  const double flux = slab_flux(values, cell_size, strength);
  return {flux / values.real("sand_flux") * seconds_a_year, flux};
}

SlabModel::SlabModel(const SlabFamily& family, ParameterValues values) : family_(family), values_(std::move(values)) {}

double SlabModel::quantum() const { return values_.real("slab_height"); }

void SlabModel::begin(Terrain& terrain) { check_height(terrain); }

double SlabModel::shadow_fall(double cell_size) const {
  return erg::shadow_fall(values_.real("shadow_angle"), cell_size, quantum());
}

SlabLaw SlabModel::law(const Terrain& terrain) const {
  SlabLaw law;
  if (family_.hop_grows_with_height) {
    law.hop = {values_.real("linear"), values_.real("quadratic"), family_.deviation_weight};
  }
  law.p_sand = values_.real("p_sand");
  law.p_bare = values_.real("p_bare");
  law.shadow_fall = shadow_fall(terrain.cell_size());
  law.lift_in_shadow = family_.lift_in_shadow;
  law.bare = law.covered = standing_steps(values_, terrain.cell_size());
  law.neighbours = values_.text("neighbours") == "8" ? 8 : 4;
  law.repeated_polling = values_.text("polling") == "repeated";
  law.forced_erosion = values_.boolean("forced_erosion");
  law.obstacles = values_.boolean("obstacles");
  law.inflow = terrain.inflow();
  return law;
}

StepReport SlabModel::step(Terrain& terrain, const WindNow& wind, StepKey key, Executor& executor) {
  return executor.step(terrain, law(terrain), wind, key);
}

ModelType slab_model_type(ModelInfo info, SlabFamily family) {
  info.step = slab_step;
  info.strength_label = slab_strength;
  return {std::move(info),
          slab_parameters(family),
          {},
          0,
          [family](const ParameterValues& values) { return std::make_unique<SlabModel>(family, values); },
          explain_slabs,
          slab_step_scale};
}

}  // namespace erg
