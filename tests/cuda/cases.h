// Runs that the CUDA executor has to do exactly as `cpu` does, each with something of its own.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../laws/world.h"
#include "cuda/cuda_executor.h"

namespace erg::test {

struct Case {
  std::string name;
  World world;
  bool rocks = false;
  int steps = 4;
  int sweeps = 16;

  ExecutorOptions options() const { return {.name = "cpu", .threads = 2, .sweeps = sweeps, .lines_a_thread = 1}; }
};

inline std::vector<Case> cases() {
  std::vector<Case> all;
  const std::string nonrepeated = "nonrepeated";
  const std::string eight = "8";
  for (const ModelType& model : catalogue()) {
    const std::string key = model.info.key;
    if (!World{.model = key}.moves_slabs()) continue;  // others only use for_pieces
    all.push_back({key, {.model = key, .extent = {70, 45}}});
    all.push_back({key + ", 8 neighbours",
                   {.model = key, .extent = {45, 70}, .wind = {180, 3}, .settings = {{"neighbours", eight}}}});
    all.push_back({key + ", oblique",
                   {.model = key, .extent = {70, 101}, .wind = {237, 4.5}, .settings = {{"neighbours", eight}}}});
    all.push_back({key + ", rocks", {.model = key, .extent = {67, 41}, .wind = {250, 6}}, true});
    all.push_back({key + ", rocks, open",
                   {.model = key, .extent = {40, 67}, .boundary = Boundary::open, .inflow = 3, .wind = {20, 9}},
                   true});
    all.push_back({key + ", nonrepeated",
                   {.model = key, .extent = {37, 66}, .wind = {20, 5}, .settings = {{"polling", nonrepeated}}},
                   false,
                   4,
                   4});
    all.push_back({key + ", open",
                   {.model = key,
                    .extent = {70, 40},
                    .boundary = Boundary::open,
                    .inflow = 3,
                    .wind = {310, 5},
                    .settings = {{"neighbours", eight}}}});
    all.push_back({key + ", forced",
                   {.model = key, .extent = {32, 32}, .settings = {{"forced_erosion", true}}, .sand = 1},
                   false,
                   2});
    all.push_back(
        {key + ", hardly stays",
         {.model = key, .extent = {33, 20}, .wind = {240, 1}, .settings = {{"p_sand", 0.01}, {"p_bare", 0.01}}},
         true,
         2});
  }
  all.push_back({"one row", {.extent = {40, 1}, .wind = {230, 3}}});
  all.push_back({"one column", {.extent = {1, 40}, .wind = {270, 3}, .settings = {{"neighbours", eight}}}});
  all.push_back({"two by two", {.extent = {2, 2}, .wind = {200, 3}, .settings = {{"neighbours", eight}}, .sand = 9}});
  const World wide{.model = "momiji", .extent = {290, 70}, .settings = {{"neighbours", eight}}};
  for (const double bearing : {10.0, 35.0, 140.0, 225.0}) {  // blocks side by side, skewed where the wind is oblique
    Case scene{"two blocks, bearing " + std::to_string(bearing), wide, bearing == 35, 1, 8};
    scene.world.wind = {bearing, 5};
    if (bearing != 10) std::swap(scene.world.extent.nx, scene.world.extent.ny);
    if (bearing == 140) scene.world.extent = {290, 291};
    all.push_back(scene);
  }
  return all;
}

inline Terrain ground(const Case& scene) {
  Terrain terrain = scene.world.strewn();
  if (scene.rocks) raise_rocks(terrain, 15);
  return terrain;
}

inline void expect_same(const StepReport& ours, const StepReport& theirs, const std::string& what) {
  EXPECT_EQ(ours.polls, theirs.polls) << what;
  EXPECT_EQ(ours.lifts, theirs.lifts) << what;
  EXPECT_EQ(ours.travel, theirs.travel) << what;
  EXPECT_EQ(ours.slabs_in, theirs.slabs_in) << what;
  EXPECT_EQ(ours.slabs_out, theirs.slabs_out) << what;
}

/// Terrain, ledger and reports of a run on `executor` are those of a run on `cpu`.
inline void expect_same_as_threads(const Case& scene, CudaExecutor& executor) {
  Terrain terrain = ground(scene);
  Grid<std::int32_t> their_lifts(terrain.extent());
  const auto threads = make_executor(scene.options());
  threads->count_lifts(&their_lifts);
  const StepReport theirs = scene.world.run(terrain, *threads, scene.steps);
  Terrain on_device = ground(scene);
  Grid<std::int32_t> our_lifts(terrain.extent());
  executor.count_lifts(&our_lifts);
  const StepReport ours = scene.world.run(on_device, executor, scene.steps);
  EXPECT_EQ(executor.name(), "cuda") << executor.take_notice();
  EXPECT_EQ(state_hash(on_device), state_hash(terrain)) << scene.name;
  EXPECT_EQ(on_device.ledger(), terrain.ledger()) << scene.name;
  EXPECT_TRUE(our_lifts == their_lifts) << scene.name;
  expect_same(ours, theirs, scene.name);
}

}  // namespace erg::test
