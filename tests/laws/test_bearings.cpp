// A wind that swings as real winds do makes dunes whose sides are alike at an oblique bearing; without, they lean.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysis/dune_map.h"
#include "sim/simulation.h"

namespace erg::test {

using analysis::asymmetry;
using analysis::DuneMap;

namespace {

constexpr double bearing = 300;
constexpr int steps = 384;  // whole rounds of draws: six times sixteen draws of four steps

/// A barchan in the mean of some seeds, turned into the wind.
DuneMap mean_barchan(const std::string& model, double spread, int seeds, const std::vector<std::string>& settings) {
  std::vector<DuneMap> maps;
  for (int seed = 1; seed <= seeds; ++seed) {
    sim::Config config(model);
    for (const std::string& setting :
         {std::string("scene.kind=cone"), std::string("scene.sand=0"), std::string("run.executor=cpu"),
          std::string("run.threads=1"), "run.seed=" + std::to_string(seed)}) {
      sim::set_from_text(config, setting);
    }
    for (const std::string& setting : settings) sim::set_from_text(config, setting);
    config.wind.intervals.front().bearing = bearing;
    config.wind.intervals.front().spread = spread;
    sim::Simulation simulation(config);
    while (simulation.step_count() < steps) simulation.step();
    maps.push_back(analysis::dune_map(simulation.terrain(), bearing, 90));
  }
  return analysis::mean_map(maps);
}

void expect_horns_alike(const DuneMap& map) {
  const analysis::HornVolumes horns = analysis::find_horns(map, 0.5);
  EXPECT_GT(horns.left, 0.6 * horns.right);
  EXPECT_LT(horns.left, 1.6 * horns.right);
}

TEST(Bearings, ASpreadKeepsABarchanFromLeaning) {
  const std::vector<std::string> cone{"scene.height=12", "scene.radius=36"};
  const DuneMap swinging = mean_barchan("momiji", models::natural_spread, 3, cone);
  EXPECT_LT(asymmetry(swinging), 0.06);
  expect_horns_alike(swinging);
  EXPECT_GT(asymmetry(mean_barchan("momiji", 0, 3, cone)), 0.12) << "the control: a wind from one bearing for ever";
}

TEST(Bearings, SlidesAlongDiagonalsKeepWernersBarchanFromLeaning) {
  // On an open grid into which sand comes: what it gives off would come back to it over a torus from one side.
  std::vector<std::string> settings{
      "scene.height=20",    "scene.radius=60",        "grid.nx=288", "grid.ny=288", "grid.inflow=2.6",
      "grid.boundary=open", "parameters.neighbours=8"};
  const DuneMap round = mean_barchan("werner", models::natural_spread, 4, settings);
  EXPECT_LT(asymmetry(round), 0.06);
  expect_horns_alike(round);
  settings.back() = "parameters.neighbours=4";
  EXPECT_GT(asymmetry(mean_barchan("werner", models::natural_spread, 4, settings)), 0.1)
      << "the control: slides of print";
}

}  // namespace
}  // namespace erg::test
