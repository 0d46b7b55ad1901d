#include "models/nield_baas.h"

#include <cstdio>
#include <memory>
#include <utility>

#include "core/units.h"
#include "models/plants.h"
#include "models/slab_model.h"

namespace erg {
namespace {

constexpr SlabFamily plant_family{
    .repose_angle = 30, .slab_height = 0.1, .polling = "nonrepeated", .timed_by_flux = false};

Parameters nield_baas_parameters() {
  Parameters parameters = slab_parameters(plant_family);
  parameters.push_back(real_parameter("vegetated_repose_angle", "Repose under plants", "deg", 40, 1, 80,
                                      "Angle of repose where plants hold the sand.", "Nield & Baas 2008"));
  parameters.push_back(real_parameter("repose_from", "Plants hold from", "", 0.3, 0.01, 1,
                                      "Effectiveness rho from which on slopes are held.", "Nield & Baas 2008"));
  parameters.push_back(boolean_parameter("lift_in_shadow", "Lifting in shadow", false,
                                         "Whether sand lifts in the wind shadow, as in Werner 1995."));
  const Parameters plants = plant_parameters();
  parameters.insert(parameters.end(), plants.begin(), plants.end());
  return parameters;
}

std::vector<std::string> explain_plants(const ParameterValues& values, double cell_size) {
  std::vector<std::string> lines = explain_slabs(values, cell_size);
  const int step =
      StandingSteps::of_angle(values.real("vegetated_repose_angle"), cell_size, values.real("slab_height")).straight;
  char line[120];
  std::snprintf(line, sizeof line, "repose under plants %g deg: a step of %d slabs stands",
                values.real("vegetated_repose_angle"), step);
  lines.insert(lines.begin() + 1, line);
  return lines;
}

StepScale plant_step_scale(const ParameterValues& values, double cell_size, double strength) {
  return {seconds_a_year / static_cast<double>(values.integer("steps_per_year")),
          slab_flux(values, cell_size, strength)};
}

class NieldBaas : public SlabModel {
 public:
  explicit NieldBaas(ParameterValues values) : SlabModel(plant_family, std::move(values)) {}

  void prepare(const Beginning& beginning) override { beginning_ = beginning; }

  void begin(Terrain& terrain) override {
    SlabModel::begin(terrain);
    plants_ = std::make_unique<Plants>(values(), beginning_.seed);
    plants_->begin(terrain, std::exchange(beginning_.picture, nullptr));
  }

  void edited(Terrain& terrain) override { plants_->cover(terrain); }

  StepReport step(Terrain& terrain, const WindNow& wind, StepKey key, Executor& executor) override {
    SlabLaw law = SlabModel::law(terrain);
    law.lift_in_shadow = values().boolean("lift_in_shadow");
    law.covered = StandingSteps::of_angle(values().real("vegetated_repose_angle"), terrain.cell_size(), quantum());
    law.covered_from = static_cast<std::uint8_t>(values().real("repose_from") * 255 + 0.5);
    law.cover = &plants_->cover(terrain);
    StepReport report = executor.step(terrain, law, wind, key);
    if ((key.step + 1) % static_cast<std::uint64_t>(values().integer("steps_per_year")) != 0) return report;
    executor.settle(terrain);
    report.finished = plants_->grow(terrain, key, executor);
    if (report.finished) report.why_finished = "plants hold all of the sand, so nothing can move any more";
    return report;
  }

 private:
  Beginning beginning_;
  std::unique_ptr<Plants> plants_;
};

}  // namespace

ModelType nield_baas() {
  return {{.key = "nield_baas",
           .title = "Nield & Baas 2008",
           .citation = "Nield, J. M. & Baas, A. C. W. (2008). Investigating parabolic and nebkha dune formation using "
                       "a cellular automaton modelling approach. Earth Surface Processes and Landforms 33, 724-740.",
           .makes = "nebkhas, parabolic dunes, blowouts, dunes around islands of plants",
           .leaves_out = "water, seasons of growth, roots; wind speed-up over dunes",
           .step = std::string(slab_step) + "; steps_per_year of them are a year",
           .strength_label = slab_strength,
           .painted = painted_plants()},
          nield_baas_parameters(),
          plant_fields(),
          6,  // the cover, here and with the executor; where each species stood, while plants spread
          [](const ParameterValues& values) { return std::make_unique<NieldBaas>(values); },
          explain_plants,
          plant_step_scale};
}

}  // namespace erg
