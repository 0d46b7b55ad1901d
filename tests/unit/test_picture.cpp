#include "io/formats/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/errors.h"
#include "io/formats/legend.h"
#include "io/formats/png_reader.h"
#include "picture/annotations.h"
#include "picture/label.h"
#include "temporary_folder.h"

namespace erg {

using forcing::Forcing;
using io::draw_picture;
using io::legend_height;
using io::PictureOptions;
using io::write_png;
using picture::length_text;
using picture::RgbImage;
using picture::round_length;

namespace {

PictureOptions map_only(int pixels) {
  PictureOptions options;
  options.pixels = pixels;
  options.legend = false;
  return options;
}

double brightness(const RgbImage& image, int x, int y) {
  return (image.pixel(x, y)[0] + image.pixel(x, y)[1] + image.pixel(x, y)[2]) / 765.0;
}

// A ridge from south to north, gentle to the west, at the repose angle to the east.
Terrain ridge() {
  Terrain terrain({64, 64}, 1.0, 1.0 / 3);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const int rise = x >= 10 && x < 40 ? (x - 10) / 2 : x >= 40 ? std::max(0, 15 - 2 * (x - 40)) : 0;
      terrain.edit_mobile()(x, y) = 3 + rise;
    }
  }
  return terrain;
}

TEST(Picture, SmallGridsAreEnlargedAndLargeOnesAveraged) {
  EXPECT_EQ(draw_picture(Terrain({64, 32}, 1, 1), map_only(256)).width, 256);
  EXPECT_EQ(draw_picture(Terrain({64, 32}, 1, 1), map_only(256)).height, 128);
  EXPECT_EQ(draw_picture(Terrain({1000, 300}, 1, 1), map_only(200)).width, 200);
  EXPECT_EQ(draw_picture(Terrain({1000, 300}, 1, 1), map_only(200)).height, 60);
  EXPECT_EQ(draw_picture(Terrain({300, 200}, 1, 1), map_only(256)).width, 300);
}

TEST(Picture, EveryExtentCanBeDrawn) {
  for (const Extent extent : {Extent{1, 1}, Extent{1, 50}, Extent{70, 1}, Extent{3, 2}}) {
    for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
      PictureOptions options;
      options.pixels = 100;
      options.wind = Forcing{};
      const RgbImage image = draw_picture(Terrain(extent, 1, 1, boundary), options);
      EXPECT_GE(image.width, io::smallest_legend);
      EXPECT_GT(image.height, legend_height);
    }
  }
}

TEST(Picture, TheSlipFaceLiesInTheShade) {
  const RgbImage image = draw_picture(ridge(), map_only(256));
  const double stoss = brightness(image, 4 * 25, 128);
  const double slip = brightness(image, 4 * 43, 128);
  const double level = brightness(image, 4 * 58, 128);
  EXPECT_GT(stoss, level);
  EXPECT_LT(slip, 0.75 * level);
}

// A gentle slope rises by one slab every four cells; drawn as terraces its light would flicker by far more.
TEST(Picture, SlabsLeaveNoTerraces) {
  Terrain terrain({64, 16}, 1.0, 1.0 / 3, Boundary::open);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 64; ++x) terrain.edit_mobile()(x, y) = 5 + x / 2;
  }
  PictureOptions options = map_only(256);
  options.palette = "sand";
  const RgbImage image = draw_picture(terrain, options);
  for (int x = 64; x < 190; ++x) {
    EXPECT_LT(std::abs(brightness(image, x + 1, 32) - brightness(image, x, 32)), 0.012) << x;
  }
}

TEST(Picture, BareGroundIsDullerThanSandAndRockIsGrey) {
  Terrain terrain({48, 48}, 1.0, 1.0 / 3);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) {
      terrain.edit_mobile()(x, y) = x < 16 ? 5 : 0;
      terrain.edit_bedrock()(x, y) = x < 32 ? (x < 16 ? -5 : 0) : 12;
    }
  }
  const RgbImage image = draw_picture(terrain, map_only(48));
  const auto colourfulness = [&](int x) { return image.pixel(x, 24)[0] - image.pixel(x, 24)[2]; };
  EXPECT_GT(colourfulness(8), colourfulness(24) + 25);
  EXPECT_GT(colourfulness(24), colourfulness(42));
  EXPECT_LT(std::abs(colourfulness(42)), 16);
}

TEST(Picture, NorthIsUp) {
  Terrain terrain({32, 32}, 1.0, 1.0);
  for (int x = 0; x < 32; ++x) {
    for (int y = 20; y < 32; ++y) terrain.edit_mobile()(x, y) = 5;  // sand in the north
  }
  const RgbImage image = draw_picture(terrain, map_only(32));
  EXPECT_GT(image.pixel(16, 6)[0], image.pixel(16, 26)[0] + 30);
}

TEST(Picture, ADeclaredFieldIsLaidOver) {
  Terrain terrain({20, 20}, 1, 1);
  terrain.edit_mobile().fill(5);
  const Field grass{{"grass", "Grass", "", 0, 1, "vegetation", ""}, Grid<float>({20, 20}, 1.0f)};
  terrain.edit_fields().push_back(grass);
  PictureOptions options = map_only(20);
  options.field = "grass";
  const RgbImage image = draw_picture(terrain, options);
  EXPECT_GT(image.pixel(10, 10)[1], image.pixel(10, 10)[0]);
  options.field = "gras";
  EXPECT_THROW(draw_picture(terrain, options), InputError);
  options.field = "";
  options.palette = "sandd";
  EXPECT_THROW(draw_picture(terrain, options), InputError);
}

TEST(Legend, LengthsAreRound) {
  EXPECT_DOUBLE_EQ(round_length(73), 50);
  EXPECT_DOUBLE_EQ(round_length(50), 50);
  EXPECT_DOUBLE_EQ(round_length(49), 20);
  EXPECT_DOUBLE_EQ(round_length(0.19), 0.1);
  EXPECT_EQ(length_text(50), "50 m");
  EXPECT_EQ(length_text(2000), "2 km");
  EXPECT_EQ(length_text(0.2), "20 cm");
  EXPECT_EQ(length_text(0.005), "5 mm");
}

TEST(Legend, TheArrowPointsDownwind) {
  const auto ink_centre = [](double bearing) {
    PictureOptions with;
    with.pixels = 400;
    with.wind = Forcing{bearing, 5};
    RgbImage image(400, legend_height);
    io::draw_legend(image, 1.0, with);
    const int left =
        image.width - 14 - picture::label_width("wind " + std::to_string(static_cast<int>(bearing)) + "°", 17);
    double ink = 0, east = 0, north = 0;
    for (int y = 0; y < legend_height; ++y) {
      for (int x = left - 42; x < left - 6; ++x) {
        const double dark = 0.9 - brightness(image, x, y);
        if (dark <= 0) continue;
        ink += dark;
        east += dark * (x - (left - 24));
        north += dark * (legend_height - 16 - 6 - y);
      }
    }
    return std::pair{east / ink, north / ink};
  };
  EXPECT_GT(ink_centre(270).first, 1);  // the head is the heavier end
  EXPECT_NEAR(ink_centre(270).second, 0, 0.2);
  EXPECT_LT(ink_centre(90).first, -1);
  EXPECT_GT(ink_centre(180).second, 1);
  EXPECT_LT(ink_centre(0).second, -1);
}

TEST(Image, PngCarriesPixelsAndText) {
  const TemporaryFolder folder;
  RgbImage image(2, 1, {1, 0.5f, 0});
  write_png(folder / "a.png", image, {{"erg:config", "{\"ä\": 1}"}});
  EXPECT_TRUE(read_bytes(folder / "a.png").starts_with("\x89PNG"));
  EXPECT_EQ(io::read_png_metadata(folder / "a.png"), (io::MetadataEntries{{"erg:config", "{\"ä\": 1}"}}));
  EXPECT_THROW(write_png(folder / "none/a.png", image, {}), InputError);
}

TEST(Image, PastingCutsAtTheEdges) {
  RgbImage image(4, 4);
  image.paste(RgbImage(3, 3, {1, 1, 1}), -2, 3);
  EXPECT_EQ(image.pixel(0, 3)[0], 255);
  EXPECT_EQ(image.pixel(1, 3)[0], 0);
  EXPECT_EQ(image.pixel(0, 2)[0], 0);
  image.set(9, 9, {1, 1, 1});  // outside: nothing happens
}

}  // namespace
}  // namespace erg
