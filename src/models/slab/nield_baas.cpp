#include "models/slab/nield_baas.h"

#include <cstdio>
#include <memory>
#include <utility>

#include "core/units.h"
#include "models/slab/plants.h"
#include "models/slab/slab_model.h"

namespace erg::models {
namespace {

constexpr SlabFamily plant_family{
    .repose_angle = 30, .slab_height = 0.1, .polling = "nonrepeated", .timed_by_flux = false};

/// Slabs, and what holds them.
struct PlantedSlabs : SlabValues, PlantValues {
  double vegetated_repose_angle = 40;  ///< deg
  double repose_from = 0;
  bool lift_in_shadow = false;
};

Binding<PlantedSlabs> nield_baas_binding() {
  const Binding<PlantedSlabs>::Entries own{{&PlantedSlabs::vegetated_repose_angle,
                                            {.key = "vegetated_repose_angle",
                                             .label = "Repose under plants",
                                             .unit = "deg",
                                             .default_value = 40.0,
                                             .minimum = 1,
                                             .maximum = 80,
                                             .meaning = "Angle of repose where plants hold the sand.",
                                             .source = "Nield & Baas 2008"}},
                                           {&PlantedSlabs::repose_from,
                                            {.key = "repose_from",
                                             .label = "Plants hold from",
                                             .default_value = 0.3,
                                             .minimum = 0.01,
                                             .maximum = 1,
                                             .meaning = "Effectiveness rho from which on slopes are held.",
                                             .source = "Nield & Baas 2008"}},
                                           {&PlantedSlabs::lift_in_shadow,
                                            {.key = "lift_in_shadow",
                                             .label = "Lifting in shadow",
                                             .default_value = false,
                                             .meaning = "Whether sand lifts in the wind shadow, as in Werner 1995."}}};
  return Binding<PlantedSlabs>(slab_binding(plant_family), own, plant_binding());
}

std::vector<std::string> explain_plants(const PlantedSlabs& values, double cell_size) {
  std::vector<std::string> lines = explain_slabs(values, cell_size);
  const int step = ReposeSteps::of_angle(values.vegetated_repose_angle, cell_size, values.slab_height).straight;
  char line[120];
  std::snprintf(line, sizeof line, "repose under plants %g°: a step of %d slabs stands", values.vegetated_repose_angle,
                step);
  lines.insert(lines.begin() + 1, line);
  return lines;
}

StepScale plant_step_scale(const PlantedSlabs& values, double cell_size, double strength) {
  return {seconds_a_year / static_cast<double>(values.steps_per_year), slab_flux(values, cell_size, strength)};
}

class NieldBaas : public SlabModel {
 public:
  explicit NieldBaas(const PlantedSlabs& values) : SlabModel(plant_family, values), values_(values) {}

  void prepare(const InitContext& context) override { context_ = context; }

  void begin(Terrain& terrain) override {
    SlabModel::begin(terrain);
    plants_ = std::make_unique<Plants>(values_, context_.seed);
    plants_->begin(terrain, std::exchange(context_.picture, nullptr));
  }

  void edited(Terrain& terrain) override { plants_->cover(terrain); }

  StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) override {
    SlabLaw law = SlabModel::law(terrain);
    law.lift_in_shadow = values_.lift_in_shadow;
    law.covered = ReposeSteps::of_angle(values_.vegetated_repose_angle, terrain.cell_size(), quantum());
    law.covered_from = static_cast<std::uint8_t>(values_.repose_from * 255 + 0.5);
    law.cover = &plants_->cover(terrain);
    StepReport report = move_slabs(executor, terrain, law, wind, key);
    if ((key.step + 1) % static_cast<std::uint64_t>(values_.steps_per_year) != 0) return report;
    executor.sync_to_host(terrain);
    report.finished = plants_->grow(terrain, key, executor);
    if (report.finished) report.why_finished = "plants hold all of the sand, so nothing can move any more";
    return report;
  }

 private:
  PlantedSlabs values_;
  InitContext context_;
  std::unique_ptr<Plants> plants_;
};

}  // namespace

ModelType nield_baas() {
  return ModelOf<PlantedSlabs>{
      .info = {.key = "nield_baas",
               .title = "Nield & Baas 2008",
               .citation =
                   "Nield, J. M. & Baas, A. C. W. (2008). Investigating parabolic and nebkha dune formation using "
                   "a cellular automaton modelling approach. Earth Surface Processes and Landforms 33, 724-740.",
               .produces = "nebkhas, parabolic dunes, blowouts, dunes around islands of plants",
               .limitations = "water, seasons of growth, roots; wind speed-up over dunes",
               .step = std::string(slab_step) + "; steps_per_year of them are a year",
               .strength_label = slab_strength,
               .painted = painted_plants()},
      .parameters = nield_baas_binding(),
      .fields = plant_fields(),
      // The cover, here and with the executor; where each species stood, while plants spread.
      .working_bytes = 6,
      .make = [](const PlantedSlabs& values) { return std::make_unique<NieldBaas>(values); },
      .explain = explain_plants,
      .step_scale = plant_step_scale};
}

}  // namespace erg::models
