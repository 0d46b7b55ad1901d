// Plants: growth at the curves' vertices, the sign of what they do to sand, the end of a run, and shapes of dunes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/simulation.h"

namespace erg {
namespace {

Config plants(std::vector<std::string> settings) {
  Config config("nield_baas");
  for (const std::string& setting : settings) set_from_text(config, setting);
  return config;
}

const Grid<float>& field(const Terrain& terrain, const std::string& key) {
  return find_field(terrain.fields(), key)->values;
}

TEST(Plants, GrowByTheCurveOfTheYearlyBalance) {
  // No wind reaches anything: every cell lies at a balance that is painted in as last year's thickness.
  Config config = plants({"grid.nx=8", "grid.ny=4", "scene.sand=20", "parameters.steps_per_year=1", "wind.strength=1",
                          "parameters.mesquite=false", "parameters.vegetation=blowouts", "grid.cell_size=0.01",
                          "parameters.grass_start=0.5", "run.executor=cpu", "run.threads=1"});
  Simulation simulation(config);
  const PiecewiseLinear& curve = config.parameters.curve("grass_growth");
  Terrain& terrain = simulation.edit_terrain();
  terrain.edit_mobile().fill(0);  // nothing that could move
  terrain.open_ledger();
  const double slab = terrain.quantum();
  std::vector<double> balances;
  for (const CurvePoint& vertex : curve.vertices) balances.push_back(vertex.x);
  balances.push_back(-9);
  balances.push_back(9);
  for (Field& layer : terrain.edit_fields()) {
    for (std::size_t k = 0; k < balances.size(); ++k) {
      if (layer.info.key == "grass") layer.values[k] = 0.5f;
      if (layer.info.key == "last_year") layer.values[k] = static_cast<float>(-balances[k] / slab);
    }
  }
  simulation.step();
  for (std::size_t k = 0; k < balances.size(); ++k) {
    const double expected = std::clamp(0.5 + curve.at(balances[k]), 0.0, 1.0);
    EXPECT_NEAR(field(simulation.terrain(), "grass")[k], expected, 1e-5) << "balance " << balances[k];
  }
}

/// Slabs that came to lie where plants stand, and where none stand, after sand blew over both.
double caught_share(const std::string& rho) {
  Simulation simulation(
      plants({"grid.nx=64", "grid.ny=64", "scene.sand=8", "wind.strength=1", "run.executor=serial",
              "parameters.steps_per_year=100000", "parameters.shadow_angle=80", "parameters.vegetation=islands",
              "parameters.mesquite=false", "parameters.grass_start=" + rho}));
  const std::int64_t all = simulation.terrain().total_mobile();
  for (int step = 0; step < 20; ++step) simulation.step();
  std::int64_t caught = 0;
  std::int64_t cells = 0;
  const Terrain& terrain = simulation.terrain();
  for (std::size_t cell = 0; cell < terrain.extent().cells(); ++cell) {
    if (field(terrain, "grass")[cell] <= 0 && rho != "0") continue;
    caught += terrain.mobile()[cell];
    ++cells;
  }
  return static_cast<double>(caught) / static_cast<double>(cells) /
         (static_cast<double>(all) / static_cast<double>(terrain.extent().cells()));
}

TEST(Plants, CatchSandAndDoNotRepelIt) {
  // With the minus that Cimbura 2022 prints in eq. 4.5 half-covered ground would lose sand to its surroundings.
  EXPECT_NEAR(caught_share("0"), 1, 1e-9);
  EXPECT_GT(caught_share("0.5"), 1.1);
}

TEST(Plants, EndTheRunWhenTheyHoldAllSand) {
  for (const std::string executor : {"serial", "cpu"}) {
    Simulation simulation(plants({"grid.nx=32", "grid.ny=32", "scene.sand=2", "wind.strength=1",
                                  "parameters.vegetation=random", "parameters.scatter=false", "parameters.grass=false",
                                  "parameters.mesquite=false", "parameters.shrub=true", "parameters.shrub_start=1.5",
                                  "parameters.steps_per_year=5", "run.executor=" + executor}));
    for (Field& layer : simulation.edit_terrain().edit_fields()) {
      if (layer.info.key == "shrub") layer.values.fill(1.5f);
    }
    for (int step = 0; step < 40 && !simulation.finished(); ++step) simulation.step();
    EXPECT_TRUE(simulation.finished()) << executor;
    EXPECT_EQ(simulation.step_count(), 5) << executor;
    EXPECT_FALSE(simulation.totals().why_finished.empty());
  }
}

TEST(Plants, HoldSteeperSlopes) {
  const auto steepest = [](const std::string& rho) {
    Simulation simulation(plants(
        {"grid.nx=64", "grid.ny=64", "scene.kind=cone", "scene.height=30", "scene.radius=20", "scene.sand=1",
         "wind.strength=1", "parameters.vegetation=random", "parameters.scatter=false", "parameters.mesquite=false",
         "parameters.steps_per_year=100000", "parameters.lift_in_shadow=true", "run.executor=cpu"}));
    for (Field& layer : simulation.edit_terrain().edit_fields()) {
      if (layer.info.key == "grass") layer.values.fill(std::stof(rho));
    }
    for (int step = 0; step < 60; ++step) simulation.step();
    int most = 0;
    const Terrain& terrain = simulation.terrain();
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x + 1 < 64; ++x) most = std::max(most, std::abs(terrain.height(x, y) - terrain.height(x + 1, y)));
    }
    return most;
  };
  EXPECT_LE(steepest("0"), 8);     // 30 deg: 6 slabs stand
  EXPECT_GE(steepest("0.35"), 9);  // 40 deg: 9 slabs stand
}

/// The mean ratio of length along the wind to width across it of patches of sand over `least` slabs.
double elongation(const Terrain& terrain, int least) {
  // Autocorrelation of the thick places: how far they reach along and across.
  const auto reach = [&](int dx, int dy) {
    double together = 0;
    double alone = 0;
    for (int y = 0; y < terrain.ny(); ++y) {
      for (int x = 0; x < terrain.nx(); ++x) {
        if (terrain.mobile()(x, y) < least) continue;
        ++alone;
        if (terrain.mobile().wrapped(x + dx, y + dy) >= least) ++together;
      }
    }
    return alone > 0 ? together / alone : 0;
  };
  double along = 0;
  double across = 0;
  for (int distance = 1; distance < 16; ++distance) {
    along += reach(distance, 0);
    across += reach(0, distance);
  }
  return along / across;
}

TEST(Plants, MakeNebkhasLongerThanWide) {
  Simulation simulation(plants({"grid.nx=128", "grid.ny=128", "scene.sand=3", "wind.strength=5", "run.executor=cpu"}));
  for (int step = 0; step < 500; ++step) simulation.step();
  EXPECT_GT(elongation(simulation.terrain(), 12), 1.15);
}

}  // namespace
}  // namespace erg
