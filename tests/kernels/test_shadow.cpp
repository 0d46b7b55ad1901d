#include "kernels/shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"

namespace erg {

using kernels::shadow_fall;
using kernels::shadow_map;

namespace {

Terrain rough_terrain(Extent extent, Boundary boundary, std::uint32_t range) {
  Terrain terrain(extent, 1.0, 1.0 / 3, boundary);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  Grid<std::int32_t>& bedrock = terrain.edit_bedrock();
  for (std::size_t cell = 0; cell < mobile.size(); ++cell) {
    mobile[cell] = static_cast<std::int32_t>(random_below({7, 0}, 0, cell, 0, range));
    bedrock[cell] = static_cast<std::int32_t>(random_below({7, 0}, 1, cell, 0, 5)) - 2;
  }
  return terrain;
}

// The definition, cell by cell: some upwind cell at distance d is higher by more than d * fall.
bool dark_by_definition(const Terrain& terrain, int x, int y, int dx, int dy, double fall) {
  const int rounds = 3 * std::max(terrain.nx(), terrain.ny());
  for (int distance = 1; distance <= rounds; ++distance) {
    const int up_x = x - dx * distance;
    const int up_y = y - dy * distance;
    const bool outside = up_x < 0 || up_x >= terrain.nx() || up_y < 0 || up_y >= terrain.ny();
    if (outside && terrain.boundary() == Boundary::open) return false;
    const int there = terrain.height(wrap(up_x, terrain.nx()), wrap(up_y, terrain.ny()));
    if (there - terrain.height(x, y) > distance * fall) return true;
  }
  return false;
}

struct AxisWind {
  double bearing;
  int dx, dy;
};

TEST(Shadow, IsTheDefinitionForAxisWinds) {
  const double fall = shadow_fall(15, 1.0, 1.0 / 3);
  for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
    for (const Extent extent : {Extent{23, 14}, Extent{1, 9}, Extent{9, 1}, Extent{1, 1}}) {
      const Terrain terrain = rough_terrain(extent, boundary, 25);
      for (const AxisWind wind : {AxisWind{270, 1, 0}, {90, -1, 0}, {180, 0, 1}, {0, 0, -1}}) {
        const auto dark = shadow_map(terrain, wind.bearing, fall);
        for (int y = 0; y < extent.ny; ++y) {
          for (int x = 0; x < extent.nx; ++x) {
            ASSERT_EQ(dark(x, y) != 0, dark_by_definition(terrain, x, y, wind.dx, wind.dy, fall))
                << wind.bearing << " deg at " << x << ", " << y;
          }
        }
      }
    }
  }
}

TEST(Shadow, ACellExactlyOnTheLineIsLit) {
  Terrain terrain({20, 1}, 1.0, 1.0);
  terrain.edit_mobile()(2, 0) = 4;
  terrain.edit_bedrock()(7, 0) = 0;  // 5 cells behind, 4 lower: 5 * 0.8 = 4
  const auto dark = shadow_map(terrain, 270, 0.8);
  EXPECT_EQ(dark(6, 0), 1);
  EXPECT_EQ(dark(7, 0), 0);
}

TEST(Shadow, ReachesRoundTheTorusButNotOverAnOpenEdge) {
  for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
    Terrain terrain({30, 3}, 1.0, 1.0 / 3, boundary);
    for (int y = 0; y < 3; ++y) terrain.edit_mobile()(28, y) = 10;
    const auto dark = shadow_map(terrain, 270, 0.8);
    EXPECT_EQ(dark(29, 1), 1);
    EXPECT_EQ(dark(5, 1), boundary == Boundary::torus ? 1 : 0);
    EXPECT_EQ(dark(15, 1), 0);
  }
}

TEST(Shadow, TurnsWithTheTerrain) {
  const Terrain terrain = rough_terrain({24, 17}, Boundary::torus, 30);
  Terrain turned({17, 24}, 1.0, 1.0 / 3);  // a quarter clockwise: east becomes south
  for (int y = 0; y < 17; ++y) {
    for (int x = 0; x < 24; ++x) {
      turned.edit_mobile()(y, 23 - x) = terrain.mobile()(x, y);
      turned.edit_bedrock()(y, 23 - x) = terrain.bedrock()(x, y);
    }
  }
  for (const double bearing : {255.0, 240.0, 300.0, 20.0}) {
    const auto dark = shadow_map(terrain, bearing, 0.804);
    const auto dark_turned = shadow_map(turned, bearing + 90, 0.804);
    for (int y = 0; y < 17; ++y) {
      for (int x = 0; x < 24; ++x) ASSERT_EQ(dark(x, y), dark_turned(y, 23 - x)) << bearing;
    }
  }
}

// A wall across an oblique wind casts a shadow of height / fall cells along the wind, whatever the bearing.
TEST(Shadow, IsAsLongAtEveryBearing) {
  for (const double bearing : {270.0, 255.0, 240.0, 225.0}) {
    Terrain terrain({200, 200}, 1.0, 1.0 / 3, Boundary::open);
    for (int y = 90; y < 110; ++y) {
      for (int x = 90; x < 110; ++x) terrain.edit_mobile()(x, y) = 24;  // shadow: 24 / 0.8 = 30 cells
    }
    const auto dark = shadow_map(terrain, bearing, 0.8);
    const double toward_x = -std::sin(bearing * std::numbers::pi / 180);
    const double toward_y = -std::cos(bearing * std::numbers::pi / 180);
    const double edge = 10 / toward_x;  // from the middle to the far side of the block, along the wind
    const auto dark_at = [&](double distance) {
      return dark(static_cast<int>(100 + toward_x * (edge + distance)),
                  static_cast<int>(100 + toward_y * (edge + distance)));
    };
    EXPECT_EQ(dark_at(26), 1) << bearing;
    EXPECT_EQ(dark_at(33), 0) << bearing;
  }
}

// Under an oblique wind the next cell stands far from the wind's direction, so a step of one slab is looked for two
// rows upwind, along an axis in the next row.
TEST(Shadow, AStepOfOneSlabIsSeenTwoRowsUpwindOfAnObliqueWind) {
  for (const double bearing : {270.0, 280.0, 250.0, 225.0}) {
    Terrain terrain({40, 40}, 1.0, 1.0 / 3, Boundary::open);
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 20; ++x) terrain.edit_mobile()(x, y) = 1;
    }
    const auto dark = shadow_map(terrain, bearing, 0.8);
    const bool along_an_axis = bearing == 270.0;
    for (int y = 10; y < 30; ++y) {  // where neither the sides nor the ends are near
      EXPECT_EQ(dark(20, y), 1) << bearing << ": the foot of the step";
      EXPECT_EQ(dark(21, y), along_an_axis ? 0 : 1) << bearing << ": the second row behind it";
      EXPECT_EQ(dark(22, y), 0) << bearing;
    }
  }
}

TEST(Shadow, AThinWallShadesTheCellBehindItAtEveryBearing) {
  for (const double bearing : {270.0, 280.0, 250.0, 225.0}) {
    Terrain terrain({40, 40}, 1.0, 1.0 / 3, Boundary::open);
    for (int y = 0; y < 40; ++y) terrain.edit_mobile()(20, y) = 6;
    const auto dark = shadow_map(terrain, bearing, 0.8);
    for (int behind = 1; behind <= 5; ++behind) EXPECT_EQ(dark(20 + behind, 20), 1) << bearing << ", " << behind;
    EXPECT_EQ(dark(30, 20), 0) << bearing;
  }
}

TEST(Shadow, FallIsTheTangent) { EXPECT_NEAR(shadow_fall(15, 1.0, 1.0 / 3), 0.8038, 1e-4); }

}  // namespace
}  // namespace erg
