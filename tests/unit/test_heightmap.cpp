#include "io/formats/heightmap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/errors.h"
#include "io/formats/png.h"
#include "io/formats/png_reader.h"
#include "temporary_folder.h"

namespace erg {

using io::MetadataEntries;
using io::read_height_picture;
using io::read_png_metadata;
using io::write_heightmap;
using sim::HeightPicture;

namespace {

std::string entry(const MetadataEntries& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& one) { return one.first == name; });
  return found == entries.end() ? "(absent)" : found->second;
}

Terrain slope() {
  Terrain terrain({5, 3}, 2.0, 0.5);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      terrain.edit_bedrock()(x, y) = -4 + 10 * y;
      terrain.edit_mobile()(x, y) = x;
    }
  }
  return terrain;
}

TEST(Heightmap, ComesBackInMetresWithSouthInRowZero) {
  const TemporaryFolder folder;
  const Terrain terrain = slope();
  write_heightmap(folder / "h.png", terrain, {"{\n  \"title\": \"Düne\"\n}", 7, 12, "werner", "1.0", "cpu"});
  const MetadataEntries entries = read_png_metadata(folder / "h.png");
  const double low = std::stod(entry(entries, "erg:low_m"));
  const double high = std::stod(entry(entries, "erg:high_m"));
  EXPECT_DOUBLE_EQ(low, -2);
  EXPECT_DOUBLE_EQ(high, 10);
  EXPECT_EQ(entry(entries, "erg:cell_m"), "2");
  EXPECT_EQ(entry(entries, "erg:config"), "{\n  \"title\": \"Düne\"\n}");
  EXPECT_EQ(entry(entries, "erg:seed"), "7");
  EXPECT_EQ(entry(entries, "erg:step"), "12");
  const HeightPicture picture = read_height_picture(folder / "h.png");
  ASSERT_EQ(picture.extent(), terrain.extent());
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_NEAR(low + (high - low) * picture(x, y), terrain.metres(terrain.height(x, y)), 12.0 / 65535);
    }
  }
}

TEST(Heightmap, AFlatSurfaceIsBlack) {
  const TemporaryFolder folder;
  write_heightmap(folder / "h.png", Terrain({4, 4}, 1, 1), {});
  const HeightPicture picture = read_height_picture(folder / "h.png");
  for (const float value : picture.cells()) EXPECT_EQ(value, 0);
}

TEST(Heightmap, EightBitColourPicturesAreReadAsGrey) {
  const TemporaryFolder folder;
  picture::RgbImage image(3, 2, {1, 1, 1});
  image.set(0, 1, {0, 0, 0});  // lower left: south-west
  image.set(1, 0, {0.2f, 0.2f, 0.2f});
  io::write_png(folder / "c.png", image, {});
  const HeightPicture picture = read_height_picture(folder / "c.png");
  EXPECT_EQ(picture(0, 0), 0);
  EXPECT_NEAR(picture(1, 1), 0.2, 1e-3);
  EXPECT_NEAR(picture(2, 0), 1, 1e-3);
}

TEST(Heightmap, MissingForeignAndDamagedFilesAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_height_picture(folder / "absent.png"), InputError);
  EXPECT_THROW(read_height_picture(folder.path()), InputError);
  write_bytes(folder / "text.png", "this is no picture");
  EXPECT_THROW(read_height_picture(folder / "text.png"), InputError);
  EXPECT_THROW(read_png_metadata(folder / "text.png"), InputError);
  write_heightmap(folder / "h.png", slope(), {});
  const std::string bytes = read_bytes(folder / "h.png");
  const std::size_t pixels = bytes.find("IDAT");
  ASSERT_NE(pixels, std::string::npos);
  write_bytes(folder / "cut.png", bytes.substr(0, pixels + 8));
  EXPECT_THROW(read_height_picture(folder / "cut.png"), InputError);
}

}  // namespace
}  // namespace erg
