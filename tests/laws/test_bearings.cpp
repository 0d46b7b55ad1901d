// A wind that swings as real winds do makes dunes whose sides are alike at an oblique bearing; without, they lean.
#include <gtest/gtest.h>

#include <vector>

#include "analysis/dune_map.h"
#include "sim/simulation.h"

namespace erg::test {

using analysis::asymmetry;
using analysis::DuneMap;

namespace {

constexpr double bearing = 300;
constexpr int steps = 384;  // whole rounds of draws: six times sixteen draws of four steps

/// A Momiji barchan of 12 m in the mean of three seeds.
DuneMap mean_barchan(double spread) {
  std::vector<DuneMap> maps;
  for (const char* seed : {"1", "2", "3"}) {
    sim::Config config("momiji");
    for (const std::string& setting :
         {std::string("scene.kind=cone"), std::string("scene.sand=0"), std::string("scene.height=12"),
          std::string("scene.radius=36"), std::string("run.executor=cpu"), std::string("run.threads=1"),
          std::string("run.seed=") + seed}) {
      sim::set_from_text(config, setting);
    }
    config.wind.intervals.front().bearing = bearing;
    config.wind.intervals.front().spread = spread;
    sim::Simulation simulation(config);
    while (simulation.step_count() < steps) simulation.step();
    maps.push_back(analysis::dune_map(simulation.terrain(), bearing, 90));
  }
  return analysis::mean_map(maps);
}

TEST(Bearings, ASpreadKeepsABarchanFromLeaning) {
  const DuneMap swinging = mean_barchan(models::natural_spread);
  EXPECT_LT(asymmetry(swinging), 0.06);
  const analysis::HornVolumes horns = analysis::find_horns(swinging, 0.5);
  EXPECT_GT(horns.left, 0.6 * horns.right);
  EXPECT_LT(horns.left, 1.6 * horns.right);
  EXPECT_GT(asymmetry(mean_barchan(0)), 0.12) << "the control: a wind from one bearing for ever";
}

}  // namespace
}  // namespace erg::test
