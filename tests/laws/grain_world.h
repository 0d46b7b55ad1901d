// Small beds for the laws of grains.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "analysis/migration.h"
#include "compute/executor.h"
#include "forcing/bearing.h"
#include "forcing/wind_frame.h"
#include "models/grains/grain_law.h"
#include "models/grains/grains.h"
#include "sim/make_executor.h"
#include "world.h"

namespace erg::test {

using GrainSettings = std::vector<std::pair<std::string, ParameterValue>>;

inline ParameterValues grain_parameters(const GrainSettings& settings) {
  ParameterValues values(models::grain_binding().declarations());
  for (const auto& [key, value] : settings) values.set(key, value);
  return values;
}
inline models::GrainValues grain_values(const GrainSettings& settings = {}) {
  return models::grain_binding().read(grain_parameters(settings));
}

/// Grains in still air.
inline models::GrainLaw calm_law(const GrainSettings& settings = {}) {
  models::GrainLaw law = models::grain_law(grain_values(settings), {270, 0.1}, forcing::wind_frame({8, 8}, 270), 0.01);
  for (float& speed : law.wind_speed) speed = 0;
  return law;
}

/// A model, its bed (level, unless another is given) and an executor.
struct GrainRun {
  explicit GrainRun(const GrainSettings& settings, Extent extent = {64, 64}, std::int32_t parcels = 200)
      : GrainRun(settings, level_bed(settings, extent, parcels)) {}
  GrainRun(const GrainSettings& settings, Terrain bed)
      : model(grain_values(settings)),
        terrain(std::move(bed)),
        executor(sim::make_executor({.name = "cpu", .threads = 2})) {
    model.begin(terrain);
  }

  static Terrain level_bed(const GrainSettings& settings, Extent extent, std::int32_t parcels) {
    Terrain terrain(extent, 0.01, models::GrainModel(grain_values(settings)).quantum(), Boundary::torus);
    terrain.edit_mobile().fill(parcels);
    terrain.open_ledger();
    return terrain;
  }

  models::StepReport steps(int count, forcing::Forcing wind) {
    models::StepReport total;
    for (int k = 0; k < count; ++k) {
      total += model.step(terrain, wind, {5, step++}, *executor);
      executor->sync_to_host(terrain);
      if (step % 5 == 0) migration.observe(static_cast<std::int64_t>(step), surface());
    }
    return total;
  }
  analysis::CoarseSurface surface() const { return analysis::coarse_surface(terrain, analysis::Layer::surface); }
  /// Cells a step along the wind.
  double downwind_speed(double bearing) const {
    const analysis::Shift velocity = migration.velocity().value_or(analysis::Shift{});
    const forcing::Direction toward = forcing::downwind(bearing);
    return velocity.x * toward.x + velocity.y * toward.y;
  }
  double reading(const std::string& key) const {
    for (const models::Diagnostic& one : model.diagnostics()) {
      if (one.key == key) return one.value;
    }
    ADD_FAILURE() << "no reading " << key;
    return 0;
  }

  models::GrainModel model;
  Terrain terrain;
  std::unique_ptr<compute::Executor> executor;
  std::uint64_t step = 0;
  analysis::MigrationTracker migration;
};

}  // namespace erg::test
