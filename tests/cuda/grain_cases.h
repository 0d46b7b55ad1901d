// Runs of grains that the CUDA executor has to do exactly as `cpu` does, each with something of its own.
#pragma once

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "../laws/world.h"
#include "cuda/cuda_executor.h"
#include "models/grains.h"

namespace erg::test {

struct GrainCase {
  std::string name;
  World world;
  std::int32_t rocks = 0;  ///< height, parcels
  int steps = 2;
};

inline std::vector<GrainCase> grain_cases() {
  const std::vector<std::pair<std::string, ParameterValue>> snow{
      {"bonding_time", 3.0}, {"settling", 0.02}, {"abrasion", 0.3}, {"grain_density", 917.0}};
  const std::vector<std::pair<std::string, ParameterValue>> plants{{"plants", std::int64_t{4}}, {"plant_height", 0.05}};
  return {
      {"straight", {.model = "grains", .extent = {50, 37}, .sand = 20}, 0, 3},
      {"oblique, rocks", {.model = "grains", .extent = {37, 50}, .wind = {237, 6}, .sand = 20}, 300},
      {"from the north, open",
       {.model = "grains", .extent = {41, 33}, .boundary = Boundary::open, .inflow = 3, .wind = {10, 6}, .sand = 20}},
      {"oblique, open, rocks",
       {.model = "grains", .extent = {33, 70}, .boundary = Boundary::open, .inflow = 2, .wind = {130, 5}, .sand = 10},
       600},
      {"plants", {.model = "grains", .extent = {40, 45}, .wind = {20, 5}, .settings = plants, .sand = 20}},
      {"snow", {.model = "grains", .extent = {35, 34}, .wind = {200, 6}, .settings = snow, .sand = 8}, 0, 4},
      {"sizes, one poll",
       {.model = "grains",
        .extent = {31, 40},
        .wind = {250, 5},
        .settings = {{"diameter_spread", 0.4}, {"sub_steps", std::int64_t{1}}},
        .sand = 20}},
      {"steep", {.model = "grains", .extent = {30, 33}, .wind = {300, 1}, .sand = 400}},
      {"cut off", {.model = "grains", .extent = {24, 24}, .settings = {{"longest_flight", 0.1}}, .sand = 20}},
      {"one row", {.model = "grains", .extent = {40, 1}, .wind = {230, 5}, .sand = 20}},
      {"one column", {.model = "grains", .extent = {1, 40}, .wind = {270, 5}, .sand = 20}},
      {"two by three", {.model = "grains", .extent = {2, 3}, .wind = {200, 5}, .sand = 20}},
  };
}

inline Terrain ground(const GrainCase& scene) {
  Terrain terrain = scene.world.strewn();
  if (scene.rocks > 0) raise_rocks(terrain, scene.rocks);
  return terrain;
}

/// Terrain, ledger and reports of a run on `executor` are those of a run on `cpu`.
inline void expect_same_as_threads(const GrainCase& scene, CudaExecutor& executor) {
  struct Ending {
    std::uint64_t hash;
    MassLedger ledger;
    StepReport report;
    std::vector<Reading> readings;
    Grid<std::int32_t> lifts;
  };
  const auto run_on = [&](Executor& machine) {
    Terrain terrain = ground(scene);
    GrainModel model(scene.world.values());
    model.begin(terrain);
    Grid<std::int32_t> lifts(terrain.extent());
    machine.count_lifts(&lifts);
    StepReport total;
    for (int step = 0; step < scene.steps; ++step) {
      const StepKey key{scene.world.seed, static_cast<std::uint64_t>(step)};
      total += model.step(terrain, scene.world.model_wind(), key, machine);
    }
    machine.settle(terrain);
    machine.count_lifts(nullptr);
    const auto counted = lifts.cells();
    EXPECT_EQ(std::accumulate(counted.begin(), counted.end(), std::int64_t{0}), total.lifts) << scene.name;
    EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected()) << scene.name;
    return Ending{state_hash(terrain), terrain.ledger(), total, model.readings(), std::move(lifts)};
  };
  ParallelExecutor cpu({.name = "cpu", .threads = 2});
  const Ending theirs = run_on(cpu);
  const Ending ours = run_on(executor);
  EXPECT_EQ(executor.name(), "cuda") << executor.take_notice();
  EXPECT_NE(theirs.hash, state_hash(ground(scene))) << scene.name;
  EXPECT_EQ(ours.hash, theirs.hash) << scene.name;
  EXPECT_EQ(ours.ledger, theirs.ledger) << scene.name;
  EXPECT_TRUE(ours.lifts == theirs.lifts) << scene.name;
  EXPECT_EQ(ours.report.lifts, theirs.report.lifts) << scene.name;
  EXPECT_EQ(ours.report.travel, theirs.report.travel) << scene.name;
  EXPECT_EQ(ours.report.slabs_out, theirs.report.slabs_out) << scene.name;
  for (std::size_t k = 0; k < theirs.readings.size(); ++k) {
    EXPECT_EQ(ours.readings[k].value, theirs.readings[k].value) << scene.name << ", " << theirs.readings[k].key;
  }
}

}  // namespace erg::test
