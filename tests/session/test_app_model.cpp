// The view model as the panels use it.
#include "session/app_model.h"

#include <gtest/gtest.h>

#include "../unit/temporary_folder.h"
#include "io/config/config_file.h"
#include "io/formats/heightmap.h"
#include "small_config.h"

namespace erg {

using io::write_config;
using session::Activity;
using session::AppModel;
using session::LogLevel;
using sim::Config;

namespace {

namespace fs = std::filesystem;
using test::small_config;

struct AppModelTest : testing::Test {
  TemporaryFolder folder;
  AppModel app{{folder / "settings", folder / "state", folder / "presets"}};

  void settle() {
    app.runner().wait_until_still();
    app.tick();
    app.runner().wait_until_still();  // what the tick itself gave
    app.tick();
  }
  fs::path saved(const std::string& name, const Config& config) {
    write_config(folder / name, config);
    return folder / name;
  }
};

TEST_F(AppModelTest, BeginsEmptyWithTheDefaultSetup) {
  app.tick();
  EXPECT_EQ(app.now().activity, Activity::empty);
  EXPECT_EQ(app.setup().config(), Config());
  EXPECT_TRUE(app.create_needed());
  EXPECT_FALSE(app.unsaved());
  EXPECT_EQ(app.active_run(), nullptr);
  EXPECT_EQ(app.title(), "untitled - Momiji et al. 2000, 256 x 256");
}

TEST_F(AppModelTest, OpensRunsSavesAndOpensAgain) {
  Config config = small_config();
  config.title = "small";
  ASSERT_TRUE(app.open(saved("small.json", config)));
  settle();
  EXPECT_EQ(app.now().activity, Activity::paused);
  EXPECT_FALSE(app.create_needed());
  EXPECT_FALSE(app.unsaved());
  EXPECT_EQ(app.title(), "small - Werner 1995, 48 x 40");
  EXPECT_EQ(app.settings().recent, std::vector<std::string>{(folder / "small.json").string()});
  app.runner().run(10);
  settle();
  EXPECT_EQ(app.active_run()->step, 10);
  ASSERT_FALSE(app.setup().set_text("parameters", "p_sand", "0.5").has_value());
  EXPECT_TRUE(app.unsaved());
  EXPECT_FALSE(app.create_needed());
  settle();
  EXPECT_EQ(app.active_run()->config->parameters.real("p_sand"), 0.5) << "takes effect by itself";
  ASSERT_TRUE(app.save_config(folder / "changed.json"));
  EXPECT_FALSE(app.unsaved());
  ASSERT_TRUE(app.open(folder / "changed.json"));
  settle();
  EXPECT_EQ(app.setup().config().parameters.real("p_sand"), 0.5);
  EXPECT_EQ(app.active_run()->step, 0);
}

TEST_F(AppModelTest, AFileWithMistakesIsReportedLineByLineAndChangesNothing) {
  ASSERT_TRUE(app.open(saved("small.json", small_config())));
  settle();
  app.runner().run(4);
  settle();
  write_bytes(folder / "bad.json", "{\"erg\": 1,\n\"model\": \"werner\",\n\"grid\": {\"nx\": -3},\n\"rum\": {}}");
  app.log().clear();
  EXPECT_FALSE(app.open(folder / "bad.json"));
  settle();
  const std::vector<session::LogLine> lines = app.log().lines(LogLevel::error);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].text.find("bad.json:3: nx is -3"), std::string::npos) << lines[0].text;
  EXPECT_NE(lines[1].text.find("bad.json:4: unknown key \"rum\""), std::string::npos) << lines[1].text;
  EXPECT_EQ(app.setup().config(), small_config());
  EXPECT_EQ(app.active_run()->step, 4);
}

TEST_F(AppModelTest, AFileWhoseTerrainCannotBeMadeChangesNothing) {
  ASSERT_TRUE(app.open(saved("small.json", small_config())));
  settle();
  write_bytes(folder / "no picture.png", "this is no picture");
  Config config = small_config();
  config.scene.set("kind", std::string("image"));
  config.scene.set("image", (folder / "no picture.png").string());
  config.parameters.set("p_sand", 0.1);
  app.open(saved("bad.json", config));
  settle();
  EXPECT_EQ(app.setup().config(), small_config());
  EXPECT_EQ(app.file(), folder / "small.json");
  EXPECT_EQ(*app.active_run()->config, small_config());
  EXPECT_GE(app.log().count(LogLevel::error), 1u);
}

TEST_F(AppModelTest, TheGridComesFromThePictureWhereThatIsAskedForAndTheLogTellsWhatThePictureSays) {
  io::write_heightmap(folder / "ground.png", Terrain({9, 7}, 2.0, 0.5), {});
  Config config = small_config();
  config.scene.set("kind", std::string("image"));
  config.scene.set("image", (folder / "ground.png").string());
  config.scene.set("image_fit", std::string("from_file"));
  write_bytes(folder / "ground.json", "// mine\n" + io::config_text(config));
  ASSERT_TRUE(app.open(folder / "ground.json"));
  settle();
  ASSERT_NE(app.active_run(), nullptr);
  EXPECT_EQ(app.setup().config().grid.integer("nx"), 9);
  EXPECT_EQ(app.setup().config().grid.real("cell_size"), 2.0);
  EXPECT_EQ(*app.active_run()->config, app.setup().config());
  EXPECT_FALSE(app.create_needed());
  EXPECT_FALSE(app.unsaved());
  EXPECT_NE(app.log().text().find("heights in the picture, 0 to 0 m"), std::string::npos) << app.log().text();
  EXPECT_NE(app.log().text().find("its comments are not kept"), std::string::npos) << app.log().text();
}

TEST_F(AppModelTest, WhatIsOpenedToPlayRunsOnceItIsMadeAndElseNothingDoes) {
  write_bytes(folder / "no picture.png", "this is no picture");
  Config bad = small_config();
  bad.scene.set("kind", std::string("image"));
  bad.scene.set("image", (folder / "no picture.png").string());
  const auto opened = [this](const fs::path& path) {
    EXPECT_TRUE(app.open_and_play(path));
    app.runner().wait_for_commands();
    app.tick();
    app.runner().wait_for_commands();
    app.tick();
    return app.now().activity;
  };
  ASSERT_TRUE(app.open(saved("small.json", small_config())));
  settle();
  EXPECT_EQ(opened(saved("bad.json", bad)), Activity::paused) << "what was there is not set going";
  EXPECT_EQ(opened(folder / "small.json"), Activity::running);
}

TEST_F(AppModelTest, WhatNeedsANewTerrainWaitsForCreateAndTheRestDoesNot) {
  ASSERT_TRUE(app.open(saved("small.json", small_config())));
  settle();
  app.setup().set_text("grid", "nx", "64");
  app.setup().set_text("parameters", "p_sand", "0.5");
  settle();
  EXPECT_TRUE(app.create_needed());
  EXPECT_EQ(app.active_run()->terrain->nx(), 48);
  EXPECT_EQ(app.active_run()->config->parameters.real("p_sand"), 0.5);
  ASSERT_TRUE(app.create());
  settle();
  EXPECT_FALSE(app.create_needed());
  EXPECT_EQ(app.active_run()->terrain->nx(), 64);
}

TEST_F(AppModelTest, TwoRunsAreComparedUnderOneWind) {
  ASSERT_TRUE(app.open(saved("small.json", small_config())));
  ASSERT_EQ(app.comparison().add_copy_of(0), 1u);
  EXPECT_TRUE(app.create_needed());
  ASSERT_TRUE(app.create());
  app.runner().run(6);
  settle();
  ASSERT_EQ(app.now().runs.size(), 2u);
  ASSERT_FALSE(app.comparison().wind().set_bearing(0, "S").has_value());
  settle();
  app.runner().step();
  settle();
  for (const session::RunSnapshot& run : app.now().runs) EXPECT_NEAR(run.last_wind.mean_bearing(), 180, 1e-9);
  const std::vector<session::ComparedNumber> table = session::compared_numbers(app.now());
  EXPECT_EQ(table.front().values.size(), 2u);
}

TEST_F(AppModelTest, ExportsAndSaysSo) {
  app.start_export(folder / "nothing.obj", "obj");
  EXPECT_EQ(app.running_export(), nullptr);
  ASSERT_TRUE(app.open(saved("small.json", small_config())));
  settle();
  app.start_export(folder / "dunes.checkpoint", "checkpoint");
  while (app.running_export()->state() == session::Export::State::writing) app.tick();
  app.tick();
  EXPECT_NE(app.log().text().find("wrote "), std::string::npos);
  ASSERT_TRUE(app.open(folder / "dunes.checkpoint"));
  settle();
  EXPECT_EQ(app.setup().config(), small_config());
}

TEST(AppModelSession, ComesBackAfterTheDisplayIsLost) {
  const TemporaryFolder folder;
  const session::AppFolders folders{folder / "settings", folder / "state", {}};
  write_config(folder / "small.json", small_config());
  std::uint64_t hash = 0;
  {
    AppModel app(folders);
    ASSERT_TRUE(app.open(folder / "small.json"));
    app.runner().run(8);
    app.runner().wait_until_still();
    app.tick();
    hash = state_hash(*app.active_run()->terrain);
    EXPECT_NE(app.rescue().find("next start"), std::string::npos);
  }
  {
    AppModel app(folders);
    ASSERT_EQ(app.crashed_sessions().size(), 1u);
    EXPECT_EQ(app.crashed_sessions()[0].step, 8);
    ASSERT_TRUE(app.recover(app.crashed_sessions().at(0).folder));
    app.runner().wait_until_still();
    app.tick();
    EXPECT_EQ(app.active_run()->step, 8);
    EXPECT_EQ(state_hash(*app.active_run()->terrain), hash);
    EXPECT_EQ(app.setup().config(), small_config());
  }
  AppModel app(folders);
  ASSERT_EQ(app.crashed_sessions().size(), 1u) << "it was not saved anew: still on offer";
  app.discard_crashed(app.crashed_sessions().at(0).folder);
  EXPECT_TRUE(app.crashed_sessions().empty());
}

}  // namespace
}  // namespace erg
