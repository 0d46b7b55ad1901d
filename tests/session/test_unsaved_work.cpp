// What stands in no file: nothing that a person has made is left behind without a question.
#include "session/unsaved_work.h"

#include <gtest/gtest.h>

#include "../unit/temporary_folder.h"
#include "io/config/config_file.h"
#include "session/app_model.h"
#include "small_config.h"

namespace erg {

using io::write_config;
using session::AppModel;
using session::Leaves;
using session::UnsavedWork;

namespace {

using test::small_config;

struct UnsavedWorkTest : testing::Test {
  TemporaryFolder folder;
  AppModel app{{folder / "settings", folder / "state", folder / "presets"}};

  void SetUp() override {
    write_config(folder / "small.json", small_config());
    ASSERT_TRUE(app.open(folder / "small.json"));
    settle();
  }
  void settle() {
    app.runner().wait_until_still();
    app.tick();
    app.runner().wait_until_still();  // what the tick itself gave
    app.tick();
  }
  void paint(std::size_t run, std::uint64_t stroke) {
    app.runner().paint(run, {.x = 20.5, .y = 20.5, .radius = 3, .amount = 9}, stroke);
    settle();
  }
  void export_as(const std::string& format) {
    app.start_export(folder / ("kept." + format), format);
    while (app.running_export()->state() == session::Export::State::writing) app.tick();
    app.tick();
  }
  std::string unsaved(Leaves leaves = Leaves::everything) {
    const auto work = app.unsaved_work(leaves);
    return work ? work->what : "";
  }
};

TEST_F(UnsavedWorkTest, ARunThatOneCanGrowAgainIsNoWork) {
  app.runner().run(30);
  settle();
  EXPECT_EQ(unsaved(), "");
}

TEST_F(UnsavedWorkTest, AnEditedSetupIsWorkUntilItIsSavedOrTakenBack) {
  const double before = app.setup().config().parameters.real("p_sand");
  app.setup().set("parameters", "p_sand", 0.5);
  EXPECT_NE(unsaved().find("setup"), std::string::npos) << unsaved();
  EXPECT_EQ(unsaved(Leaves::terrain), "") << "CREATE leaves the setup as it is";
  app.setup().set("parameters", "p_sand", before);
  EXPECT_EQ(unsaved(), "");
  app.setup().set("parameters", "p_sand", 0.5);
  ASSERT_TRUE(app.save_config(folder / "other.json"));
  EXPECT_EQ(unsaved(), "");
}

TEST_F(UnsavedWorkTest, APaintedTerrainIsWorkUntilACheckpointHasIt) {
  paint(0, 1);
  EXPECT_NE(unsaved(Leaves::terrain).find("painted"), std::string::npos) << unsaved();
  EXPECT_TRUE(app.unsaved_work(Leaves::everything)->terrain);
  app.runner().undo();
  settle();
  EXPECT_EQ(unsaved(), "");
  app.runner().redo();
  settle();
  EXPECT_NE(unsaved(), "");
  export_as("checkpoint");
  EXPECT_EQ(unsaved(), "");
  paint(0, 2);
  EXPECT_NE(unsaved(), "") << "another stroke since";
  app.runner().reset();
  settle();
  EXPECT_EQ(unsaved(), "") << "a reset takes the strokes away";
}

TEST_F(UnsavedWorkTest, ACheckpointKeepsTheSetupToo) {
  app.setup().set("parameters", "p_sand", 0.5);
  settle();
  export_as("checkpoint");
  EXPECT_EQ(unsaved(), "");
}

TEST_F(UnsavedWorkTest, AnExportedConfigKeepsTheSetupAndAPictureNothing) {
  app.setup().set("parameters", "p_sand", 0.5);
  settle();
  export_as("png");
  EXPECT_NE(unsaved(), "");
  export_as("json");
  EXPECT_EQ(unsaved(), "");
  paint(0, 1);
  export_as("json");
  EXPECT_NE(unsaved(), "") << "a config has no strokes";
}

TEST_F(UnsavedWorkTest, OfComparedRunsTheOneThatWasEditedOrPaintedIsNamed) {
  app.comparison().add_copy_of(0);
  app.comparison().setup(1).replace(small_config());
  ASSERT_TRUE(app.create());
  settle();
  EXPECT_EQ(unsaved(), "");
  app.comparison().setup(1).set("parameters", "p_sand", 0.5);
  EXPECT_EQ(app.unsaved_work(Leaves::everything)->run, 1u);
  EXPECT_NE(unsaved().find("run 2"), std::string::npos) << unsaved();
  paint(1, 1);
  EXPECT_TRUE(app.unsaved_work(Leaves::everything)->terrain);
  EXPECT_EQ(app.unsaved_work(Leaves::everything)->run, 1u);
}

TEST_F(UnsavedWorkTest, WhatTookLongToGrowIsWorkUntilItIsKept) {
  app.runner().step();
  settle();
  session::Snapshot now = app.now();
  UnsavedWork kept;
  kept.start_from("small.json", small_config());
  const auto is_work = [&] { return kept.missing(app.comparison(), now, Leaves::terrain).has_value(); };
  EXPECT_GT(now.seconds_worked, 0);
  now.seconds_worked = UnsavedWork::long_work - 1;
  EXPECT_FALSE(is_work());
  now.seconds_worked = UnsavedWork::long_work + 1;
  EXPECT_TRUE(is_work());
  kept.terrain_saved(now, 0);
  EXPECT_FALSE(is_work());
  now.seconds_worked += UnsavedWork::long_work;
  EXPECT_TRUE(is_work());
}

TEST_F(UnsavedWorkTest, WhatACrashLeftIsWorkWhenItIsRecovered) {
  app.runner().run(4);
  settle();
  app.rescue();
  // The program that is gone keeps no lock.
  std::filesystem::path lost;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "state")) lost = entry.path();
  std::filesystem::copy(lost, folder / "state/session-1");
  AppModel next({folder / "settings", folder / "state", folder / "presets"});
  ASSERT_EQ(next.crashed_sessions().size(), 1u);
  ASSERT_TRUE(next.recover(next.crashed_sessions().at(0).folder));
  next.runner().wait_until_still();
  next.tick();
  const auto work = next.unsaved_work(Leaves::everything);
  ASSERT_TRUE(work.has_value());
  EXPECT_NE(work->what.find("recovered"), std::string::npos) << work->what;
  next.setup().set_title("another");
  ASSERT_TRUE(next.create());
  next.runner().wait_until_still();
  next.tick();
  EXPECT_FALSE(next.unsaved_work(Leaves::terrain).has_value()) << "it is another terrain now";
}

TEST(FailedStep, SavesTheSessionAndSaysWhere) {
  const TemporaryFolder folder;
  int steps_left = 5;
  AppModel app({folder / "settings", folder / "state", {}}, [&steps_left] {
    if (steps_left-- == 0) throw std::runtime_error("the device is gone");
  });
  write_config(folder / "small.json", small_config());
  ASSERT_TRUE(app.open(folder / "small.json"));
  app.runner().play();
  app.runner().wait_until_still();
  app.tick();
  EXPECT_EQ(app.now().activity, session::Activity::failed);
  std::size_t saved = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "state")) {
    if (entry.path().filename() == "session.json") ++saved;
  }
  EXPECT_EQ(saved, 1u);
  EXPECT_NE(app.log().text().find("the terrain is saved in"), std::string::npos) << app.log().text();
}

}  // namespace
}  // namespace erg
