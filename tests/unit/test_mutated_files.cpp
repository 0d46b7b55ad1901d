// Files gone wrong at random: each is refused with an InputError, or read as something that can be worked with. Run
// with sanitizers they are also looked at for what does no visible harm.
#include <gtest/gtest.h>
#include <zlib.h>

#include "io/checkpoint/checkpoint.h"
#include "io/config/config_file.h"
#include "io/formats/camera_file.h"
#include "io/formats/heightmap.h"
#include "io/formats/png.h"
#include "io/formats/png_reader.h"
#include "message.h"
#include "mutated.h"
#include "png_bytes.h"
#include "sim/simulation.h"
#include "temporary_folder.h"

namespace erg {

using io::camera_text;
using io::parse_camera;
using io::parse_config;
using io::read_height_picture;
using sim::Config;
using sim::Simulation;

namespace {

std::string with_checksum(std::string bytes) {
  if (bytes.size() < 4) return bytes;
  const auto* const data = reinterpret_cast<const Bytef*>(bytes.data());
  const auto crc = static_cast<std::uint32_t>(crc32(crc32(0, nullptr, 0), data, static_cast<uInt>(bytes.size() - 4)));
  std::memcpy(bytes.data() + bytes.size() - 4, &crc, 4);
  return bytes;
}

/// A run of a model after two steps on few cells.
std::string checkpoint_of(const std::string& model, const std::filesystem::path& path) {
  Config config(model);
  config.grid.set("nx", std::int64_t{12});
  config.grid.set("ny", std::int64_t{7});
  config.grid.set("boundary", std::string("open"));
  config.grid.set("inflow", 0.5);
  config.scene.set("kind", std::string("random"));
  config.run.set("executor", std::string("serial"));
  config.run.set("threads", std::int64_t{1});
  Simulation simulation(config);
  simulation.step();
  simulation.step();
  io::write_checkpoint(path, config, simulation.state());
  return read_bytes(path);
}

/// Goes on from a checkpoint if it is accepted.
void go_on(const std::filesystem::path& path) {
  io::Saved saved = io::read_checkpoint(path);
  Simulation simulation(saved.config, std::move(saved.state));
  simulation.step();
  const Terrain& terrain = simulation.terrain();
  EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
  for (const std::int32_t slabs : terrain.mobile().cells()) ASSERT_GE(slabs, 0);
}

// The checksum is right: what it does not find is to be found.
TEST(MutatedFiles, ACheckpointIsRefusedOrGoneOnFrom) {
  const TemporaryFolder folder;
  for (const models::ModelType& type : models::catalogue()) {
    const std::string bytes = checkpoint_of(type.info.key, folder / "a.erg");
    ASSERT_EQ(message([&] { go_on(folder / "a.erg"); }), "no error");
    test::Mutator mutator(1);
    for (int number = 0; number < test::mutations(60); ++number) {
      SCOPED_TRACE(type.info.key + ", mutation " + std::to_string(number));
      write_bytes(folder / "b.erg", with_checksum(mutator.of(bytes)));
      message([&] { go_on(folder / "b.erg"); });
    }
  }
}

TEST(MutatedFiles, AConfigIsRefusedOrReadAsItIsWritten) {
  test::Mutator mutator(2);
  for (const char* preset : {"star.json", "nebkhas.json", "storm_then_gale.json"}) {
    const std::string text = read_bytes(std::filesystem::path(ERG_SOURCE_DIR) / "cfg" / preset);
    ASSERT_FALSE(text.empty());
    for (int number = 0; number < test::mutations(200); ++number) {
      SCOPED_TRACE(std::string(preset) + ", mutation " + std::to_string(number));
      const std::string mutated = mutator.of(text);
      message([&] {
        const Config config = parse_config(mutated, "a.json");
        EXPECT_EQ(parse_config(io::config_text(config), "b.json"), config);
      });
    }
  }
}

TEST(MutatedFiles, ACameraIsRefusedOrReadAsItIsWritten) {
  test::Mutator mutator(3);
  const std::string text = camera_text({.target = {1.5, -3, 40}, .bearing = 30, .distance = 77, .orthographic = true});
  for (int number = 0; number < test::mutations(200); ++number) {
    SCOPED_TRACE("mutation " + std::to_string(number));
    const std::string mutated = mutator.of(text);
    message([&] {
      const picture::Camera camera = parse_camera(mutated, "a.json");
      EXPECT_EQ(parse_camera(camera_text(camera), "b.json"), camera);
    });
  }
}

// A checksum finds nearly all mutations: with right ones over them the decoder meets what is wrong itself.
TEST(MutatedFiles, APictureIsRefusedOrHasGreysFromBlackToWhite) {
  const TemporaryFolder folder;
  io::write_heightmap(folder / "16.png", Terrain({23, 17}, 1, 1), {"{}", 1, 2, "werner", "1.0", "cpu"});
  io::write_png(folder / "8.png", picture::RgbImage(23, 17, {0.3f, 0.3f, 0.3f}), {});
  test::PngBytes interlaced{
      .width = 5, .height = 4, .kind = test::grey_opacity, .samples = std::vector<int>(40, 65535)};
  interlaced.interlaced = true;
  write_bytes(folder / "i.png", interlaced.made());
  test::Mutator mutator(4);
  for (const char* name : {"16.png", "8.png", "i.png"}) {
    const std::string bytes = read_bytes(folder / name);
    ASSERT_EQ(message([&] { read_height_picture(folder / name); }), "no error") << name;
    for (int number = 0; number < test::mutations(150); ++number) {
      SCOPED_TRACE(std::string(name) + ", mutation " + std::to_string(number));
      const std::string mutated = mutator.of(bytes);
      write_bytes(folder / "mutated.png", number % 3 == 0 ? mutated : test::with_right_checksums(mutated));
      message([&] {
        const sim::HeightPicture picture =
            read_height_picture(folder / "mutated.png", {.grid = {6, 5}, .no_data = sim::NoDataRule::around});
        for (const float grey : picture.cells()) ASSERT_TRUE(grey >= 0 && grey <= 1) << grey;
      });
      message([&] { io::read_png_metadata(folder / "mutated.png"); });
    }
  }
}

}  // namespace
}  // namespace erg
