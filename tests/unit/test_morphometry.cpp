#include "analysis/morphometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace erg {

using analysis::measure;
using analysis::Morphometry;

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

TEST(Morphometry, HighGroundCostsNoPrecision) {
  Terrain terrain({64, 64}, 1.0, 0.001);
  terrain.edit_bedrock().fill(1'000'000'000);
  terrain.edit_bedrock()(3, 3) += 64;
  EXPECT_NEAR(measure(terrain).sd_surface, 0.001 * std::sqrt(1 - 1.0 / 4096), 1e-9);
}

TEST(Morphometry, ShadowFractionIsTheShareOfDarkCells) {
  Grid<std::uint8_t> shadow({4, 2});
  shadow(1, 1) = shadow(2, 0) = 1;
  EXPECT_DOUBLE_EQ(analysis::shadow_fraction(shadow), 0.25);
}

}  // namespace
}  // namespace erg
