// Small worlds for the laws: a terrain, a law and a wind, run on any executor.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "compute/executor.h"
#include "core/terrain.h"
#include "models/model.h"
#include "models/slab/slab_model.h"
#include "sim/make_executor.h"

namespace erg::test {

/// An executor to loop over, with the name that a failing test shows.
struct Machine {
  std::string name;
  compute::ExecutorOptions options;
};

inline std::vector<Machine> machines() {
  return {{"serial", {.name = "serial"}},
          {"cpu, 1 thread", {.name = "cpu", .threads = 1, .sweeps = 16}},
          {"cpu, 3 threads, K 4", {.name = "cpu", .threads = 3, .sweeps = 4, .lines_a_thread = 1}}};
}

/// One run, small and quick.
struct World {
  std::string model = "werner";
  Extent extent{48, 40};
  Boundary boundary = Boundary::torus;
  double inflow = 0;
  forcing::Forcing wind{270, 5};
  std::uint64_t seed = 7;
  std::vector<std::pair<std::string, ParameterValue>> settings = {};
  std::int32_t sand = 3;
  double spread = 0;  ///< of the wind's bearing, degrees; it swings every step

  /// Sand strewn unevenly (0 to 2 * sand, keyed by the cell), on level bedrock.
  Terrain strewn() const {
    Terrain terrain(extent, cell_size(), quantum(), boundary);
    terrain.set_inflow(inflow);
    Grid<std::int32_t>& mobile = terrain.edit_mobile();
    for (std::size_t cell = 0; cell < mobile.size(); ++cell) {
      mobile[cell] =
          static_cast<std::int32_t>(random_below({seed, 0}, 0, cell, 99, static_cast<std::uint32_t>(2 * sand + 1)));
    }
    terrain.open_ledger();
    return terrain;
  }

  ParameterValues values() const {
    ParameterValues values(models::find_model(model).parameters);
    for (const auto& [key, value] : settings) {
      if (values.find(key) != nullptr) values.set(key, value);  // no model has all of them
    }
    return values;
  }
  /// False where the model does not know one of the settings.
  bool applies() const {
    const ParameterValues declared(models::find_model(model).parameters);
    return std::ranges::all_of(settings, [&](const auto& one) { return declared.find(one.first) != nullptr; });
  }
  bool moves_slabs() const { return values().find("slab_height") != nullptr; }
  double quantum() const { return models::find_model(model).make(values())->quantum(); }
  /// Grains make ripples of centimetres.
  double cell_size() const { return moves_slabs() ? 1.0 : 0.01; }
  /// The wind as the model has it: cells a hop stand for m/s at a height of 10 m, within what nature has.
  forcing::Forcing model_wind() const {
    if (model == "snow_sintering") return {wind.bearing, 14};
    return moves_slabs() ? wind : forcing::Forcing{wind.bearing, std::clamp(1.6 * wind.strength, 8.0, 12.0)};
  }

  /// Runs `steps` steps and settles; the sum of what they did.
  models::StepReport run(Terrain& terrain, const compute::ExecutorOptions& options, int steps,
                         int first_step = 0) const {
    const auto executor = sim::make_executor(options);
    return run(terrain, *executor, steps, first_step);
  }
  models::StepReport run(Terrain& terrain, compute::Executor& executor, int steps, int first_step = 0) const {
    const auto made = models::find_model(model).make(values());
    made->prepare({.seed = seed});
    made->begin(terrain);
    models::StepReport total;
    for (int step = first_step; step < first_step + steps; ++step) {
      forcing::Forcing now = model_wind();
      now.bearing = fold_bearing(now.bearing + forcing::wind_swing(spread, 0, seed, step));
      total += made->step(terrain, now, {seed, static_cast<std::uint64_t>(step)}, executor);
    }
    executor.sync_to_host(terrain);
    return total;
  }
};

/// Two walls of rock, one of them across the grid's edge.
inline void raise_rocks(Terrain& terrain, std::int32_t height) {
  Grid<std::int32_t>& bedrock = terrain.edit_bedrock();
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      const bool middle =
          x >= terrain.nx() / 3 && x < terrain.nx() / 2 && y >= terrain.ny() / 4 && y < terrain.ny() / 2;
      const bool edge = (x < 2 || x >= terrain.nx() - 2) && y >= terrain.ny() / 2;
      if (!middle && !edge) continue;
      bedrock(x, y) = height;
      mobile(x, y) = 0;
    }
  }
  terrain.open_ledger();
}

}  // namespace erg::test
