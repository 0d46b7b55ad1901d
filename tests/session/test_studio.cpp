// The view model as the panels use it.
#include "session/studio.h"

#include <gtest/gtest.h>

#include "../unit/temporary_folder.h"
#include "io/config/config_file.h"
#include "io/formats/heightmap.h"
#include "small_config.h"

namespace erg {

using io::write_config;
using session::Activity;
using session::LogLevel;
using session::Studio;
using sim::Config;

namespace {

namespace fs = std::filesystem;
using test::small_config;

struct StudioTest : testing::Test {
  TemporaryFolder folder;
  Studio studio{{folder / "settings", folder / "state", folder / "presets"}};

  void settle() {
    studio.runner().wait_until_still();
    studio.tick();
    studio.runner().wait_until_still();  // what the tick itself gave
    studio.tick();
  }
  fs::path saved(const std::string& name, const Config& config) {
    write_config(folder / name, config);
    return folder / name;
  }
};

TEST_F(StudioTest, BeginsEmptyWithTheDefaultSetup) {
  studio.tick();
  EXPECT_EQ(studio.now().activity, Activity::empty);
  EXPECT_EQ(studio.setup().config(), Config());
  EXPECT_TRUE(studio.create_needed());
  EXPECT_FALSE(studio.unsaved());
  EXPECT_EQ(studio.active_run(), nullptr);
  EXPECT_EQ(studio.title(), "untitled - Momiji et al. 2000, 256 x 256");
}

TEST_F(StudioTest, OpensRunsSavesAndOpensAgain) {
  Config config = small_config();
  config.title = "small";
  ASSERT_TRUE(studio.open(saved("small.json", config)));
  settle();
  EXPECT_EQ(studio.now().activity, Activity::paused);
  EXPECT_FALSE(studio.create_needed());
  EXPECT_FALSE(studio.unsaved());
  EXPECT_EQ(studio.title(), "small - Werner 1995, 48 x 40");
  EXPECT_EQ(studio.settings().recent, std::vector<std::string>{(folder / "small.json").string()});
  studio.runner().run(10);
  settle();
  EXPECT_EQ(studio.active_run()->step, 10);
  ASSERT_FALSE(studio.setup().set_text("parameters", "p_sand", "0.5").has_value());
  EXPECT_TRUE(studio.unsaved());
  EXPECT_FALSE(studio.create_needed());
  settle();
  EXPECT_EQ(studio.active_run()->config->parameters.real("p_sand"), 0.5) << "takes effect by itself";
  ASSERT_TRUE(studio.save_config(folder / "changed.json"));
  EXPECT_FALSE(studio.unsaved());
  ASSERT_TRUE(studio.open(folder / "changed.json"));
  settle();
  EXPECT_EQ(studio.setup().config().parameters.real("p_sand"), 0.5);
  EXPECT_EQ(studio.active_run()->step, 0);
}

TEST_F(StudioTest, AFileWithMistakesIsReportedLineByLineAndChangesNothing) {
  ASSERT_TRUE(studio.open(saved("small.json", small_config())));
  settle();
  studio.runner().run(4);
  settle();
  write_bytes(folder / "bad.json", "{\"erg\": 1,\n\"model\": \"werner\",\n\"grid\": {\"nx\": -3},\n\"rum\": {}}");
  studio.log().clear();
  EXPECT_FALSE(studio.open(folder / "bad.json"));
  settle();
  const std::vector<session::LogLine> lines = studio.log().lines(LogLevel::error);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].text.find("bad.json:3: nx is -3"), std::string::npos) << lines[0].text;
  EXPECT_NE(lines[1].text.find("bad.json:4: unknown key \"rum\""), std::string::npos) << lines[1].text;
  EXPECT_EQ(studio.setup().config(), small_config());
  EXPECT_EQ(studio.active_run()->step, 4);
}

TEST_F(StudioTest, AFileWhoseTerrainCannotBeMadeChangesNothing) {
  ASSERT_TRUE(studio.open(saved("small.json", small_config())));
  settle();
  write_bytes(folder / "no picture.png", "this is no picture");
  Config config = small_config();
  config.scene.set("kind", std::string("image"));
  config.scene.set("image", (folder / "no picture.png").string());
  config.parameters.set("p_sand", 0.1);
  studio.open(saved("bad.json", config));
  settle();
  EXPECT_EQ(studio.setup().config(), small_config());
  EXPECT_EQ(studio.file(), folder / "small.json");
  EXPECT_EQ(*studio.active_run()->config, small_config());
  EXPECT_GE(studio.log().count(LogLevel::error), 1u);
}

TEST_F(StudioTest, TheGridComesFromThePictureWhereThatIsAskedForAndTheLogTellsWhatThePictureSays) {
  io::write_heightmap(folder / "ground.png", Terrain({9, 7}, 2.0, 0.5), {});
  Config config = small_config();
  config.scene.set("kind", std::string("image"));
  config.scene.set("image", (folder / "ground.png").string());
  config.scene.set("image_fit", std::string("from_file"));
  write_bytes(folder / "ground.json", "// mine\n" + io::config_text(config));
  ASSERT_TRUE(studio.open(folder / "ground.json"));
  settle();
  ASSERT_NE(studio.active_run(), nullptr);
  EXPECT_EQ(studio.setup().config().grid.integer("nx"), 9);
  EXPECT_EQ(studio.setup().config().grid.real("cell_size"), 2.0);
  EXPECT_EQ(*studio.active_run()->config, studio.setup().config());
  EXPECT_FALSE(studio.create_needed());
  EXPECT_FALSE(studio.unsaved());
  EXPECT_NE(studio.log().text().find("heights in the picture, 0 to 0 m"), std::string::npos) << studio.log().text();
  EXPECT_NE(studio.log().text().find("its comments are not kept"), std::string::npos) << studio.log().text();
}

TEST_F(StudioTest, WhatIsOpenedToPlayRunsOnceItIsMadeAndElseNothingDoes) {
  write_bytes(folder / "no picture.png", "this is no picture");
  Config bad = small_config();
  bad.scene.set("kind", std::string("image"));
  bad.scene.set("image", (folder / "no picture.png").string());
  const auto opened = [this](const fs::path& path) {
    EXPECT_TRUE(studio.open_and_play(path));
    studio.runner().wait_for_commands();
    studio.tick();
    studio.runner().wait_for_commands();
    studio.tick();
    return studio.now().activity;
  };
  ASSERT_TRUE(studio.open(saved("small.json", small_config())));
  settle();
  EXPECT_EQ(opened(saved("bad.json", bad)), Activity::paused) << "what was there is not set going";
  EXPECT_EQ(opened(folder / "small.json"), Activity::running);
}

TEST_F(StudioTest, WhatNeedsANewTerrainWaitsForCreateAndTheRestDoesNot) {
  ASSERT_TRUE(studio.open(saved("small.json", small_config())));
  settle();
  studio.setup().set_text("grid", "nx", "64");
  studio.setup().set_text("parameters", "p_sand", "0.5");
  settle();
  EXPECT_TRUE(studio.create_needed());
  EXPECT_EQ(studio.active_run()->terrain->nx(), 48);
  EXPECT_EQ(studio.active_run()->config->parameters.real("p_sand"), 0.5);
  ASSERT_TRUE(studio.create());
  settle();
  EXPECT_FALSE(studio.create_needed());
  EXPECT_EQ(studio.active_run()->terrain->nx(), 64);
}

TEST_F(StudioTest, TwoRunsAreComparedUnderOneWind) {
  ASSERT_TRUE(studio.open(saved("small.json", small_config())));
  ASSERT_EQ(studio.comparison().add_copy_of(0), 1u);
  EXPECT_TRUE(studio.create_needed());
  ASSERT_TRUE(studio.create());
  studio.runner().run(6);
  settle();
  ASSERT_EQ(studio.now().runs.size(), 2u);
  ASSERT_FALSE(studio.comparison().wind().set_bearing(0, "S").has_value());
  settle();
  studio.runner().step();
  settle();
  for (const session::RunSnapshot& run : studio.now().runs) EXPECT_NEAR(run.last_wind.mean_bearing(), 180, 1e-9);
  const std::vector<session::ComparedNumber> table = session::compared_numbers(studio.now());
  EXPECT_EQ(table.front().values.size(), 2u);
}

TEST_F(StudioTest, ExportsAndSaysSo) {
  studio.start_export(folder / "nothing.obj", "obj");
  EXPECT_EQ(studio.running_export(), nullptr);
  ASSERT_TRUE(studio.open(saved("small.json", small_config())));
  settle();
  studio.start_export(folder / "dunes.checkpoint", "checkpoint");
  while (studio.running_export()->state() == session::Export::State::writing) studio.tick();
  studio.tick();
  EXPECT_NE(studio.log().text().find("wrote "), std::string::npos);
  ASSERT_TRUE(studio.open(folder / "dunes.checkpoint"));
  settle();
  EXPECT_EQ(studio.setup().config(), small_config());
}

TEST(StudioSession, ComesBackAfterTheDisplayIsLost) {
  const TemporaryFolder folder;
  const session::StudioFolders folders{folder / "settings", folder / "state", {}};
  write_config(folder / "small.json", small_config());
  std::uint64_t hash = 0;
  {
    Studio studio(folders);
    ASSERT_TRUE(studio.open(folder / "small.json"));
    studio.runner().run(8);
    studio.runner().wait_until_still();
    studio.tick();
    hash = state_hash(*studio.active_run()->terrain);
    EXPECT_NE(studio.rescue().find("next start"), std::string::npos);
  }
  {
    Studio studio(folders);
    ASSERT_EQ(studio.lost_sessions().size(), 1u);
    EXPECT_EQ(studio.lost_sessions()[0].step, 8);
    ASSERT_TRUE(studio.recover(studio.lost_sessions().at(0).folder));
    studio.runner().wait_until_still();
    studio.tick();
    EXPECT_EQ(studio.active_run()->step, 8);
    EXPECT_EQ(state_hash(*studio.active_run()->terrain), hash);
    EXPECT_EQ(studio.setup().config(), small_config());
  }
  Studio studio(folders);
  ASSERT_EQ(studio.lost_sessions().size(), 1u) << "it was not saved anew: still on offer";
  studio.discard_lost(studio.lost_sessions().at(0).folder);
  EXPECT_TRUE(studio.lost_sessions().empty());
}

}  // namespace
}  // namespace erg
