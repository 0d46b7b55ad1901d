// Dunes on made-up terrains whose measures are known.
#include "analysis/dune_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/dune_tracker.h"
#include "core/units.h"

namespace erg {

using analysis::Dune;
using analysis::DuneOutlines;
using analysis::DuneTracker;
using analysis::find_dunes;
using analysis::match_dunes;

namespace {

constexpr double west = 270;
constexpr double slab = 0.01;  // m: fine, so that rounding hides nothing

/// Adds a height (m) given as a function of place (m, from the middle at (x, y)) to the sand, around the torus.
template <typename Height>
void put(Terrain& terrain, double x, double y, Height height) {
  const double side = terrain.cell_size();
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (int row = 0; row < terrain.ny(); ++row) {
    for (int column = 0; column < terrain.nx(); ++column) {
      const double east = std::remainder((column + 0.5) * side - x, terrain.nx() * side);
      const double north = std::remainder((row + 0.5) * side - y, terrain.ny() * side);
      mobile(column, row) += static_cast<std::int32_t>(std::lround(height(east, north) / terrain.quantum()));
    }
  }
}

auto cone(double height, double radius) {
  return [=](double east, double north) { return std::max(0.0, height * (1 - std::hypot(east, north) / radius)); };
}

/// An ideal barchan in a wind from `bearing`, 5 m high: a disk with a smaller one, farther downwind, cut out.
constexpr double body = 30;
constexpr double bay = 24;
constexpr double ahead = 20;
auto barchan(double bearing) {
  return [=](double east, double north) {
    const double along = -std::sin(radians(bearing)) * east - std::cos(radians(bearing)) * north;
    const double across = -std::sin(radians(bearing)) * north + std::cos(radians(bearing)) * east;
    const bool in_body = std::hypot(along, across) < body;
    return in_body && std::hypot(along - ahead, across) > bay ? 5.0 : 0.0;
  };
}
/// How far downwind of the body's middle the two circles cross: the tips of the horns.
constexpr double tips = (body * body - bay * bay + ahead * ahead) / (2 * ahead);

TEST(DuneOutlines, AConeIsAsHighWideSteepAndLargeAsItIs) {
  for (const double bearing : {270.0, 300.0, 225.0, 17.0}) {
    Terrain terrain({128, 128}, 1, slab);
    put(terrain, 64, 64, cone(20, 40));
    const DuneOutlines found = find_dunes(terrain, bearing);
    ASSERT_EQ(found.dunes.size(), 1u);
    EXPECT_EQ(found.rule.base, 0);
    const Dune& dune = found.dunes[0];
    EXPECT_NEAR(dune.x, 64, 0.01);
    EXPECT_NEAR(dune.y, 64, 0.01);
    EXPECT_NEAR(dune.height, 20 * (1 - std::sqrt(0.5) / 40), slab) << "at the middle of the cell beside the top";
    // The outline runs where the sand is thicker than the mean over the terrain: 2.05 m.
    const double mean = static_cast<double>(terrain.total_mobile()) * slab / (128 * 128);
    const double across = 2 * 40 * (1 - mean / 20);
    EXPECT_NEAR(dune.width, across, 1.5);
    EXPECT_NEAR(dune.length, across, 1.5);
    const double whole = std::numbers::pi * 40 * 40 * 20 / 3;
    EXPECT_NEAR(dune.volume / whole, 1 - std::pow(mean / 20, 2) * (3 - 2 * mean / 20), 0.01);
    ASSERT_TRUE(dune.slip_face);
    EXPECT_NEAR(*dune.slip_face, degrees(std::atan(0.5)), 0.3);
    EXPECT_FALSE(dune.horns);
    EXPECT_NEAR(dune.arms, 0, 0.02);
  }
}

TEST(DuneOutlines, MetresFollowCellsAndSlabs) {
  Terrain terrain({64, 64}, 2.5, 0.25);
  put(terrain, 80, 80, cone(20, 40));
  const DuneOutlines found = find_dunes(terrain, west, {.base = 0, .least = 8, .smallest = 30});  // from 2 m on
  ASSERT_EQ(found.dunes.size(), 1u);
  EXPECT_NEAR(found.dunes[0].x, 80, 0.1);
  EXPECT_NEAR(found.dunes[0].height, 20, 1);
  EXPECT_NEAR(found.dunes[0].width, 2 * 40 * 0.9, 3);
  EXPECT_NEAR(found.dunes[0].volume, std::numbers::pi * 40 * 40 * 20 / 3 * 0.972, 400);
  ASSERT_TRUE(found.dunes[0].slip_face);
  EXPECT_NEAR(*found.dunes[0].slip_face, degrees(std::atan(0.5)), 1.5);
}

TEST(DuneOutlines, AGentleConeHasNoSlipFaceAndRockIsNoSand) {
  Terrain terrain({128, 128}, 1, slab);
  put(terrain, 64, 64, cone(10, 40));  // 14 degrees
  terrain.edit_bedrock()(10, 10) = 5000;
  const DuneOutlines found = find_dunes(terrain, west);
  ASSERT_EQ(found.dunes.size(), 1u);
  EXPECT_FALSE(found.dunes[0].slip_face);
}

TEST(DuneOutlines, ABarchanHasItsHornsAtAnyBearing) {
  for (const double bearing : {270.0, 90.0, 285.0, 300.0, 315.0, 180.0, 222.0}) {
    Terrain terrain({128, 128}, 1, slab);
    put(terrain, 64, 64, barchan(bearing));
    const DuneOutlines found = find_dunes(terrain, bearing);
    ASSERT_EQ(found.dunes.size(), 1u) << bearing;
    const Dune& dune = found.dunes[0];
    EXPECT_NEAR(dune.height, 5, 1e-9);
    EXPECT_NEAR(dune.width, 2 * body, 1.5) << bearing;
    EXPECT_NEAR(dune.length, body + tips, 1.5) << bearing;
    ASSERT_TRUE(dune.horns) << bearing;
    EXPECT_NEAR(dune.horns->left, tips - (ahead - bay), 1.6) << bearing;
    EXPECT_NEAR(dune.horns->right, tips - (ahead - bay), 1.6) << bearing;
    EXPECT_GT(dune.arms, 0.3) << bearing;
  }
}

TEST(DuneOutlines, HornsAreLeftAndRightLookingDownwind) {
  Terrain terrain({96, 96}, 1, slab);
  put(terrain, 48, 48, [](double east, double north) {  // wind from the west; the northern horn, on the left, is longer
    const bool inside = std::abs(north) < 15 && east > -10 && east < (north > 7 ? 20 : north < -7 ? 10 : 0);
    return inside ? 4.0 : 0.0;
  });
  const Dune dune = find_dunes(terrain, 270).dunes.at(0);
  ASSERT_TRUE(dune.horns);
  EXPECT_NEAR(dune.horns->left, 20, 1);
  EXPECT_NEAR(dune.horns->right, 10, 1);
  EXPECT_FALSE(find_dunes(terrain, 90).dunes.at(0).horns) << "a wind from the east meets the horns first";
}

TEST(DuneOutlines, ArmsPointUpwindOfTheMiddleOrDownwind) {
  for (const int pull : {-12, 0, 12}) {
    Terrain terrain({64, 64}, 1, slab);
    for (int across = -8; across <= 8; ++across) {  // a bar whose sides are drawn out along the wind
      const int shift = pull * across * across / 64;
      for (int along = -3; along <= 3; ++along) terrain.edit_mobile()(20 + along + shift, 20 + across) = 900;
    }
    const Dune dune = find_dunes(terrain, west).dunes.at(0);
    EXPECT_EQ(dune.cells, 7 * 17);
    if (pull == 0) {
      EXPECT_NEAR(dune.arms, 0, 1e-9);
      EXPECT_NEAR(dune.length, 7, 1e-9);
      EXPECT_NEAR(dune.width, 17, 1e-9);
    } else {
      EXPECT_GT(dune.arms * pull, 0);
      EXPECT_LT(find_dunes(terrain, 90).dunes.at(0).arms * pull, 0) << "the other wind";
      EXPECT_NEAR(find_dunes(terrain, 0).dunes.at(0).arms, 0, 1e-9) << "symmetric about the x axis";
    }
  }
}

TEST(DuneOutlines, AreWholeAcrossTheEdgeAndApartWhenTheyDoNotTouch) {
  Terrain terrain({32, 32}, 1, 1);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (const int x : {30, 31, 0, 1}) mobile(x, 31) = mobile(x, 0) = 9;  // 4 by 2 over a corner
  mobile(2, 1) = 9;                                                     // touches it at a corner only
  for (int x = 0; x < 32; ++x) mobile(x, 16) = 9;                       // around the torus: no ends
  const DuneOutlines found = find_dunes(terrain, west, {.base = 0, .least = 9, .smallest = 2});
  ASSERT_EQ(found.dunes.size(), 1u);
  EXPECT_EQ(found.endless, 1);
  EXPECT_EQ(found.dunes[0].cells, 8);
  EXPECT_NEAR(found.dunes[0].length, 4, 1e-9);
  EXPECT_NEAR(found.dunes[0].width, 2, 1e-9);
  EXPECT_NEAR(std::remainder(found.dunes[0].x, 32), 0, 1e-9);
  EXPECT_GE(found.dunes[0].x, 0);
  EXPECT_LT(found.dunes[0].x, 32);
  EXPECT_EQ(find_dunes(terrain, west, {.base = 0, .least = 9, .smallest = 1}).dunes.size(), 2u);
  EXPECT_TRUE(find_dunes(terrain, west, {.base = 0, .least = 10, .smallest = 1}).dunes.empty());
  EXPECT_EQ(analysis::mean_of_dunes({}).dunes, 0);
}

TEST(DuneOutlines, OfABarchanAcrossTheCornerAreThoseOfOneInTheMiddle) {
  Terrain middle({96, 80}, 1, slab);
  put(middle, 48, 40, barchan(285));
  Terrain corner({96, 80}, 1, slab);
  put(corner, 0, 0, barchan(285));
  const Dune one = find_dunes(middle, 285).dunes.at(0);
  const Dune other = find_dunes(corner, 285).dunes.at(0);
  EXPECT_EQ(one.cells, other.cells);
  EXPECT_NEAR(one.width, other.width, 1e-9);
  EXPECT_NEAR(one.length, other.length, 1e-9);
  EXPECT_EQ(one.volume, other.volume);
  EXPECT_NEAR(std::remainder(one.x - other.x, 48), 0, 1e-9);
  EXPECT_NEAR(one.horns.value().left, other.horns.value().left, 1e-9);
  EXPECT_NEAR(one.slip_face.value(), other.slip_face.value(), 1e-9);
}

TEST(DuneOutlines, AnOpenEdgeCutsOff) {
  Terrain terrain({96, 80}, 1, slab, Boundary::open);
  put(terrain, 0, 40, cone(10, 20));  // half of it on either side
  EXPECT_TRUE(find_dunes(terrain, west).dunes.empty());
  EXPECT_EQ(find_dunes(terrain, west).cut, 2);
  put(terrain, 48, 40, cone(10, 20));
  EXPECT_EQ(find_dunes(terrain, west).dunes.size(), 1u);
}

TEST(DuneOutlines, NoneStandOnFlatOrBareLand) {
  Terrain terrain({32, 24}, 1, slab);
  EXPECT_TRUE(find_dunes(terrain, west).dunes.empty()) << "bare";
  EXPECT_TRUE(find_dunes(terrain, west, {.base = 0, .least = 0, .smallest = 1}).dunes.empty()) << "bare, any rule";
  terrain.edit_mobile().fill(700);
  const DuneOutlines found = find_dunes(terrain, west);
  EXPECT_TRUE(found.dunes.empty()) << "flat";
  EXPECT_EQ(found.endless, 0);
  EXPECT_EQ(found.rule.base, 700);
}

TEST(DuneOutlines, OnALayerCountFromItsTop) {
  Terrain terrain({96, 96}, 1, slab);
  terrain.edit_mobile().fill(300);
  put(terrain, 30, 30, cone(8, 12));
  put(terrain, 70, 60, cone(4, 12));
  const DuneOutlines found = find_dunes(terrain, west);
  ASSERT_EQ(found.dunes.size(), 2u);
  EXPECT_EQ(found.rule.base, 300);
  EXPECT_NEAR(found.dunes[0].height, 8, 0.5);
  EXPECT_NEAR(found.dunes[1].height, 4, 0.25);
  EXPECT_NEAR(found.dunes[0].volume / found.dunes[1].volume, 2, 0.05);
  EXPECT_NEAR(found.dunes[1].x, 70, 0.05);
}

/// The terrain of two cones that have moved by (dx, dy) m.
Terrain two_cones(double dx, double dy) {
  Terrain terrain({128, 96}, 1, slab);
  put(terrain, 120 + dx, 20 + dy, cone(6, 15));
  put(terrain, 40 + 2 * dx, 60 + 2 * dy, cone(3, 12));
  return terrain;
}

TEST(DuneTracker, FollowsEachDuneAroundTheTorus) {
  DuneTracker tracker;
  for (int look = 0; look <= 10; ++look) {
    const Terrain terrain = two_cones(2.3 * look, -0.7 * look);
    tracker.observe(5 * look, find_dunes(terrain, west).dunes, terrain);
    if (look == 2) tracker.start_ways();
  }
  ASSERT_EQ(tracker.tracks().size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const DuneTracker::Track& track = tracker.tracks()[i];
    const double speed = tracker.dunes()[i].height > 4 ? 1 : 2;
    EXPECT_NEAR(track.way.east, speed * 2.3 * 8, 0.1);
    EXPECT_NEAR(track.way.north, speed * -0.7 * 8, 0.1);
    EXPECT_EQ(track.since, 10);
    EXPECT_LE(track.number, 2);
  }
}

TEST(DuneTracker, TakesNoDuneForAnother) {
  const Terrain terrain = two_cones(0, 0);
  const std::vector<Dune> both = find_dunes(terrain, west).dunes;
  ASSERT_EQ(both.size(), 2u);
  EXPECT_FALSE(match_dunes({both[0]}, {both[1]}, terrain)[0]) << "too far away";
  Dune grown = both[0];
  grown.volume *= 2;
  EXPECT_FALSE(match_dunes({both[0]}, {grown}, terrain)[0]) << "it has merged";
  EXPECT_TRUE(match_dunes({}, both, terrain)[0] == std::nullopt);
  const auto matches = match_dunes({both[1], both[0]}, both, terrain);
  EXPECT_EQ(matches[0], 1u);
  EXPECT_EQ(matches[1], 0u);
  DuneTracker tracker;
  tracker.observe(0, {both[0]}, terrain);
  tracker.observe(5, both, terrain);
  EXPECT_EQ(tracker.tracks()[1].number, 2) << "a new one";
  EXPECT_EQ(tracker.tracks()[1].since, 5);
}

}  // namespace
}  // namespace erg
