#include "sim/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace erg {

using sim::build_scene;
using sim::Config;
using sim::HeightPicture;

namespace {

constexpr double quantum = 1.0 / 3;

Config scene_config(const std::string& kind, int nx = 64, int ny = 48) {
  Config config;
  config.grid.set("nx", std::int64_t{nx});
  config.grid.set("ny", std::int64_t{ny});
  config.scene.set("kind", kind);
  return config;
}

double mean_mobile(const Terrain& terrain) {
  return static_cast<double>(terrain.total_mobile()) / static_cast<double>(terrain.extent().cells());
}

const std::vector<std::string>& all_kinds() {
  static const Parameters declared = sim::scene_parameters();
  return declared.front().choices;
}

TEST(Scene, EveryKindIsWholeAtEveryExtent) {
  const HeightPicture picture({3, 2}, 0.5f);
  for (const std::string& kind : all_kinds()) {
    for (const Extent extent : {Extent{1, 1}, Extent{1, 40}, Extent{40, 1}, Extent{33, 20}}) {
      const Terrain terrain = build_scene(scene_config(kind, extent.nx, extent.ny), quantum, &picture);
      EXPECT_EQ(terrain.extent(), extent) << kind;
      EXPECT_GE(*std::min_element(terrain.mobile().cells().begin(), terrain.mobile().cells().end()), 0) << kind;
      EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected()) << kind;
      const Terrain again = build_scene(scene_config(kind, extent.nx, extent.ny), quantum, &picture);
      EXPECT_EQ(state_hash(terrain), state_hash(again)) << kind;
    }
  }
}

TEST(Scene, FlatIsFlat) {
  const Terrain terrain = build_scene(scene_config("flat"), quantum);
  for (const std::int32_t slabs : terrain.mobile().cells()) EXPECT_EQ(slabs, 3);
  for (const std::int32_t height : terrain.bedrock().cells()) EXPECT_EQ(height, 0);
  EXPECT_DOUBLE_EQ(terrain.quantum(), quantum);
}

TEST(Scene, AFractionOfASlabIsMetInTheMean) {
  Config config = scene_config("flat", 200, 200);
  config.scene.set("sand", 2.3);
  const Terrain terrain = build_scene(config, quantum);
  EXPECT_NEAR(mean_mobile(terrain), 2.3, 4 * std::sqrt(0.3 * 0.7 / 40000));
  for (const std::int32_t slabs : terrain.mobile().cells()) EXPECT_TRUE(slabs == 2 || slabs == 3);
}

TEST(Scene, RandomIsOneSlabMoreOrLess) {
  Config config = scene_config("random", 200, 200);
  const Terrain terrain = build_scene(config, quantum);
  int more = 0;
  for (const std::int32_t slabs : terrain.mobile().cells()) {
    EXPECT_TRUE(slabs == 2 || slabs == 4);
    if (slabs == 4) ++more;
  }
  EXPECT_NEAR(more, 20000, 4 * 100);
  config.run.set("seed", std::int64_t{1});
  EXPECT_NE(build_scene(config, quantum).mobile(), terrain.mobile());
}

TEST(Scene, WavesKeepTheMeanAndReachTheirHeight) {
  for (const char* kind : {"ripples", "transverse"}) {
    Config config = scene_config(kind, 96, 4);
    config.scene.set("sand", 10.0);
    config.scene.set("height", 4.0);  // 12 slabs from trough to crest
    const Terrain terrain = build_scene(config, quantum);
    EXPECT_NEAR(mean_mobile(terrain), 10.0, 0.15) << kind;
    const auto [low, high] = std::minmax_element(terrain.mobile().cells().begin(), terrain.mobile().cells().end());
    EXPECT_EQ(*high - *low, 12) << kind;
    EXPECT_EQ(terrain.mobile()(0, 0), terrain.mobile()(32, 3)) << kind << ": wavelength 32";
  }
}

TEST(Scene, WavesCloseOnATorus) {
  Config config = scene_config("ripples", 100, 1);  // 32 does not divide 100: three waves of 33.3 cells
  config.scene.set("sand", 10.0);
  const Terrain terrain = build_scene(config, quantum);
  for (int x = 0; x < 100; ++x) {
    EXPECT_LE(std::abs(terrain.mobile().wrapped(x + 1, 0) - terrain.mobile()(x, 0)), 2) << x;
  }
}

TEST(Scene, RocksAreThreeBareRectangles) {
  const Terrain terrain = build_scene(scene_config("rocks", 100, 100), quantum);
  int edges = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool rock = terrain.bedrock()(x, y) > 0;
      EXPECT_EQ(terrain.bedrock()(x, y), rock ? 12 : 0);
      EXPECT_EQ(terrain.mobile()(x, y), rock ? 0 : 3);
      const auto bare = [&](int dx, int dy) { return terrain.bedrock().wrapped(x + dx, y + dy) > 0; };
      if (rock && !bare(-1, 0) && !bare(0, -1)) ++edges;  // a south-west corner
    }
  }
  EXPECT_EQ(edges, 3);
}

TEST(Scene, SmoothBedrockSpansItsHeightUnderAnEvenCover) {
  for (const char* kind : {"uneven", "hump", "dune", "valley"}) {
    const Terrain terrain = build_scene(scene_config(kind, 128, 128), quantum);
    const auto [low, high] = std::minmax_element(terrain.bedrock().cells().begin(), terrain.bedrock().cells().end());
    EXPECT_EQ(*low, 0) << kind;
    EXPECT_EQ(*high, 12) << kind;
    for (const std::int32_t slabs : terrain.mobile().cells()) ASSERT_EQ(slabs, 3) << kind;
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {  // smooth, also over the edges of the torus
        ASSERT_LE(std::abs(terrain.bedrock().wrapped(x + 1, y) - terrain.bedrock()(x, y)), 4) << kind;
        ASSERT_LE(std::abs(terrain.bedrock().wrapped(x, y + 1) - terrain.bedrock()(x, y)), 4) << kind;
      }
    }
  }
}

TEST(Scene, DuneIsGentleToTheWest) {
  const Terrain terrain = build_scene(scene_config("dune", 128, 128), quantum);
  int crest = 0;
  for (int x = 0; x < 128; ++x) {
    if (terrain.bedrock()(x, 64) > terrain.bedrock()(crest, 64)) crest = x;
  }
  EXPECT_GT(crest, 64 + 4);
  EXPECT_LT(crest, 64 + 16);
}

TEST(Scene, ConeHasItsHeightAndFoot) {
  const Terrain terrain = build_scene(scene_config("cone", 129, 129), quantum);
  EXPECT_EQ(terrain.mobile()(64, 64), 15);
  EXPECT_EQ(terrain.mobile()(64 + 16, 64), 3 + 6);
  EXPECT_EQ(terrain.mobile()(64, 64 + 33), 3);
}

TEST(Scene, ImageFillsItsRole) {
  HeightPicture picture({2, 1});
  picture(1, 0) = 1.0f;  // black west, white east
  for (const std::string role : {"bedrock", "sand", "both"}) {
    Config config = scene_config("image", 2, 1);
    config.scene.set("image_role", role);
    config.scene.set("image_low", 1.0);
    config.scene.set("image_high", 5.0);
    const Terrain terrain = build_scene(config, 0.5, &picture);
    const int cover = role == "sand" ? 0 : 3;
    EXPECT_EQ(terrain.height(0, 0), role == "bedrock" ? 2 + cover : 2) << role;
    EXPECT_EQ(terrain.height(1, 0), role == "bedrock" ? 10 + cover : 10) << role;
    EXPECT_EQ(terrain.mobile()(1, 0), role == "sand" ? 10 : 3) << role;
  }
}

TEST(Scene, ImageIsInterpolatedOrAveraged) {
  HeightPicture picture({4, 4});
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) picture(x, y) = static_cast<float>(x) / 3;
  }
  Config config = scene_config("image", 2, 2);
  config.scene.set("image_high", 6.0);
  const Terrain small = build_scene(config, 0.01, &picture);
  EXPECT_NEAR(0.5 * (small.bedrock()(0, 0) + small.bedrock()(1, 1)), 300, 1);
  config = scene_config("image", 40, 40);
  config.scene.set("image_high", 6.0);
  const Terrain large = build_scene(config, 0.01, &picture);
  for (int x = 5; x < 34; ++x) EXPECT_NEAR(large.bedrock()(x + 1, 3) - large.bedrock()(x, 3), 20, 1.01);
}

TEST(Scene, ImageWithoutPictureIsRefused) { EXPECT_THROW(build_scene(scene_config("image"), quantum), InputError); }

TEST(Scene, AnOpenGridTakesItsInflow) {
  Config config = scene_config("flat");
  config.grid.set("boundary", std::string("open"));
  config.grid.set("inflow", 0.5);
  const Terrain terrain = build_scene(config, quantum);
  EXPECT_EQ(terrain.boundary(), Boundary::open);
  EXPECT_DOUBLE_EQ(terrain.inflow(), 0.5);
}

}  // namespace
}  // namespace erg
