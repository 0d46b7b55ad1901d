// Mass is conserved to the slab and nothing is ever thinner than nothing, in every model on every executor.
#include <gtest/gtest.h>

#include <algorithm>

#include "world.h"

namespace erg::test {

using models::StepReport;

namespace {

void expect_whole(Terrain& terrain, const std::string& what) {
  EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected()) << what;
  const auto mobile = terrain.mobile().cells();
  EXPECT_GE(*std::min_element(mobile.begin(), mobile.end()), 0) << what;
}

struct Setting {
  std::string name;
  std::vector<std::pair<std::string, ParameterValue>> settings;
};

std::vector<Setting> settings() {
  return {{"as published", {}},
          {"nonrepeated", {{"polling", std::string("nonrepeated")}}},
          {"forced erosion", {{"forced_erosion", true}}},
          {"8 neighbours", {{"neighbours", std::string("8")}}},
          {"never stays", {{"p_sand", 0.0}, {"p_bare", 0.0}}},
          {"always stays", {{"p_sand", 1.0}, {"p_bare", 1.0}}}};
}

class EveryModel : public testing::TestWithParam<std::string> {};

TEST_P(EveryModel, KeepsItsSandOnATorusAtAnyBearing) {
  for (const Machine& machine : machines()) {
    for (const Setting& setting : settings()) {
      for (const double bearing : {270.0, 0.0, 40.0, 135.0, 250.0}) {
        World world{.model = GetParam(), .wind = {bearing, 5}, .settings = setting.settings};
        if (!world.applies()) continue;
        Terrain terrain = world.strewn();
        const std::int64_t start = terrain.total_mobile();
        world.run(terrain, machine.options, 4);
        const std::string what = machine.name + ", " + setting.name + ", bearing " + std::to_string(bearing);
        expect_whole(terrain, what);
        EXPECT_EQ(terrain.total_mobile(), start) << what;
      }
    }
  }
}

TEST_P(EveryModel, KeepsItsSandAmongRocks) {
  for (const Machine& machine : machines()) {
    for (const bool stop : {true, false}) {
      for (const double bearing : {270.0, 205.0}) {
        World world{.model = GetParam(), .wind = {bearing, 7}, .settings = {{"obstacles", stop}}};
        if (!stop && !world.applies()) continue;
        Terrain terrain = world.strewn();
        raise_rocks(terrain, 20);
        world.run(terrain, machine.options, 12);
        expect_whole(terrain, machine.name);
      }
    }
  }
}

TEST_P(EveryModel, CountsWhatCrossesOpenEdges) {
  for (const Machine& machine : machines()) {
    for (const double bearing : {270.0, 20.0, 225.0}) {
      for (const double inflow : {0.0, 2.5}) {
        World world{.model = GetParam(), .boundary = Boundary::open, .inflow = inflow, .wind = {bearing, 5}};
        Terrain terrain = world.strewn();
        const std::int64_t start = terrain.total_mobile();
        const StepReport report = world.run(terrain, machine.options, 10);
        const std::string what = machine.name + ", bearing " + std::to_string(bearing);
        expect_whole(terrain, what);
        EXPECT_EQ(terrain.total_mobile(), start + report.slabs_in - report.slabs_out) << what;
        EXPECT_GT(report.slabs_out, 0) << what;
        EXPECT_EQ(report.slabs_in > 0, inflow > 0) << what;
      }
    }
  }
}

TEST_P(EveryModel, LetsInAsMuchAsAsked) {
  for (const Machine& machine : machines()) {
    World world{.model = GetParam(), .extent = {64, 100}, .boundary = Boundary::open, .inflow = 1.5, .wind = {270, 5}};
    Terrain terrain = world.strewn();
    const StepReport report = world.run(terrain, machine.options, 20);
    // Binomial rounding: 100 cells of edge, 20 steps, 1.5 slabs each; four standard deviations are about 3 %.
    EXPECT_NEAR(static_cast<double>(report.slabs_in), 100 * 20 * 1.5, 0.03 * 3000) << machine.name;
  }
}

TEST_P(EveryModel, MovesNothingOnAnEmptyGrid) {
  for (const Machine& machine : machines()) {
    for (const bool forced : {false, true}) {
      World world{.model = GetParam(), .settings = {{"forced_erosion", forced}}};
      Terrain terrain(world.extent, 1, world.quantum());
      terrain.open_ledger();
      const StepReport report = world.run(terrain, machine.options, 2);
      EXPECT_EQ(report.lifts, 0) << machine.name;
      EXPECT_EQ(terrain.total_mobile(), 0) << machine.name;
    }
  }
}

TEST_P(EveryModel, RunsOnOddShapesAndWithHopsLongerThanTheGrid) {
  for (const Machine& machine : machines()) {
    for (const Extent extent :
         {Extent{1, 1}, Extent{1, 17}, Extent{17, 1}, Extent{2, 2}, Extent{3, 70}, Extent{65, 33}}) {
      for (const double bearing : {270.0, 180.0, 60.0}) {
        for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
          World world{.model = GetParam(), .extent = extent, .boundary = boundary, .wind = {bearing, 100}};
          Terrain terrain = world.strewn();
          world.run(terrain, machine.options, 5);
          expect_whole(terrain, machine.name + ", " + std::to_string(extent.nx) + " x " + std::to_string(extent.ny));
        }
      }
    }
  }
}

TEST_P(EveryModel, KeepsItsSandInTallColumns) {
  // Columns beyond what 8-bit lanes hold, and a cliff that slides down from there.
  for (const Machine& machine : machines()) {
    World world{.model = GetParam(), .extent = {40, 40}, .wind = {300, 5}};
    Terrain terrain = world.strewn();
    for (int y = 10; y < 14; ++y) {
      for (int x = 10; x < 14; ++x) terrain.edit_mobile()(x, y) = 900;
    }
    terrain.open_ledger();
    world.run(terrain, machine.options, 30);
    expect_whole(terrain, machine.name);
  }
}

std::vector<std::string> model_keys() {
  std::vector<std::string> keys;
  for (const models::ModelType& model : models::catalogue()) keys.push_back(model.info.key);
  return keys;
}
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryModel, testing::ValuesIn(model_keys()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace erg::test
