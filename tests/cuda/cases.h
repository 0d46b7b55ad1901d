// Runs that the CUDA executor has to do exactly as `cpu` does, each with something of its own.
#pragma once

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "../laws/world.h"
#include "cuda/cuda_backend.h"
#include "sim/make_executor.h"

namespace erg::test {

/// Height of the rocks in slabs' cases.
constexpr std::int32_t slab_rocks = 15;

struct Case {
  std::string name;
  World world;
  std::int32_t rocks = 0;  ///< height, slabs; 0: none
  int steps = 4;
  int sweeps = 16;
  std::vector<forcing::Forcing> winds = {};  ///< of the steps, in turn; empty: the world's

  compute::ExecutorOptions options() const {
    return {.name = "cpu", .threads = 2, .sweeps = sweeps, .lines_a_thread = 1};
  }
  forcing::Forcing wind(int step) const {
    return winds.empty() ? world.model_wind() : winds[static_cast<std::size_t>(step) % winds.size()];
  }
};

/// Those of models that move slabs.
inline std::vector<Case> slab_cases() {
  std::vector<Case> all;
  const std::string nonrepeated = "nonrepeated";
  const std::string eight = "8";
  for (const models::ModelType& model : models::catalogue()) {
    const std::string key = model.info.key;
    if (!World{.model = key}.moves_slabs()) continue;  // others only use parallel_for
    all.push_back({key, {.model = key, .extent = {70, 45}}});
    all.push_back({key + ", 8 neighbours",
                   {.model = key, .extent = {45, 70}, .wind = {180, 3}, .settings = {{"neighbours", eight}}}});
    all.push_back({key + ", oblique",
                   {.model = key, .extent = {70, 101}, .wind = {237, 4.5}, .settings = {{"neighbours", eight}}}});
    all.push_back({key + ", rocks", {.model = key, .extent = {67, 41}, .wind = {250, 6}}, slab_rocks});
    all.push_back({key + ", rocks, open",
                   {.model = key, .extent = {40, 67}, .boundary = Boundary::open, .inflow = 3, .wind = {20, 9}},
                   slab_rocks});
    all.push_back({key + ", nonrepeated",
                   {.model = key, .extent = {37, 66}, .wind = {20, 5}, .settings = {{"polling", nonrepeated}}},
                   0,
                   4,
                   4});
    all.push_back({key + ", open",
                   {.model = key,
                    .extent = {70, 40},
                    .boundary = Boundary::open,
                    .inflow = 3,
                    .wind = {310, 5},
                    .settings = {{"neighbours", eight}}}});
    all.push_back({key + ", hops shorter than a row",
                   {.model = key, .extent = {67, 41}, .boundary = Boundary::open, .inflow = 2, .wind = {250, 0.4}},
                   slab_rocks});
    all.push_back({key + ", forced",
                   {.model = key, .extent = {32, 32}, .settings = {{"forced_erosion", true}}, .sand = 1},
                   0,
                   2});
    all.push_back(
        {key + ", hardly stays",
         {.model = key, .extent = {33, 20}, .wind = {240, 1}, .settings = {{"p_sand", 0.01}, {"p_bare", 0.01}}},
         slab_rocks,
         2});
  }
  all.push_back({"one row", {.extent = {40, 1}, .wind = {230, 3}}});
  all.push_back({"one column", {.extent = {1, 40}, .wind = {270, 3}, .settings = {{"neighbours", eight}}}});
  all.push_back({"two by two", {.extent = {2, 2}, .wind = {200, 3}, .settings = {{"neighbours", eight}}, .sand = 9}});
  const World wide{.model = "momiji", .extent = {290, 70}, .settings = {{"neighbours", eight}}};
  for (const double bearing : {10.0, 35.0, 140.0, 225.0}) {  // blocks side by side, skewed where the wind is oblique
    Case scene{"two blocks, bearing " + std::to_string(bearing), wide, bearing == 35 ? slab_rocks : 0, 1, 8};
    scene.world.wind = {bearing, 5};
    if (bearing != 10) std::swap(scene.world.extent.nx, scene.world.extent.ny);
    if (bearing == 140) scene.world.extent = {290, 291};
    all.push_back(scene);
  }
  return all;
}

inline Terrain ground(const Case& scene) {
  Terrain terrain = scene.world.strewn();
  if (scene.rocks > 0) raise_rocks(terrain, scene.rocks);
  return terrain;
}

inline void expect_same(const models::StepReport& ours, const models::StepReport& theirs, const std::string& what) {
  EXPECT_EQ(ours.polls, theirs.polls) << what;
  EXPECT_EQ(ours.lifts, theirs.lifts) << what;
  EXPECT_EQ(ours.travel, theirs.travel) << what;
  EXPECT_EQ(ours.slabs_in, theirs.slabs_in) << what;
  EXPECT_EQ(ours.slabs_out, theirs.slabs_out) << what;
}

/// All that a run leaves.
struct CaseEnd {
  Terrain terrain;
  models::StepReport report;
  Grid<std::int32_t> lifts;
  std::vector<models::Diagnostic> diagnostics;
};

inline CaseEnd run_on(compute::Executor& executor, const Case& scene) {
  CaseEnd ending{ground(scene), {}, Grid<std::int32_t>(scene.world.extent), {}};
  const auto model = models::find_model(scene.world.model).make(scene.world.values());
  model->prepare({.seed = scene.world.seed});
  model->begin(ending.terrain);
  executor.count_lifts(&ending.lifts);
  for (int step = 0; step < scene.steps; ++step) {
    const StepKey key{scene.world.seed, static_cast<std::uint64_t>(step)};
    ending.report += model->step(ending.terrain, scene.wind(step), key, executor);
  }
  executor.sync_to_host(ending.terrain);
  executor.count_lifts(nullptr);
  ending.diagnostics = model->diagnostics();
  const auto lifts = ending.lifts.cells();
  EXPECT_EQ(std::accumulate(lifts.begin(), lifts.end(), std::int64_t{0}), ending.report.lifts) << scene.name;
  EXPECT_EQ(ending.terrain.total_mobile(), ending.terrain.ledger().expected()) << scene.name;
  return ending;
}

/// Terrain with its fields, ledger, lifts, reports and diagnostics of a run on `executor` are those of a run on `cpu`.
inline void expect_same_as_threads(const Case& scene, compute::Executor& executor, const std::string& name = "cuda") {
  const CaseEnd theirs = run_on(*sim::make_executor(scene.options()), scene);
  const CaseEnd ours = run_on(executor, scene);
  EXPECT_EQ(executor.name(), name) << executor.take_notice();
  EXPECT_NE(state_hash(theirs.terrain), state_hash(ground(scene))) << scene.name;
  EXPECT_TRUE(ours.terrain.mobile() == theirs.terrain.mobile()) << scene.name;
  for (std::size_t k = 0; k < theirs.terrain.fields().size(); ++k) {
    const Field& field = theirs.terrain.fields()[k];
    EXPECT_TRUE(ours.terrain.fields()[k].values == field.values) << scene.name << ", " << field.info.key;
  }
  EXPECT_EQ(state_hash(ours.terrain), state_hash(theirs.terrain)) << scene.name;
  EXPECT_EQ(ours.terrain.ledger(), theirs.terrain.ledger()) << scene.name;
  EXPECT_TRUE(ours.lifts == theirs.lifts) << scene.name;
  expect_same(ours.report, theirs.report, scene.name);
  for (std::size_t k = 0; k < theirs.diagnostics.size(); ++k) {
    EXPECT_EQ(ours.diagnostics[k].value, theirs.diagnostics[k].value)
        << scene.name << ", " << theirs.diagnostics[k].key;
  }
}

}  // namespace erg::test
