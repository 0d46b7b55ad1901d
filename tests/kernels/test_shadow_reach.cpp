// How far upwind lines begin to look for shadow: far enough, and no farther than need be.
#include "kernels/shadow_reach.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "kernels/shadow.h"

namespace erg {

using kernels::shadow_map;
using kernels::shadow_reach;

namespace {

TEST(ShadowReach, IsWhereAShadowLineHasFallenFromTheHighestSurfaceToTheLowest) {
  for (const double relief : {0.0, 1.0, 37.0, 40000.0}) {
    for (const double fall : {0.004, 0.3, 1.0, 12.5}) {
      for (const double cosine : {1.0, 0.9, 0.7072}) {
        const int reach = shadow_reach(relief, fall, cosine, 1 << 30);
        EXPECT_GE((reach - 1) * fall / cosine, relief) << relief << ", " << fall;
        EXPECT_LE((reach - 4) * fall / cosine, relief) << relief << ", " << fall;
      }
    }
  }
  EXPECT_EQ(shadow_reach(100, 1e-3, 1, 50), 50);
  EXPECT_EQ(shadow_reach(100, 0, 1, 50), 50);
}

/// Lines of three tiles side by side begin as far from the middle one as they like; on one tile, where the rule says.
TEST(ShadowReach, FindsTheShadowsThatTilesOfTheSameLandFind) {
  const Extent tile{23, 5};
  Terrain one(tile, 1, 1);
  Terrain three({3 * tile.nx, tile.ny}, 1, 1);
  for (int y = 0; y < tile.ny; ++y) {
    for (int x = 0; x < tile.nx; ++x) {
      const auto cell = static_cast<std::uint64_t>(y * tile.nx + x);
      const auto height = static_cast<std::int32_t>(cell % 31 == 0 ? 60 : random_below({5, 0}, 0, cell, 0, 9));
      one.edit_mobile()(x, y) = height;
      for (int k = 0; k < 3; ++k) three.edit_mobile()(x + k * tile.nx, y) = height;
    }
  }
  for (const double fall : {0.2, 1.7, 3.0, 11.0}) {
    const Grid<std::uint8_t> dark = shadow_map(one, 270, fall);
    const Grid<std::uint8_t> tiles = shadow_map(three, 270, fall);
    int shaded = 0;
    for (int y = 0; y < tile.ny; ++y) {
      for (int x = 0; x < tile.nx; ++x) {
        shaded += dark(x, y);
        EXPECT_EQ(dark(x, y), tiles(x + tile.nx, y)) << x << ", " << y << ", fall " << fall;
      }
    }
    EXPECT_GT(shaded, 0) << fall;
    EXPECT_LT(shaded, tile.nx * tile.ny) << fall;
  }
}

}  // namespace
}  // namespace erg
