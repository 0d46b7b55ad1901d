// Snow: days until it is frozen, bonding, snowfall, slopes, and the shapes that wind makes of fresh and of bonded snow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/bedforms.h"
#include "sim/simulation.h"

namespace erg {
namespace {

Config snow(const std::string& model, const std::vector<std::string>& settings) {
  Config config(model);
  for (const std::string& setting : settings) set_from_text(config, setting);
  return config;
}

const Grid<float>& field(const Terrain& terrain, const std::string& key) {
  return find_field(terrain.fields(), key)->values;
}

std::int64_t frozen_on_day(const std::string& executor, double first, double last, std::int64_t steps = 100) {
  Config config = snow("snow_packing", {"grid.nx=16", "grid.ny=16", "wind.strength=20", "run.executor=" + executor,
                                        "run.steps=" + std::to_string(steps)});
  config.temperature = {first, last, {}};
  Simulation simulation(config);
  while (!simulation.finished() && simulation.step_count() < steps) simulation.step();
  if (!simulation.finished()) return 0;
  EXPECT_NE(simulation.totals().why_finished.find("day " + std::to_string(simulation.step_count())), std::string::npos);
  return simulation.step_count();
}

TEST(SnowPacking, FreezesSoonerTheWarmerItIs) {
  for (const std::string executor : {"serial", "cpu"}) {
    EXPECT_EQ(frozen_on_day(executor, -20, -20), 98);  // in print
    EXPECT_EQ(frozen_on_day(executor, -15, -15), 76);
    EXPECT_EQ(frozen_on_day(executor, -10, -10), 56);
    EXPECT_EQ(frozen_on_day(executor, -5, -5), 39);
    EXPECT_EQ(frozen_on_day(executor, 0, 0), 26);
  }
  EXPECT_NEAR(static_cast<double>(frozen_on_day("cpu", -10, 0)), 51, 2);  // in print
  EXPECT_EQ(frozen_on_day("cpu", -30, -30), 0);                           // not within the hundred days
}

TEST(SnowPacking, FollowsTheTemperatureCurve) {
  Config config = snow("snow_packing", {"run.steps=11"});
  config.temperature = {-20, 0, {{0, 1}, {0, 1}}};  // warms at once
  Simulation simulation(config);
  EXPECT_EQ(simulation.wind().temperature, -20);
  simulation.step();
  EXPECT_GT(simulation.wind().temperature, -12);
  for (int step = 1; step < 10; ++step) simulation.step();
  EXPECT_NEAR(simulation.wind().temperature, 0, 1e-9);
}

TEST(SnowSintering, BondsInTheCalmAndNeverComesLooseThere) {
  for (const std::string executor : {"serial", "cpu"}) {
    Simulation simulation(
        snow("snow_sintering", {"grid.nx=24", "grid.ny=20", "grid.cell_size=0.1", "scene.sand=30", "wind.strength=1",
                                "parameters.time_step=600", "run.seed=3", "run.executor=" + executor}));
    Grid<float> before = field(simulation.terrain(), "bonded");
    double total = 0;
    for (int step = 0; step < 72; ++step) {  // twelve hours
      simulation.step();
      const Grid<float>& now = field(simulation.terrain(), "bonded");
      total = 0;
      for (std::size_t cell = 0; cell < now.size(); ++cell) {
        EXPECT_GE(now[cell], before[cell]);
        total += now[cell];
      }
      before = now;
    }
    // At -10 deg C the bonding time is twelve hours: 1 - 1/e of the snow has bonded.
    EXPECT_NEAR(total / (24 * 20 * 30), 1 - std::exp(-1.0), 0.02) << executor;
  }
}

TEST(SnowSintering, BooksTheSnowThatFalls) {
  for (const std::string executor : {"serial", "cpu"}) {
    Config config = snow("snow_sintering", {"grid.nx=40", "grid.ny=40", "grid.cell_size=0.1", "scene.sand=0",
                                            "parameters.snowfall=5", "wind.strength=1", "run.executor=" + executor});
    Simulation simulation(config);
    for (int step = 0; step < 60; ++step) simulation.step();  // an hour
    const Terrain& terrain = simulation.terrain();
    EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
    EXPECT_NEAR(static_cast<double>(terrain.total_mobile()) / (40 * 40), 1, 0.1);  // 5 mm are a slab
  }
}

TEST(SnowSintering, LooseSnowSlidesAndBondedSnowStands) {
  const auto steepest = [](const std::string& age) {
    Simulation simulation(snow(
        "snow_sintering",
        {"grid.nx=64", "grid.ny=64", "grid.cell_size=0.1", "scene.kind=cone", "scene.height=2.2", "scene.radius=20",
         "scene.sand=1", "wind.strength=0.5", "parameters.bonding_time=100000", "parameters.start_age=" + age}));
    for (int step = 0; step < 1500; ++step) simulation.step();
    int most = 0;
    const Terrain& terrain = simulation.terrain();
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x + 1 < 64; ++x) most = std::max(most, std::abs(terrain.height(x, y) - terrain.height(x + 1, y)));
    }
    return most;
  };
  EXPECT_LE(steepest("0"), 18);        // 38 deg is 16 slabs a cell; a little is still on its way
  EXPECT_GT(steepest("1000000"), 20);  // 2.2 m over 2 m: 22 slabs a cell stand where they bonded
}

BedformShape grown(const std::vector<std::string>& settings, int steps) {
  Simulation simulation(snow("snow_sintering", settings));
  for (int step = 0; step < steps; ++step) simulation.step();
  return measure_bedforms(simulation.terrain(), 270);
}

TEST(SnowSintering, WindMakesWavesOfFreshSnowAcrossIt) {
  const BedformShape waves =
      grown({"grid.nx=128", "grid.ny=128", "grid.cell_size=0.1", "scene.sand=40", "wind.strength=10"}, 300);
  EXPECT_LT(waves.across, 0.35);
  EXPECT_LT(waves.skew, 0);  // slip faces look downwind
  EXPECT_GT(waves.relief, 8);
}

TEST(SnowSintering, AGaleCarvesSastrugiOfBondedSnowAlongIt) {
  const BedformShape sastrugi =
      grown({"grid.nx=128", "grid.ny=128", "grid.cell_size=0.05", "scene.sand=120", "parameters.slab_height=0.0025",
             "parameters.time_step=30", "parameters.start_age=60", "wind.strength=22"},
            480);
  EXPECT_GT(sastrugi.across, 0.55);
  EXPECT_GT(sastrugi.skew, 0);  // steeper toward the wind
  EXPECT_GT(sastrugi.relief, 3);
}

TEST(SnowSintering, ALightWindLeavesSnowFlat) {
  const BedformShape crust =
      grown({"grid.nx=64", "grid.ny=64", "grid.cell_size=0.1", "scene.sand=40", "wind.strength=3"}, 120);
  EXPECT_LT(crust.relief, 1);
}

}  // namespace
}  // namespace erg
