// Pictures as ground: what they say of heights is taken, what is no height is refused or filled by a rule, and told.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/formats/heightmap.h"
#include "limits.h"
#include "message.h"
#include "png_bytes.h"
#include "sim/memory.h"
#include "temporary_folder.h"

namespace erg {

using io::config_text;
using io::HeightPictureOptions;
using io::parse_config;
using io::read_height_picture;
using io::start_simulation;
using sim::Config;
using sim::HeightPicture;
using sim::HeightRange;
using sim::memory_of_run;
using sim::NoDataRule;
using sim::PictureFit;
using sim::Simulation;

namespace {

using test::PngBytes;
using Notes = std::vector<std::string>;

/// Reads a picture made by hand.
class HeightPictures : public ::testing::Test {
 protected:
  std::filesystem::path put(const PngBytes& png) const {
    write_bytes(folder_ / "p.png", png.made());
    return folder_ / "p.png";
  }
  HeightPicture read(const PngBytes& png, const HeightPictureOptions& options = {}, Notes* notes = nullptr) const {
    return read_height_picture(put(png), options, notes);
  }
  std::string refusal(const PngBytes& png, const HeightPictureOptions& options = {}) const {
    return message([&] { read(png, options); });
  }

  TemporaryFolder folder_;
};

std::vector<float> values_of(const HeightPicture& picture) { return {picture.cells().begin(), picture.cells().end()}; }

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

::testing::AssertionResult tells(const Notes& notes, const std::string& part) {
  for (const std::string& note : notes) {
    if (holds(note, part)) return ::testing::AssertionSuccess() << note;
  }
  return ::testing::AssertionFailure() << notes.size() << " notes, none with \"" << part << '"';
}

/// One row of four greys from black to white in every way that a PNG may keep them.
TEST_F(HeightPictures, GreysAreReadHoweverTheyAreKept) {
  const std::vector<float> greys{0, 1.0f / 3, 2.0f / 3, 1};
  const std::string four_greys = std::string("\0\0\0\x55\x55\x55\xaa\xaa\xaa\xff\xff\xff", 12);
  const std::vector<PngBytes> ways{
      {.width = 4, .bits = 16, .samples = {0, 21845, 43690, 65535}},
      {.width = 4, .bits = 8, .samples = {0, 85, 170, 255}},
      {.width = 4, .bits = 4, .samples = {0, 5, 10, 15}},
      {.width = 4, .bits = 2, .samples = {0, 1, 2, 3}},
      {.width = 4, .bits = 8, .kind = test::colour, .samples = {0, 0, 0, 85, 85, 85, 170, 170, 170, 255, 255, 255}},
      {.width = 4,
       .bits = 16,
       .kind = test::grey_opacity,
       .samples = {0, 65535, 21845, 65535, 43690, 65535, 65535, 65535}},
      {.width = 4,
       .bits = 2,
       .kind = test::palette,
       .samples = {0, 1, 2, 3},
       .before = test::png_chunk("PLTE", four_greys)},
      {.width = 4, .bits = 16, .samples = {0, 21845, 43690, 65535}, .interlaced = true}};
  for (std::size_t way = 0; way < ways.size(); ++way) {
    EXPECT_EQ(values_of(read(ways[way])), greys) << way;
  }
}

TEST_F(HeightPictures, InterlacedOrNotTheyAreTheSame) {
  PngBytes png{.width = 13, .height = 11, .bits = 8, .samples = {}};
  for (int pixel = 0; pixel < 13 * 11; ++pixel) png.samples.push_back(pixel * 37 % 256);
  const HeightPicture plain = read(png);
  png.interlaced = true;
  const HeightPicture interlaced = read(png);
  EXPECT_EQ(values_of(interlaced), values_of(plain));
  EXPECT_EQ(plain(0, 10), 0) << "north up";
  EXPECT_EQ(plain(1, 10), 37.0f / 255);
}

TEST_F(HeightPictures, ColoursAreNoHeights) {
  const std::string palette = std::string("\x10\x10\x10\x80\x40\x20", 6);
  const PngBytes by_palette{
      .width = 2, .bits = 1, .kind = test::palette, .samples = {0, 1}, .before = test::png_chunk("PLTE", palette)};
  EXPECT_TRUE(holds(refusal(by_palette), "has colours (a palette), the first in column 2, row 1"))
      << refusal(by_palette);
  // Elevations coded in colours: hardly another colour, and quite another height.
  const PngBytes coded{.width = 1, .bits = 8, .kind = test::colour, .samples = {128, 129, 128}};
  EXPECT_TRUE(holds(refusal(coded), "has colours, the first in column 1, row 1")) << refusal(coded);
  EXPECT_TRUE(holds(refusal(coded), "gdal_translate")) << refusal(coded);
  const PngBytes seen_through{.width = 1, .bits = 16, .kind = test::colour_opacity, .samples = {1, 2, 3, 65535}};
  EXPECT_TRUE(holds(refusal(seen_through), "has colours")) << refusal(seen_through);
  // The same palette is good where only its grey is used.
  PngBytes only_grey = by_palette;
  only_grey.samples = {0, 0};
  EXPECT_EQ(refusal(only_grey), "no error");
}

/// 4 x 4 heights 0.5, of which two in the north-west corner have no data, in each way that a PNG has to say so.
std::vector<PngBytes> pictures_with_holes() {
  PngBytes by_value{.width = 4, .height = 4, .samples = std::vector<int>(16, 32768)};
  by_value.samples[0] = by_value.samples[1] = 7;
  by_value.samples[15] = 65535;
  by_value.before = test::png_chunk("tRNS", std::string("\0\x07", 2));
  PngBytes by_opacity{.width = 4, .height = 4, .kind = test::grey_opacity, .samples = {}};
  for (int pixel = 0; pixel < 16; ++pixel) {
    by_opacity.samples.push_back(pixel < 2 ? 7 : pixel == 15 ? 65535 : 32768);
    by_opacity.samples.push_back(pixel == 0   ? 0
                                 : pixel == 1 ? 40000
                                              : 65535);  // half transparent is not measured either
  }
  PngBytes by_palette{.width = 4, .height = 4, .bits = 8, .kind = test::palette, .samples = std::vector<int>(16, 1)};
  by_palette.samples[0] = by_palette.samples[1] = 0;
  by_palette.samples[15] = 2;
  by_palette.before = test::png_chunk("PLTE", std::string("\xff\x00\x00\x80\x80\x80\xff\xff\xff", 9)) +
                      test::png_chunk("tRNS", std::string("\0", 1));
  return {by_value, by_opacity, by_palette};
}

TEST_F(HeightPictures, WhereNothingWasMeasuredIsNoGroundButByARule) {
  for (const PngBytes& png : pictures_with_holes()) {
    EXPECT_TRUE(holds(refusal(png), "transparent pixels, the first in column 1, row 1")) << refusal(png);
    EXPECT_TRUE(holds(refusal(png), "image_nodata")) << refusal(png);
    Notes notes;
    const HeightPicture lowest = read(png, {.no_data = NoDataRule::lowest}, &notes);
    EXPECT_NEAR(lowest(0, 3), 0.5, 0.01) << "the lowest of those that were measured, not that of the mark";
    EXPECT_TRUE(tells(notes, "12% of the cells have no data"));
  }
  PngBytes whole{.width = 2, .kind = test::grey_opacity, .samples = {1, 65535, 2, 65535}};
  EXPECT_EQ(refusal(whole), "no error") << "opacity alone leaves nothing out";
}

TEST_F(HeightPictures, HeightsAreCarriedOnIntoHoles) {
  PngBytes png{
      .width = 5, .height = 1, .kind = test::grey_opacity, .samples = {0, 65535, 0, 0, 0, 0, 0, 0, 65535, 65535}};
  const HeightPicture picture = read(png, {.no_data = NoDataRule::around});
  EXPECT_EQ(values_of(picture), (std::vector<float>{0, 0, 0.5f, 1, 1}));
  png.samples = std::vector<int>(10, 0);
  EXPECT_TRUE(holds(refusal(png, {.no_data = NoDataRule::around}), "no pixel of the picture has data"));
}

TEST_F(HeightPictures, HolesDoNotPullDownWhatIsAveragedBesideThem) {
  PngBytes png{
      .width = 4, .height = 1, .kind = test::grey_opacity, .samples = {0, 0, 65535, 65535, 65535, 65535, 65535, 65535}};
  const HeightPicture picture = read(png, {.grid = {2, 1}, .no_data = NoDataRule::lowest});
  EXPECT_EQ(values_of(picture), (std::vector<float>{1, 1}));
}

TEST_F(HeightPictures, EveryChecksumIsLookedAt) {
  const PngBytes sound{.width = 3, .height = 2, .samples = {1, 2, 3, 4, 5, 6}};
  ASSERT_EQ(refusal(sound), "no error");
  std::vector<PngBytes> damaged(4, sound);
  damaged[0].header_damage = 1;
  damaged[1].pixels_damage = 0x80000000;
  damaged[2].stream_damage = true;
  damaged[3].before = test::png_chunk("tEXt", std::string("erg:low_m") + '\0' + "3", 1);
  for (std::size_t fault = 0; fault < damaged.size(); ++fault) {
    EXPECT_TRUE(holds(refusal(damaged[fault]), "the picture is damaged (")) << fault << ": " << refusal(damaged[fault]);
  }
  const std::string bytes = sound.made();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    write_bytes(folder_ / "cut.png", bytes.substr(0, length));
    EXPECT_NE(message([&] { read_height_picture(folder_ / "cut.png"); }), "no error") << length << " bytes";
  }
}

TEST_F(HeightPictures, ChunksThatMatterToNoHeightAreLeftAlone) {
  PngBytes png{.width = 2, .samples = {0, 65535}};
  png.before = test::png_chunk("gAMA", std::string("\0\0\0\0", 4)) + test::png_chunk("iCCP", "broken") +
               test::png_chunk("sRGB", "\x09") + test::png_chunk("zzZz", "unknown");
  EXPECT_EQ(values_of(read(png)), (std::vector<float>{0, 1}));
}

TEST_F(HeightPictures, HugeSidesAreRefusedBeforeTheyAreRead) {
  for (const int side : {65537, 1 << 30, 0x7fffffff}) {
    const PngBytes png{.samples = {0}};
    std::string bytes = png.made();
    bytes.replace(16, 4, test::big_endian(static_cast<std::uint32_t>(side)));
    write_bytes(folder_ / "huge.png", test::with_right_checksums(bytes));
    const std::string said = message([&] { read_height_picture(folder_ / "huge.png"); });
    EXPECT_TRUE(holds(said, "the picture has " + std::to_string(side) + " x 1 pixels; give one of at most 65536"))
        << said;
  }
}

TEST_F(HeightPictures, AnotherShapeIsToldAndStretchedOrCropped) {
  // A white square of 2 x 2 in the middle of 8 x 4.
  PngBytes png{.width = 8, .height = 4, .bits = 8, .samples = std::vector<int>(32, 0)};
  for (const int y : {1, 2}) {
    for (const int x : {3, 4}) png.samples[static_cast<std::size_t>(8 * y + x)] = 255;
  }
  Notes notes;
  const HeightPicture stretched = read(png, {.grid = {8, 8}}, &notes);
  EXPECT_TRUE(tells(notes, "has 8 x 4 pixels and the grid 8 x 8 cells: it is stretched"));
  notes.clear();
  const HeightPicture cropped = read(png, {.grid = {4, 4}, .fit = PictureFit::crop}, &notes);
  EXPECT_TRUE(tells(notes, "its middle is taken"));
  const auto white = [](const HeightPicture& picture) { return std::ranges::count(picture.cells(), 1.0f); };
  EXPECT_EQ(white(cropped), 4) << "pixel for cell";
  EXPECT_EQ(cropped(1, 1), 1);
  EXPECT_EQ(cropped(2, 2), 1);
  EXPECT_EQ(stretched(3, 4), 1) << "as wide as before";
  EXPECT_GT(stretched(3, 5), 0.7) << "and twice as high";
  notes.clear();
  read(png, {.grid = {80, 40}}, &notes);
  read(png, {.grid = {3, 2}, .fit = PictureFit::crop}, nullptr);
  EXPECT_TRUE(notes.empty()) << "the same shape is no news: " << notes.front();
}

TEST_F(HeightPictures, LargePicturesAreNotHeldWhole) {
  PngBytes png{
      .width = 4000, .height = 1000, .kind = test::grey_opacity, .samples = std::vector<int>(8'000'000, 65535)};
  const auto plain = put(png);
  png.interlaced = true;
  write_bytes(folder_ / "interlaced.png", png.made());
  png.samples = {};
  png.samples.shrink_to_fit();
  const test::LimitRestored restored(RLIMIT_AS);
  test::limit_memory(12 << 20);  // 16 MB of pixels
  EXPECT_FLOAT_EQ(read_height_picture(plain, {.grid = {64, 16}})(63, 3), 1);
  const std::string said = message([&] { read_height_picture(folder_ / "interlaced.png", {.grid = {64, 16}}); });
  EXPECT_TRUE(holds(said, "interlaced and has to be held whole: that needs 15 MiB of memory")) << said;
}

/// A config of an image scene over a picture in a folder.
class GroundFromPicture : public HeightPictures {
 protected:
  Config config_of(const std::filesystem::path& picture, int nx, int ny) const {
    Config config("werner");
    config.grid.set("nx", std::int64_t{nx});
    config.grid.set("ny", std::int64_t{ny});
    config.scene.set("kind", std::string("image"));
    config.scene.set("image", picture.string());
    config.scene.set("image_role", std::string("both"));
    return config;
  }
  /// Heights of -4 to 26.5 m in steps of half a metre, on cells of 2 m, written as Erg does.
  std::filesystem::path own_heightmap() const {
    Terrain terrain({5, 4}, 2.0, 0.5);
    for (int cell = 0; cell < 20; ++cell) terrain.edit_bedrock()[static_cast<std::size_t>(cell)] = cell * 61 % 62 - 8;
    io::write_heightmap(folder_ / "own.png", terrain, {});
    return folder_ / "own.png";
  }
  static HeightRange surface(Simulation simulation) {
    const Terrain& terrain = simulation.terrain();
    HeightRange range{1e9, -1e9};
    for (int y = 0; y < terrain.ny(); ++y) {
      for (int x = 0; x < terrain.nx(); ++x) {
        range.low = std::min(range.low, terrain.metres(terrain.height(x, y)));
        range.high = std::max(range.high, terrain.metres(terrain.height(x, y)));
      }
    }
    return range;
  }
};

TEST_F(GroundFromPicture, HeightsInErgsOwnPicturesComeBack) {
  const auto picture = own_heightmap();
  ASSERT_TRUE(read_height_picture(picture).metres.has_value());
  Config config = config_of(picture, 5, 4);
  config.parameters.set("slab_height", 0.5);
  Notes notes;
  Simulation simulation = start_simulation(config, &notes);
  EXPECT_TRUE(tells(notes, "heights in the picture, "));
  for (int cell = 0; cell < 20; ++cell) {
    EXPECT_EQ(simulation.terrain().height(cell % 5, cell / 5), cell * 61 % 62 - 8) << cell;
  }
  EXPECT_EQ(read_height_picture(picture).metres->low, surface(std::move(simulation)).low);
}

TEST_F(GroundFromPicture, HeightsThatAConfigGivesHoldAndSoDoDefaultsThatItGives) {
  Config config = config_of(own_heightmap(), 5, 4);
  config.parameters.set("slab_height", 0.5);
  config.scene.set("image_low", 0.0);  // the default
  Notes notes;
  const HeightRange range = surface(start_simulation(config, &notes));
  EXPECT_EQ(range.low, 0);
  EXPECT_EQ(range.high, 10);
  EXPECT_TRUE(tells(notes, "give way to image_low and image_high, 0 to 10 m"));
  // Written and read again it is the same terrain.
  const Config again = parse_config(config_text(config), "again.json");
  EXPECT_EQ(surface(start_simulation(again)).high, 10);
  config.scene.reset("image_low");
  const Config without = parse_config(config_text(config), "without.json");
  EXPECT_LT(surface(start_simulation(without)).low, 0);
}

TEST_F(GroundFromPicture, SandBelowZeroIsTold) {
  Config config = config_of(put({.width = 2, .samples = {0, 65535}}), 2, 1);
  config.scene.set("image_low", -3.0);
  for (const char* role : {"bedrock", "sand", "both"}) {
    config.scene.set("image_role", std::string(role));
    Notes notes;
    start_simulation(config, &notes);
    EXPECT_EQ(static_cast<bool>(tells(notes, "no sand lies where its height is below 0 m")),
              role == std::string("sand"));
  }
}

TEST_F(GroundFromPicture, TheGridIsTakenFromThePictureWhereThatIsAskedFor) {
  Config config = config_of(own_heightmap(), 64, 64);
  config.scene.set("image_fit", std::string("from_file"));
  Simulation simulation = start_simulation(config);
  EXPECT_EQ(simulation.terrain().extent(), (Extent{5, 4}));
  EXPECT_EQ(simulation.terrain().cell_size(), 2.0);
  EXPECT_EQ(simulation.config().grid.integer("nx"), 5) << "what is written of the run says so";
  // A picture that says no cell size leaves the config's.
  config.scene.set("image", put({.width = 3, .height = 2, .samples = {0, 1, 2, 3, 4, 5}}).string());
  EXPECT_EQ(start_simulation(config).terrain().extent(), (Extent{3, 2}));
  EXPECT_EQ(start_simulation(config).terrain().cell_size(), config.grid.real("cell_size"));
  config.scene.set("image", put({.width = 20000, .height = 1, .samples = std::vector<int>(20000)}).string());
  EXPECT_TRUE(holds(message([&] { start_simulation(config); }), "20000 x 1 pixels, and a grid at most 16384"));
}

TEST_F(GroundFromPicture, TheSceneSaysWhatLiesWhereNothingWasMeasured) {
  for (const PngBytes& png : pictures_with_holes()) {
    Config config = config_of(put(png), 4, 4);
    EXPECT_TRUE(holds(message([&] { start_simulation(config); }), "image_nodata"));
    for (const char* rule : {"lowest", "around"}) {
      config.scene.set("image_nodata", std::string(rule));
      EXPECT_NEAR(surface(start_simulation(config)).low, 5, 0.2) << rule;
    }
  }
}

TEST_F(GroundFromPicture, DeepSeasAndHighVolcanoesAreHeights) {
  for (const auto& [low, high] : {std::pair{-10977.0, 8685.0}, std::pair{-8200.0, 21229.0}}) {
    Config config = config_of(put({.width = 2, .samples = {0, 65535}}), 2, 1);
    config.parameters.set("slab_height", 10.0);
    config.grid.set("cell_size", 1000.0);
    config.scene.set("image_low", low);
    config.scene.set("image_high", high);
    const HeightRange range = surface(start_simulation(config));
    EXPECT_NEAR(range.low, low, 5);
    EXPECT_NEAR(range.high, high, 5);
  }
}

TEST_F(GroundFromPicture, CellsInDegreesAreTold) {
  Config config = config_of(put({.width = 2, .samples = {0, 65535}}), 2, 1);
  for (const double arc_seconds : {15.0, 30.0}) {
    config.grid.set("cell_size", arc_seconds / 3600);
    Notes notes;
    start_simulation(config, &notes);
    EXPECT_TRUE(tells(notes, "looks like " + std::to_string(static_cast<int>(arc_seconds)) + " arc seconds"));
  }
  for (const double metres : {0.05, 0.1, 0.25, 1.0, 30.0}) {
    config.grid.set("cell_size", metres);
    Notes notes;
    start_simulation(config, &notes);
    EXPECT_FALSE(tells(notes, "arc seconds")) << metres;
  }
}

TEST_F(GroundFromPicture, APictureCountsInTheMemoryOfARun) {
  Config flat("werner");
  Config config = config_of("p.png", 256, 256);
  EXPECT_GT(memory_of_run(config), memory_of_run(flat));
}

}  // namespace
}  // namespace erg
