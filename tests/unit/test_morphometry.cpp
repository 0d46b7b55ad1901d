#include "analysis/morphometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace erg {
namespace {

TEST(Morphometry, CountsTheMobileLayer) {
  Terrain terrain({2, 2}, 1.0, 0.5);
  terrain.edit_mobile()(0, 0) = 4;
  terrain.edit_mobile()(1, 0) = 2;
  terrain.edit_mobile()(0, 1) = 2;
  terrain.edit_bedrock()(1, 1) = 100;  // a rock counts for the surface only
  const Morphometry m = measure(terrain);
  EXPECT_EQ(m.max_slabs, 4);
  EXPECT_DOUBLE_EQ(m.mean_slabs, 2);
  EXPECT_DOUBLE_EQ(m.sd_slabs, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(m.bare_fraction, 0.25);
  EXPECT_DOUBLE_EQ(m.lowest, 1);
  EXPECT_DOUBLE_EQ(m.highest, 50);
}

TEST(Morphometry, APlaneHasItsSlopeEverywhere) {
  Terrain terrain({12, 9}, 2.0, 0.5, Boundary::open);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 12; ++x) terrain.edit_bedrock()(x, y) = 4 * x;  // 2 m rise over 2 m: 45 degrees
  }
  const Morphometry m = measure(terrain);
  EXPECT_NEAR(m.steepest_slope, 45, 1e-9);
  // Interior columns stand at 45 degrees; at the two open edges the difference is one-sided, half as large.
  EXPECT_NEAR(m.mean_slope, (10 * 45 + 2 * degrees(std::atan(0.5))) / 12, 1e-9);
}

TEST(Morphometry, SeesTheStepOverTheEdgeOfATorusOnly) {
  for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
    Terrain terrain({10, 1}, 1.0, 1.0, boundary);
    for (int x = 0; x < 10; ++x) terrain.edit_mobile()(x, 0) = x;
    EXPECT_NEAR(std::tan(radians(measure(terrain).steepest_slope)), boundary == Boundary::torus ? 9 : 1, 1e-9);
  }
}

TEST(Morphometry, HighGroundCostsNoPrecision) {
  Terrain terrain({64, 64}, 1.0, 0.001);
  terrain.edit_bedrock().fill(1'000'000'000);
  terrain.edit_bedrock()(3, 3) += 64;
  EXPECT_NEAR(measure(terrain).sd_surface, 0.001 * std::sqrt(1 - 1.0 / 4096), 1e-9);
}

TEST(Morphometry, ShadowFractionIsTheShareOfDarkCells) {
  Grid<std::uint8_t> shadow({4, 2});
  shadow(1, 1) = shadow(2, 0) = 1;
  EXPECT_DOUBLE_EQ(shadow_fraction(shadow), 0.25);
}

}  // namespace
}  // namespace erg
