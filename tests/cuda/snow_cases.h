// Runs of sintering snow that the CUDA executor has to do exactly as `cpu` does, each with something of its own.
#pragma once

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "../laws/world.h"
#include "cases.h"

namespace erg::test {

struct SnowCase {
  std::string name;
  World world;
  std::int32_t rocks = 0;  ///< height, slabs
  int steps = 4;
  int sweeps = 8;
  std::vector<double> bearings = {};  ///< of the steps, if they differ

  ExecutorOptions options() const { return {.name = "cpu", .threads = 2, .sweeps = sweeps}; }
};

inline std::vector<SnowCase> snow_cases() {
  // Metres of snow, loose and bonded, in a wind that lifts both and carries some of it off; hops of some cells.
  const auto drifting = [](Extent extent, double bearing) {
    World world{.model = "snow_sintering", .extent = extent, .wind = {bearing, 14}, .sand = 40};
    world.settings = {{"start_age", 30.0},    {"snowfall", 5.0},      {"suspension_wind", 10.0}, {"hop_factor", 60.0},
                      {"smooth_radius", 2.0}, {"around_radius", 5.0}, {"time_step", 900.0},      {"bonding_time", 4.0}};
    return world;
  };
  const auto with = [](World world, const char* key, ParameterValue value) {
    std::erase_if(world.settings, [&](const auto& setting) { return setting.first == key; });
    world.settings.emplace_back(key, value);
    return world;
  };
  const auto open = [](World world) {
    world.boundary = Boundary::open;
    world.inflow = 0.7;
    return world;
  };
  const auto crowded = [](World world) {  // thousands of slabs come down in one cell at the same time
    world.inflow = 40000;
    return world;
  };
  const auto pattern = [&](World world, const char* name) {
    return with(std::move(world), "strength", std::string(name));
  };
  // The fewer slabs lift, the longer a step has to be.
  const auto longer = [&](World world, double seconds) { return with(std::move(world), "time_step", seconds); };
  const auto hopping = [&](World world, double factor) {
    return longer(with(std::move(world), "hop_factor", factor), 10000.0);
  };
  const auto tall = [&](World world, double slab) {
    return longer(with(std::move(world), "slab_height", slab), 80000.0);
  };
  return {
      {"straight", drifting({70, 45}, 270), 0, 18},  // long enough to show its strength
      {"from the north, rocks", drifting({45, 70}, 0), 90},
      {"oblique", drifting({70, 101}, 237)},
      {"oblique, rocks, layers", pattern(drifting({67, 41}, 250), "layers"), 60},
      {"diagonal, both, K 16", pattern(drifting({50, 50}, 135), "both"), 0, 3, 16},
      {"even, K 2", pattern(drifting({37, 66}, 180), "even"), 300, 4, 2},
      {"open", open(drifting({64, 40}, 90))},
      {"open, oblique, rocks", open(drifting({41, 67}, 20)), 60},
      {"open, oblique, wide, K 4", open(drifting({90, 33}, 310)), 0, 4, 4},
      {"open, crowds, K 2", crowded(open(with(drifting({5, 12}, 270), "hop_factor", 20.0))), 0, 1, 2},
      {"no rocks in the way", with(drifting({40, 40}, 200), "obstacles", false), 200},
      {"no snowfall, no drift off", with(with(drifting({48, 33}, 300), "snowfall", 0.0), "suspension", 0.0)},
      {"steep", with(tall(drifting({33, 31}, 260), 0.6), "repose_angle", 20.0), 0, 3},
      {"hops longer than the grid", hopping(drifting({16, 13}, 225), 600.0)},
      {"the same along the axis", hopping(drifting({9, 14}, 270), 900.0)},
      {"the same, open", open(hopping(drifting({9, 14}, 290), 900.0))},
      {"one row", drifting({40, 1}, 230)},
      {"one column", drifting({1, 40}, 270)},
      {"one column, open", open(drifting({1, 40}, 190))},
      {"two by three", drifting({2, 3}, 200)},
      {"one cell", drifting({1, 1}, 250)},
      {"turning wind", drifting({31, 44}, 270), 50, 5, 8, {270, 250, 180, 20, 95}},
      {"long shadows", with(tall(drifting({130, 9}, 255), 0.1), "shadow_angle", 7.0), 150, 3},
      {"long shadows, open", open(with(tall(drifting({9, 130}, 10), 0.1), "shadow_angle", 7.0)), 150, 3},
  };
}

inline Terrain ground(const SnowCase& scene) {
  Terrain terrain = scene.world.strewn();
  if (scene.rocks > 0) raise_rocks(terrain, scene.rocks);
  return terrain;
}

/// Terrain with all its fields, ledger, lifts and reports of a run on `executor` are those of a run on `cpu`.
inline void expect_same_as_threads(const SnowCase& scene, CudaExecutor& executor) {
  struct Ending {
    Terrain terrain;
    StepReport report;
    Grid<std::int32_t> lifts;
  };
  const auto run_on = [&](Executor& machine) {
    Ending ending{ground(scene), {}, Grid<std::int32_t>(scene.world.extent)};
    const auto model = find_model(scene.world.model).make(scene.world.values());
    model->prepare({.seed = scene.world.seed});
    model->begin(ending.terrain);
    machine.count_lifts(&ending.lifts);
    for (int step = 0; step < scene.steps; ++step) {
      WindNow wind{scene.world.wind.bearing, step % 2 == 0 ? 14.0 : 19.0};
      if (!scene.bearings.empty()) wind.bearing = scene.bearings[static_cast<std::size_t>(step)];
      ending.report += model->step(ending.terrain, wind, {scene.world.seed, static_cast<std::uint64_t>(step)}, machine);
    }
    machine.settle(ending.terrain);
    machine.count_lifts(nullptr);
    EXPECT_EQ(ending.terrain.total_mobile(), ending.terrain.ledger().expected()) << scene.name;
    return ending;
  };
  const auto cpu = make_executor(scene.options());
  const Ending theirs = run_on(*cpu);
  const Ending ours = run_on(executor);
  EXPECT_EQ(executor.name(), "cuda") << executor.take_notice();
  const auto lifts = ours.lifts.cells();
  EXPECT_EQ(std::accumulate(lifts.begin(), lifts.end(), std::int64_t{0}), ours.report.lifts) << scene.name;
  EXPECT_TRUE(ours.lifts == theirs.lifts) << scene.name;
  EXPECT_TRUE(ours.terrain.mobile() == theirs.terrain.mobile()) << scene.name;
  for (std::size_t k = 0; k < theirs.terrain.fields().size(); ++k) {
    const Field& field = theirs.terrain.fields()[k];
    EXPECT_TRUE(ours.terrain.fields()[k].values == field.values) << scene.name << ", " << field.info.key;
  }
  EXPECT_EQ(state_hash(ours.terrain), state_hash(theirs.terrain)) << scene.name;
  EXPECT_EQ(ours.terrain.ledger(), theirs.terrain.ledger()) << scene.name;
  expect_same(ours.report, theirs.report, scene.name);
}

}  // namespace erg::test
