// A heap under four equal winds becomes a pyramid whose ridges turn with the winds, where sand slides along diagonals
// too.
#include <gtest/gtest.h>

#include <string>

#include "analysis/star_arms.h"
#include "configured.h"
#include "core/units.h"
#include "sim/simulation.h"

namespace erg {

namespace {

/// Of a cone of 120 slabs under four equal winds, the first from `bearing`; 400 steps.
analysis::StarArms arms_under_four_winds(double bearing, const std::string& neighbours) {
  sim::Config config =
      test::configured("werner", {"grid.nx=256", "grid.ny=256", "scene.kind=cone", "scene.sand=0", "scene.height=40",
                                  "scene.radius=60", "parameters.neighbours=" + neighbours, "run.executor=cpu"});
  forcing::WindInterval season = config.wind.intervals.front();
  season.steps = 20;
  config.wind.intervals.clear();
  for (int wind = 0; wind < 4; ++wind) {
    season.bearing = fold_bearing(bearing + 90 * wind);
    config.wind.intervals.push_back(season);
  }
  sim::Simulation simulation(config);
  while (simulation.step_count() < 400) simulation.step();
  const std::vector<analysis::StarArms> stars = analysis::find_stars(simulation.terrain(), 128);
  return stars.empty() ? analysis::StarArms{} : stars.front();
}

TEST(StarDunes, HaveFourRidgesThatTurnWithFourWinds) {
  const analysis::StarArms one = arms_under_four_winds(20, "8");
  EXPECT_EQ(one.arms, 4);
  EXPECT_GT(one.bearing, 7) << "in [0, 90), from the axis toward the winds";
  EXPECT_LT(one.bearing, 20);
  const analysis::StarArms mirrored = arms_under_four_winds(70, "8");
  EXPECT_EQ(mirrored.arms, 4);
  EXPECT_NEAR(mirrored.bearing, 90 - one.bearing, 4);
  const analysis::StarArms of_print = arms_under_four_winds(20, "4");
  EXPECT_LT(of_print.bearing, one.bearing - 3) << "the control: slides along rows and columns hold them to the axes";
}

}  // namespace
}  // namespace erg
