// Dunes turned into the wind, on terrains whose shapes are known.
#include "analysis/dune_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/errors.h"
#include "core/units.h"

namespace erg {

using analysis::asymmetry;
using analysis::dune_centre;
using analysis::dune_map;
using analysis::DuneMap;
using analysis::find_horns;
using analysis::GridPoint;
using analysis::HornVolumes;
using analysis::mismatch;

namespace {

constexpr int side = 128;

/// A heap whose thickness (slabs of a tenth of a metre) is a function of the place downwind and to the left of its
/// middle, for a wind from `bearing`.
Terrain heap(double bearing, GridPoint middle, const std::function<double(double, double)>& height) {
  Terrain terrain(Extent{side, side}, 1, 0.1);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  const double turn = radians(bearing);
  const GridPoint downwind{-std::sin(turn), -std::cos(turn)};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double east = std::remainder(x - middle.x, side);
      const double north = std::remainder(y - middle.y, side);
      const double along = east * downwind.x + north * downwind.y;
      const double left = north * downwind.x - east * downwind.y;
      mobile(x, y) = static_cast<std::int32_t>(std::lround(10 * std::max(0.0, height(along, left))));
    }
  }
  return terrain;
}

double cone_at(double along, double left) { return 10 - 0.5 * std::hypot(along, left); }

/// Two bars that point downwind, the left one `ratio` times as high as the right one, before a cross bar.
std::function<double(double, double)> horned(double ratio) {
  return [ratio](double along, double left) {
    if (along >= -10 && along < 0) return std::abs(left) <= 20 ? 8.0 : 0.0;
    if (along < 0 || along >= 15 || std::abs(left) > 20 || std::abs(left) < 10) return 0.0;
    return left > 0 ? 2 * ratio : 2.0;
  };
}

TEST(DuneMap, TheMiddleOfSandIsFoundAcrossTheEdge) {
  for (const GridPoint middle : {GridPoint{64, 64}, {3, 125}, {0.5, 70.25}}) {
    const auto centre = dune_centre(heap(270, middle, cone_at));
    ASSERT_TRUE(centre.has_value());
    EXPECT_NEAR(std::remainder(centre->x - middle.x, side), 0, 0.05);
    EXPECT_NEAR(std::remainder(centre->y - middle.y, side), 0, 0.05);
  }
}

TEST(DuneMap, WithoutAHeapThereIsNoMiddle) {
  Terrain even(Extent{side, side}, 1, 0.1);
  EXPECT_FALSE(dune_centre(even).has_value());
  even.edit_mobile().fill(4);
  EXPECT_FALSE(dune_centre(even).has_value());
  EXPECT_THROW(dune_map(even, 270, 20), InputError);
}

TEST(DuneMap, TurnsADuneIntoTheWindAndKeepsItsSand) {
  const DuneMap west = dune_map(heap(270, {64, 64}, horned(1)), 270, 40);
  for (const double bearing : {0.0, 33.0, 225.0, 300.0}) {
    const DuneMap map = dune_map(heap(bearing, {100, 20}, horned(1)), bearing, 40);
    EXPECT_NEAR(map.volume() / west.volume(), 1, 0.05) << bearing;
    EXPECT_LT(mismatch(map, west), 0.08) << bearing;
    EXPECT_LT(asymmetry(map), 0.06) << bearing;
  }
}

TEST(DuneMap, AsymmetryIsTheShareOfSandThatTheOtherSideLacks) {
  EXPECT_LT(asymmetry(dune_map(heap(285, {64, 64}, cone_at), 285, 40)), 0.01);
  // The heap's middle moves to the heavier horn; about the axis of the bars left and right would differ by 1/13 of it.
  EXPECT_GT(asymmetry(dune_map(heap(285, {64, 64}, horned(3)), 285, 40)), 0.08);
}

TEST(DuneMap, HornsAreMeasuredBehindTheFoot) {
  for (const double bearing : {270.0, 300.0}) {
    const HornVolumes horns = find_horns(dune_map(heap(bearing, {64, 64}, horned(2)), bearing, 40), 0.5);
    EXPECT_NEAR(horns.left / horns.right, 2, 0.25) << bearing;
    EXPECT_NEAR(horns.left_length, 15, 2) << bearing;
    EXPECT_NEAR(horns.right_length, 15, 2) << bearing;
  }
  const DuneMap round = dune_map(heap(270, {64, 64}, cone_at), 270, 40);
  const HornVolumes none = find_horns(round, 0.5);
  EXPECT_LT(none.left + none.right, 0.001 * round.volume()) << "a cone has no horns";
}

TEST(DuneMap, MeanMapsAreMeansOfTheirPoints) {
  const DuneMap one = dune_map(heap(270, {64, 64}, cone_at), 270, 30);
  DuneMap twice = one;
  for (double& height : twice.height.cells()) height *= 3;
  const std::vector<DuneMap> both{one, twice};
  EXPECT_NEAR(analysis::mean_map(both).volume(), 2 * one.volume(), 1e-9);
  EXPECT_NEAR(mismatch(one, twice), 0.5, 1e-9);
}

}  // namespace
}  // namespace erg
