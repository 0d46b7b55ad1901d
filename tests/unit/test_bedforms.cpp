// What tells waves from sastrugi and barchans from parabolic dunes, on surfaces whose answer is known.
#include "analysis/bedforms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/dune_patches.h"

namespace erg {
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
  EXPECT_NEAR(measure_bedforms(saw(8, true), 0).across, 0, 1e-9) << "the wind turns, not the land";
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

/// A crescent around (20, 20) whose sides are drawn out by `pull` cells along the wind.
void put_crescent(Grid<std::int32_t>& mobile, int pull) {
  for (int across = -8; across <= 8; ++across) {
    const int shift = pull * across * across / 64;
    for (int along = -3; along <= 3; ++along) {
      mobile(wrap(20 + along + shift, mobile.nx()), wrap(20 + across, mobile.ny())) = 9;
    }
  }
}

TEST(DunePatches, ArmsPointUpwindOfTheMiddleOrDownwind) {
  for (const int pull : {-12, 0, 12}) {
    Terrain terrain({64, 64}, 1, 1);
    put_crescent(terrain.edit_mobile(), pull);
    const std::vector<DunePatch> dunes = find_dunes(terrain, west, 5, 1);
    ASSERT_EQ(dunes.size(), 1u);
    EXPECT_EQ(dunes[0].cells, 7 * 17);
    if (pull == 0) {
      EXPECT_NEAR(dunes[0].arms, 0, 1e-9);
      EXPECT_NEAR(dunes[0].length / dunes[0].width, std::sqrt(48.0 / 288), 1e-6) << "a rectangle of 7 by 17";
    } else {
      EXPECT_GT(dunes[0].arms * pull, 0);
      EXPECT_LT(find_dunes(terrain, 90, 5, 1)[0].arms * pull, 0) << "the other wind";
      EXPECT_NEAR(find_dunes(terrain, 0, 5, 1)[0].arms, 0, 1e-9) << "symmetric about the x axis";
    }
  }
}

TEST(DunePatches, AreWholeAcrossTheEdgeAndApartWhenTheyDoNotTouch) {
  Terrain terrain({32, 32}, 1, 1);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (const int x : {30, 31, 0, 1}) mobile(x, 31) = mobile(x, 0) = 9;  // 4 by 2 over a corner
  mobile(2, 1) = 9;                                                     // touches it at a corner only
  for (int x = 0; x < 32; ++x) mobile(x, 16) = 9;                       // around the torus: no ends
  const std::vector<DunePatch> dunes = find_dunes(terrain, west, 9, 2);
  ASSERT_EQ(dunes.size(), 1u);
  EXPECT_EQ(dunes[0].cells, 8);
  EXPECT_NEAR(dunes[0].length / dunes[0].width, std::sqrt(15.0 / 3), 1e-6);
  EXPECT_EQ(find_dunes(terrain, west, 9, 1).size(), 2u);
  EXPECT_TRUE(find_dunes(terrain, west, 10, 1).empty());
  EXPECT_EQ(mean_of_dunes({}).dunes, 0);
}

}  // namespace
}  // namespace erg
