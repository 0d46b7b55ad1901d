// Defects of made-up patterns of crests.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/crest_defects.h"

namespace erg {

using analysis::CoarseSurface;
using analysis::count_crest_defects;

namespace {

/// Waves 16 cells long under a west wind. With `ends`, one crest more between two points one over the other.
CoarseSurface waves(bool ends) {
  CoarseSurface surface;
  surface.heights = Grid<double>(Extent{128, 128});
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      double phase = 2 * std::numbers::pi * x / 16;
      if (ends) phase += std::atan2(y - 40.5, x - 64.5) - std::atan2(y - 88.5, x - 64.5);
      surface.heights(x, y) = std::cos(phase);
    }
  }
  return surface;
}

TEST(CrestDefects, StraightCrestsHaveNone) {
  EXPECT_EQ(count_crest_defects(waves(false), 270, 16), 0);
  EXPECT_EQ(count_crest_defects(waves(false), 90, 16), 0);
}

TEST(CrestDefects, ACrestMoreHasTwoEnds) {
  EXPECT_EQ(count_crest_defects(waves(true), 270, 16), 2);
  EXPECT_EQ(count_crest_defects(waves(true), 90, 16), 2) << "the wind's sense does not matter";
}

TEST(CrestDefects, FlatGroundAndNoSpacingHaveNone) {
  CoarseSurface flat;
  flat.heights = Grid<double>(Extent{16, 16}, 3.0);
  EXPECT_EQ(count_crest_defects(flat, 270, 8), 0);
  EXPECT_EQ(count_crest_defects(waves(true), 270, 0), 0);
}

}  // namespace
}  // namespace erg
