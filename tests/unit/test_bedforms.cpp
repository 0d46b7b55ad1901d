// What tells waves from sastrugi, on surfaces whose answer is known.
#include "analysis/bedforms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace erg {

using analysis::bedform_name;
using analysis::BedformShape;
using analysis::measure_bedforms;

namespace {

constexpr double west = 270;

/// A saw of 16 cells along x: rises over `rise` cells, falls over the others, so that a west wind meets the rise first.
Terrain saw(int rise, bool turned) {
  Terrain terrain({64, 64}, 1, 0.01);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const int at = (turned ? y : x) % 16;
      mobile(x, y) =
          static_cast<std::int32_t>(std::lround(at < rise ? 160.0 * at / rise : 160.0 * (16 - at) / (16 - rise)));
    }
  }
  return terrain;
}

TEST(Bedforms, RidgesAcrossTheWindAreZeroAndAlongItOne) {
  EXPECT_NEAR(measure_bedforms(saw(8, false), west).across, 0, 1e-9);
  EXPECT_NEAR(measure_bedforms(saw(8, true), west).across, 1, 1e-9);
  EXPECT_NEAR(measure_bedforms(saw(8, true), 0).across, 0, 1e-9) << "the wind turns, not the terrain";
  EXPECT_NEAR(measure_bedforms(saw(8, false), 225).across, 0.5, 1e-9);
}

TEST(Bedforms, SkewSaysWhichFaceIsSteeper) {
  EXPECT_NEAR(measure_bedforms(saw(8, false), west).skew, 0, 1e-6);
  EXPECT_GT(measure_bedforms(saw(3, false), west).skew, 0.5) << "steep toward the wind";
  EXPECT_LT(measure_bedforms(saw(13, false), west).skew, -0.5) << "slip faces";
  EXPECT_LT(measure_bedforms(saw(3, false), 90).skew, -0.5) << "the other wind sees the other face";
}

TEST(Bedforms, ReliefIsInMetres) {
  Terrain terrain({64, 64}, 1, 0.01);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) terrain.edit_mobile()(x, y) = x < 32 ? 100 : 0;
  }
  // Means of three cells make two of the cells at either edge a third and two thirds high.
  EXPECT_NEAR(measure_bedforms(terrain, west).relief, std::sqrt((60 * 0.25 + 4.0 / 36) / 64), 1e-9);
}

TEST(Bedforms, CrustIsWhereAllSnowHasBonded) {
  Terrain terrain({4, 1}, 1, 0.01);
  EXPECT_EQ(measure_bedforms(terrain, west).crust, 0) << "no field, no crust";
  terrain.edit_mobile()(0, 0) = 5;  // bonded to the top
  terrain.edit_mobile()(1, 0) = 5;  // a loose slab on it
  Field bonded;
  bonded.info.key = "bonded";
  bonded.values = Grid<float>(terrain.extent());
  bonded.values(0, 0) = 5;
  bonded.values(1, 0) = 4;
  terrain.edit_fields().push_back(bonded);
  EXPECT_EQ(measure_bedforms(terrain, west).crust, 0.25);
}

TEST(Bedforms, SastrugiHaveToBeCarved) {
  const BedformShape sastrugi{.across = 0.6, .skew = 1, .relief = 0.04, .crust = 0.3};
  EXPECT_EQ(bedform_name(sastrugi), "sastrugi");
  const auto named = [&](auto change) {
    BedformShape shape = sastrugi;
    change(shape);
    return bedform_name(shape);
  };
  EXPECT_EQ(named([](BedformShape& shape) { shape.crust = 0.02; }), "streaks") << "drift on fresh snow";
  EXPECT_EQ(named([](BedformShape& shape) { shape.skew = 0.2; }), "streaks") << "no steeper face";
  EXPECT_EQ(named([](BedformShape& shape) { shape.relief = 0.01; }), "streaks") << "a centimetre";
  EXPECT_EQ(named([](BedformShape& shape) { shape.across = 0.5; }), "rough");
  EXPECT_EQ(named([](BedformShape& shape) { shape.across = 0.2; }), "waves");
  EXPECT_EQ(named([](BedformShape& shape) { shape.relief = 0.001; }), "flat");
}

}  // namespace
}  // namespace erg
