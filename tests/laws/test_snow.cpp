// Snow: days until it is frozen, bonding, snowfall, slopes, and the shapes that wind makes of fresh and of bonded snow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/bedforms.h"
#include "analysis/heap_middle.h"
#include "configured.h"
#include "sim/simulation.h"

namespace erg {

using analysis::bedform_name;
using analysis::BedformShape;
using analysis::measure_bedforms;
using sim::Config;
using sim::Simulation;

namespace {

using test::configured;
using test::field;

std::int64_t frozen_on_day(const std::string& executor, double first, double last, std::int64_t steps = 100) {
  Config config = configured("snow_packing", {"grid.nx=16", "grid.ny=16", "wind.strength=20",
                                              "run.executor=" + executor, "run.steps=" + std::to_string(steps)});
  config.weather.temperature = {first, last, {}};
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
  Config config = configured("snow_packing", {"run.steps=11"});
  config.weather.temperature = {-20, 0, {{0, 1}, {0, 1}}};  // warms at once
  Simulation simulation(config);
  EXPECT_EQ(simulation.wind().temperature, -20);
  simulation.step();
  EXPECT_GT(simulation.wind().temperature, -12);
  for (int step = 1; step < 10; ++step) simulation.step();
  EXPECT_NEAR(simulation.wind().temperature, 0, 1e-9);
}

TEST(SnowSintering, BondsInTheCalmAndNeverComesLooseThere) {
  for (const std::string executor : {"serial", "cpu"}) {
    Simulation simulation(configured(
        "snow_sintering", {"grid.nx=24", "grid.ny=20", "grid.cell_size=0.1", "scene.sand=30", "wind.strength=1",
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
    Config config =
        configured("snow_sintering", {"grid.nx=40", "grid.ny=40", "grid.cell_size=0.1", "scene.sand=0",
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
    Simulation simulation(configured(
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
  Simulation simulation(configured("snow_sintering", settings));
  for (int step = 0; step < steps; ++step) simulation.step();
  return measure_bedforms(simulation.terrain(), 270);
}

TEST(SnowSintering, WindMakesWavesOfFreshSnowAcrossIt) {
  const BedformShape waves =
      grown({"grid.nx=128", "grid.ny=128", "grid.cell_size=0.1", "scene.sand=40", "wind.strength=10"}, 300);
  EXPECT_LT(waves.across, 0.35);
  EXPECT_LT(waves.skew, 0);  // slip faces look downwind
  EXPECT_GT(waves.relief, 0.04);
  EXPECT_EQ(bedform_name(waves), "waves");
}

TEST(SnowSintering, AGaleCarvesSastrugiOfBondedSnowAlongIt) {
  const auto carved = [](const std::string& calm_hours) {
    return grown({"grid.nx=64", "grid.ny=64", "grid.cell_size=0.1", "scene.sand=40", "wind.strength=17",
                  "parameters.start_age=" + calm_hours},
                 360);
  };
  const BedformShape sastrugi = carved("60");
  EXPECT_GT(sastrugi.across, 0.55);
  EXPECT_GT(sastrugi.skew, 0.5);  // clearly steeper toward the wind
  EXPECT_GT(sastrugi.relief, 0.02);
  EXPECT_EQ(bedform_name(sastrugi), "sastrugi");
  // The same gale over fresh snow drifts it into streaks; nothing is carved.
  EXPECT_EQ(bedform_name(carved("0")), "streaks");
}

TEST(SnowSintering, AGaleTurnsTheWavesOfAStormIntoSastrugi) {
  Config config =
      configured("snow_sintering", {"grid.nx=64", "grid.ny=64", "grid.cell_size=0.1", "scene.sand=40", "run.seed=2"});
  const auto season = [](double wind, std::int64_t steps, double snowfall) {
    forcing::WindInterval one;
    one.first = one.last = wind;
    one.steps = steps;
    one.snowfall = snowfall;
    return one;
  };
  config.wind.intervals = {season(12, 360, 2), season(2, 960, 0), season(17, 360, 0)};
  Simulation simulation(config);
  const auto after = [&](int steps) {
    for (int step = 0; step < steps; ++step) simulation.step();
    return measure_bedforms(simulation.terrain(), 270);
  };
  const BedformShape storm = after(360);
  EXPECT_EQ(bedform_name(storm), "waves");
  EXPECT_LT(storm.skew, -0.5);
  const BedformShape calm = after(960);
  EXPECT_NEAR(calm.relief, storm.relief, 0.001) << "hardly anything moves in the calm";
  EXPECT_GT(calm.crust, storm.crust) << "it bonds";
  const BedformShape gale = after(360);
  EXPECT_EQ(bedform_name(gale), "sastrugi");
  EXPECT_GT(gale.across, storm.across + 0.15);
  // Without bonding in the calm the same gale drifts the waves, and carves nothing.
  sim::set_from_text(config, "parameters.bonding_time=1000000");
  Simulation loose(config);
  while (loose.step_count() < 360 + 960 + 360) loose.step();
  EXPECT_NE(bedform_name(measure_bedforms(loose.terrain(), 270)), "sastrugi");
}

TEST(SnowSintering, ALightWindLeavesSnowFlat) {
  const BedformShape crust =
      grown({"grid.nx=64", "grid.ny=64", "grid.cell_size=0.1", "scene.sand=40", "wind.strength=3"}, 120);
  EXPECT_LT(crust.relief, 0.005);
  EXPECT_EQ(bedform_name(crust), "flat");
}

TEST(SnowSintering, RocksGetARampAndATailDownwind) {
  // A rock 1.2 m high and 2 m wide under thin snow that drifts: its middle is (48, 32), its foot at x = 58.
  Simulation simulation(
      configured("snow_sintering", {"grid.nx=96", "grid.ny=64", "grid.cell_size=0.1", "scene.kind=hump", "scene.sand=8",
                                    "scene.height=1.2", "scene.radius=10", "wind.strength=11"}));
  for (int step = 0; step < 180; ++step) simulation.step();
  const auto mean = [&](int west, int east, int south, int north) {
    double sum = 0;
    for (int y = south; y < north; ++y) {
      for (int x = west; x < east; ++x) sum += simulation.terrain().mobile()(x, y);
    }
    return sum / ((east - west) * (north - south));
  };
  const double tail = mean(66, 78, 30, 34);
  EXPECT_GT(tail, 4);
  EXPECT_GT(tail, 3 * mean(66, 78, 20, 25)) << "a ridge, swept on either side";
  EXPECT_GT(tail, 3 * mean(66, 78, 39, 44));
  EXPECT_GT(mean(37, 42, 29, 35), 2 * 8) << "snow banks up before the rock";
}

/// How a mound of fresh snow fares for twelve hours at 9 m/s and -10 deg C, by its radius in cells (of 0.1 m).
struct MoundFate {
  double left = 0;        ///< share of the snow within the mound's first outline
  double highest = 0;     ///< slabs
  double first_hour = 0;  ///< way of its middle, cells
  double last_hour = 0;
  double slow_down() const { return last_hour / first_hour; }
};

MoundFate mound_fate(int radius, const std::string& height, bool bonds) {
  Simulation simulation(
      configured("snow_sintering", {"grid.nx=160", "grid.ny=96", "grid.cell_size=0.1", "scene.kind=cone",
                                    "scene.sand=0", "scene.height=" + height, "scene.radius=" + std::to_string(radius),
                                    "wind.strength=9", bonds ? "bonding_time=12" : "bonding_time=1000000"}));
  const Grid<std::int32_t> before = simulation.terrain().mobile();
  const auto middle = [&] { return analysis::heap_middle(simulation.terrain().mobile(), radius); };
  MoundFate fate;
  for (int hour = 1; hour <= 12; ++hour) {
    const double start = middle();
    for (int step = 0; step < 60; ++step) simulation.step();
    (hour == 1 ? fate.first_hour : fate.last_hour) = std::remainder(middle() - start, 160.0);
  }
  double inside = 0;
  for (std::size_t cell = 0; cell < before.size(); ++cell) {
    const std::int32_t now = simulation.terrain().mobile()[cell];
    if (before[cell] > 0) inside += now;
    fate.highest = std::max(fate.highest, static_cast<double>(now));
  }
  fate.left = inside / static_cast<double>(simulation.terrain().total_mobile());
  return fate;
}

TEST(SnowSintering, SmallBarchansMoveOnAndLargeOnesFreeze) {
  // After Sharma et al. 2019: bonding overtakes a dune that needs longer than that to move by its own length. That a
  // large one lies where it lay is geometry, with bonding or without; that it slows down is the bonding's doing.
  const MoundFate small = mound_fate(10, "0.2", true);
  EXPECT_LT(small.left, 0.25);
  EXPECT_GT(small.highest, 20) << "a dune still, not a veil";
  EXPECT_GT(small.last_hour, 1);
  const MoundFate large = mound_fate(40, "0.8", true);
  const MoundFate unbonded = mound_fate(40, "0.8", false);
  EXPECT_GT(large.first_hour, 1);
  EXPECT_LT(large.slow_down(), 0.55);
  EXPECT_GT(unbonded.slow_down(), 0.6);
  EXPECT_LT(large.slow_down(), unbonded.slow_down() - 0.1);
}

}  // namespace
}  // namespace erg
