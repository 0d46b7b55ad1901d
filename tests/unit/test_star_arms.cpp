// Arms of star dunes, on dunes whose arms are known.
#include "analysis/star_arms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.h"

namespace erg {

using analysis::count_arms;
using analysis::find_stars;
using analysis::StarArms;

namespace {

constexpr int side = 128;

double distance_to_arm(double x, double y, double bearing) {
  const double along = x * std::sin(radians(bearing)) + y * std::cos(radians(bearing));
  const double across = x * std::cos(radians(bearing)) - y * std::sin(radians(bearing));
  return along >= 0 ? std::abs(across) : std::hypot(x, y);
}

/// A star with ridges that fall to nothing over `reach` cells, the first at `bearing`, its middle at (x, y) of a torus.
void add_star(Grid<double>& heights, int arms, double bearing, double x, double y, double reach) {
  for (int row = 0; row < heights.ny(); ++row) {
    for (int column = 0; column < heights.nx(); ++column) {
      const double dx = std::remainder(column - x, heights.nx());
      const double dy = std::remainder(row - y, heights.ny());
      double high = 0;
      for (int arm = 0; arm < arms; ++arm) {
        const double crest = 12 * std::max(0.0, 1 - std::hypot(dx, dy) / reach);
        high = std::max(high, crest - 0.6 * distance_to_arm(dx, dy, bearing + 360.0 * arm / arms));
      }
      heights(column, row) += high;
    }
  }
}

Grid<double> star(int arms, double bearing, double x = 64, double y = 64) {
  Grid<double> heights({side, side});
  add_star(heights, arms, bearing, x, y, 40);
  return heights;
}

TEST(StarArms, AsManyAsWereMadeAndWhereTheyPoint) {
  for (int arms = 2; arms <= 6; ++arms) {
    for (const double bearing : {0.0, 11.0, 38.0}) {
      SCOPED_TRACE(testing::Message() << arms << " arms at " << bearing);
      const StarArms found = count_arms(star(arms, bearing), 64, 64, 45);
      EXPECT_EQ(found.arms, arms);
      EXPECT_GT(found.depth, 0.4);
      EXPECT_NEAR(std::remainder(found.bearing - bearing, 360.0 / arms), 0, 2);
      EXPECT_NEAR(found.height, 12, 0.1);
      EXPECT_NEAR(found.x, 64, 0.5);
      EXPECT_NEAR(found.y, 64, 0.5);
    }
  }
}

TEST(StarArms, OverTheEdgeOfTheTorusAndFromBesideTheMiddle) {
  const StarArms found = count_arms(star(5, 20, 1, 126), 4, 0, 45);
  EXPECT_EQ(found.arms, 5);
  EXPECT_NEAR(std::remainder(found.x - 1, side), 0, 1);
  EXPECT_NEAR(std::remainder(found.y - 126, side), 0, 1);
}

TEST(StarArms, OnUnevenArmsOneLongerThanTheOthers) {
  Grid<double> heights = star(4, 30);
  Grid<double> longer({side, side});
  add_star(longer, 1, 30, 64, 64, 55);
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = std::max(heights[i], longer[i]);
  const StarArms found = count_arms(heights, 64, 64, 55);
  EXPECT_EQ(found.arms, 4);
  EXPECT_GT(found.harmonics[1], 0.1);
}

TEST(StarArms, AConeADomeAndFlatGroundHaveNone) {
  Grid<double> cone({side, side});
  Grid<double> dome({side, side});
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double far = std::hypot(x - 64, y - 64);
      cone(x, y) = std::max(0.0, 12 - 0.4 * far);
      dome(x, y) = far < 30 ? 12 * std::cos(far / 30 * std::numbers::pi / 2) : 0;
    }
  }
  EXPECT_EQ(count_arms(cone, 64, 64, 45).arms, 0);
  EXPECT_LT(count_arms(cone, 64, 64, 45).depth, 0.05);
  EXPECT_EQ(count_arms(dome, 64, 64, 45).arms, 0);
  EXPECT_EQ(count_arms(Grid<double>({side, side}, 3), 64, 64, 45).arms, 0);
}

TEST(StarArms, CornersOfAPyramidCountAndStandOutLessThanArms) {
  const double depths[] = {0.84, 0.43, 0.26, 0.18};  // the Fourier series of 1 / cos^3 over a side
  for (int sides = 3; sides <= 6; ++sides) {
    SCOPED_TRACE(sides);
    Grid<double> pyramid({side, side});
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        double out = 0;  // from the middle, toward the side that faces this way
        for (int i = 0; i < sides; ++i) {
          const double turn = radians(90 + 180.0 / sides + 360.0 * i / sides);
          out = std::max(out, (x - 64) * std::sin(turn) + (y - 64) * std::cos(turn));
        }
        pyramid(x, y) = std::max(0.0, 12 * (1 - out / 24));
      }
    }
    const StarArms found = count_arms(pyramid, 64, 64, 60);
    EXPECT_EQ(found.arms, sides);
    EXPECT_NEAR(found.depth, depths[sides - 3], 0.02);
    EXPECT_NEAR(std::remainder(found.bearing - 90, 360.0 / sides), 0, 1);
    EXPECT_GT(count_arms(star(sides, 90), 64, 64, 45).depth, 1.3 * found.depth);
  }
}

TEST(StarArms, EveryDuneOfAFieldTheHighestFirst) {
  Grid<double> heights({256, 256});
  add_star(heights, 3, 10, 60, 70, 36);
  add_star(heights, 4, 10, 190, 180, 40);
  add_star(heights, 4, 30, 190, 60, 34);
  Terrain terrain({256, 256}, 1, 0.1);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (std::size_t i = 0; i < heights.size(); ++i) mobile[i] = static_cast<std::int32_t>(std::lround(10 * heights[i]));
  for (int y = 170; y < 200; ++y) {
    for (int x = 180; x < 200; ++x) mobile(x, y) += 20;  // the middle of the second: the highest
  }
  const std::vector<StarArms> stars = find_stars(terrain, 90);
  ASSERT_EQ(stars.size(), 3u);
  EXPECT_EQ(stars[0].arms, 4);
  EXPECT_NEAR(stars[0].x, 190, 3);
  EXPECT_EQ(stars[1].arms + stars[2].arms, 7);
  EXPECT_TRUE(find_stars(Terrain({64, 64}, 1, 0.1), 20).empty()) << "bare ground";
}

}  // namespace
}  // namespace erg
