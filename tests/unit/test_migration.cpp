#include "analysis/migration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace erg {

using analysis::CoarseSurface;
using analysis::pattern_shift;

namespace {

// A few smooth heaps on a torus, moved by (dx, dy).
CoarseSurface heaps(Extent extent, double dx, double dy, bool periodic = true) {
  CoarseSurface surface{Grid<double>(extent), 1, 1, periodic};
  const double centres[4][3] = {{0.2, 0.3, 9}, {0.55, 0.6, 14}, {0.8, 0.25, 6}, {0.35, 0.8, 11}};
  for (int y = 0; y < extent.ny; ++y) {
    for (int x = 0; x < extent.nx; ++x) {
      for (const auto& [cx, cy, height] : centres) {
        const double east = std::remainder(x - dx - cx * extent.nx, extent.nx);
        const double north = std::remainder(y - dy - cy * extent.ny, extent.ny);
        surface.heights(x, y) += height * std::exp(-(east * east + north * north) / 50);
      }
    }
  }
  return surface;
}

TEST(Migration, FindsWholeAndBrokenShifts) {
  const Extent extent{120, 90};
  const CoarseSurface start = heaps(extent, 0, 0);
  const double shifts[][2] = {{3, 0}, {0, -7}, {-11, 5}, {0.25, 0}, {0.5, -0.5}, {2.3, 1.8}, {0.04, 0.4}};
  for (const auto& [dx, dy] : shifts) {
    const auto found = pattern_shift(start, heaps(extent, dx, dy));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, dx, 0.02);
    EXPECT_NEAR(found->y, dy, 0.02);
  }
}

TEST(Migration, EndlessCrestsMoveAcrossThemselves) {
  const auto crests = [](double shift) {  // crests along a diagonal; the pattern moves `shift` cells east
    CoarseSurface surface{Grid<double>({96, 96}), 1, 1, true};
    for (int y = 0; y < 96; ++y) {
      for (int x = 0; x < 96; ++x) surface.heights(x, y) = std::cos(2 * std::numbers::pi * (x - shift + y) / 32);
    }
    return surface;
  };
  const auto found = pattern_shift(crests(0), crests(3));
  ASSERT_TRUE(found);
  // Only the motion across the crests shows: the part of (3, 0) along (1, 1).
  EXPECT_NEAR(found->x, 1.5, 0.02);
  EXPECT_NEAR(found->y, 1.5, 0.02);
}

TEST(Migration, NothingMovesOnAFlatSurfaceAndNothingStandingMoves) {
  const CoarseSurface flat{Grid<double>({20, 20}, 4.0), 1, 1, true};
  EXPECT_FALSE(pattern_shift(flat, flat));
  const CoarseSurface still = heaps({64, 64}, 0, 0);
  const auto none = pattern_shift(still, still);
  ASSERT_TRUE(none);
  EXPECT_NEAR(none->x, 0, 1e-9);
  EXPECT_NEAR(none->y, 0, 1e-9);
}

TEST(Migration, TrackerGivesTheMeanVelocity) {
  analysis::MigrationTracker tracker;
  EXPECT_FALSE(tracker.velocity());
  for (const int step : {0, 10, 30, 60}) tracker.observe(step, heaps({128, 128}, 0.15 * step, -0.05 * step));
  ASSERT_TRUE(tracker.velocity());
  EXPECT_NEAR(tracker.velocity()->x, 0.15, 0.001);
  EXPECT_NEAR(tracker.velocity()->y, -0.05, 0.001);
  EXPECT_EQ(tracker.steps(), 60);
  tracker.observe(70, heaps({64, 64}, 0, 0));  // another extent: a new beginning
  EXPECT_FALSE(tracker.velocity());
}

TEST(Migration, CountsInCellsOfTheTerrain) {
  CoarseSurface first = heaps({100, 100}, 0, 0);
  CoarseSurface second = heaps({100, 100}, 2, 1);
  first.cells_x = second.cells_x = 1.5;
  first.cells_y = second.cells_y = 4;
  const auto found = pattern_shift(first, second);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 3, 0.03);
  EXPECT_NEAR(found->y, 4, 0.08);
}

TEST(Migration, OpenGridsAreMeasuredToo) {
  const auto found = pattern_shift(heaps({120, 120}, 0, 0, false), heaps({120, 120}, 1.5, 0, false));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 1.5, 0.3);  // fading out the edges pulls a little toward zero
  EXPECT_NEAR(found->y, 0, 0.2);
}

}  // namespace
}  // namespace erg
