// The dialogs by hand: gallery, files, export, log, recovery.
#include <gtest/gtest.h>

#include "io/config/config_file.h"
#include "panel_hand.h"

namespace erg::test {

using io::read_config;
using session::Activity;
using session::Export;
using sim::Config;
using ui::make_gallery_panel;
using ui::make_open_panel;
using ui::make_recovery_panel;
using ui::make_save_panel;

namespace {

void write_preset(const std::filesystem::path& path, const std::string& title) {
  Config config = small_config();
  config.title = title;
  io::write_config(path, config);
}

TEST(GalleryPanel, OneClickAndDunesGrow) {
  PanelHand panel(make_gallery_panel(),
                  [](const TemporaryFolder& folder) { write_preset(folder / "presets/star.json", "Star dunes"); });
  panel.hand.click("GALLERY/star");
  panel.settle();  // it is made
  panel.settle();  // and set going
  EXPECT_EQ(panel.app.setup().config().title, "Star dunes");
  ASSERT_TRUE(panel.app.now().has_runs());
  EXPECT_EQ(panel.app.now().activity, Activity::running);
  EXPECT_EQ(panel.closed, std::vector<std::string>{"GALLERY"});
}

TEST(GalleryPanel, WithoutPresetsItSaysWhatToDo) {
  PanelHand panel(make_gallery_panel());
  panel.hand.frames(2);
  EXPECT_TRUE(panel.closed.empty());
}

TEST(OpenPanel, OpensAFileFromItsFolder) {
  PanelHand panel(make_open_panel(), [](const TemporaryFolder& folder) {
    std::filesystem::create_directory(folder / "mine");
    write_preset(folder / "mine/erg.json", "Mine");
    write_preset(folder / "other.json", "Other");
    write_bytes(folder / "notes.txt", "no config");
  });
  EXPECT_FALSE(panel.hand.has("files/notes.txt")) << "only what can be opened is listed";
  panel.hand.click("files/mine/");
  panel.hand.double_click("files/erg.json");
  panel.settle();
  EXPECT_EQ(panel.app.setup().config().title, "Mine");
  EXPECT_EQ(panel.closed, std::vector<std::string>{"OPEN"});
}

TEST(OpenPanel, FiltersAndTakesATypedPath) {
  PanelHand panel(make_open_panel(), [](const TemporaryFolder& folder) {
    write_preset(folder / "barchans.json", "Barchans");
    write_preset(folder / "stars.json", "Stars");
  });
  panel.hand.click("OPEN/filter");
  panel.hand.type("star");
  EXPECT_TRUE(panel.hand.has("files/stars.json"));
  EXPECT_FALSE(panel.hand.has("files/barchans.json"));
  panel.hand.enter("OPEN/path", (panel.folder / "barchans.json").string());
  panel.settle();
  EXPECT_EQ(panel.app.setup().config().title, "Barchans");
}

TEST(OpenPanel, AFileWithMistakesLeavesWhatWasOpenAndFillsTheLog) {
  PanelHand panel(make_open_panel(), [](const TemporaryFolder& folder) {
    write_bytes(folder / "wrong.json", "{\"erg\": 1,\n\"model\": \"momiji\",\n\"grid\": {\"nx\": -5}}");
  });
  panel.app.setup().set_title("before");
  panel.hand.double_click("files/wrong.json");
  panel.settle();
  EXPECT_EQ(panel.app.setup().config().title, "before");
  EXPECT_NE(panel.app.log().text().find("wrong.json:3"), std::string::npos) << panel.app.log().text();
  EXPECT_EQ(panel.opened, std::vector<std::string>{"LOG"});
}

TEST(SavePanel, AddsTheEndingAndAsksBeforeAFileIsReplaced) {
  PanelHand panel(make_save_panel());
  panel.app.setup().set_title("My dunes");
  panel.hand.enter("SAVE AS/name", "mine");
  ASSERT_TRUE(std::filesystem::exists(panel.folder / "mine.json"));
  EXPECT_EQ(read_config(panel.folder / "mine.json").title, "My dunes");

  panel.app.setup().set_title("Other dunes");
  panel.hand.enter("SAVE AS/name", "mine");
  EXPECT_EQ(read_config(panel.folder / "mine.json").title, "My dunes") << "it asks first";
  panel.hand.click("KEEP IT");
  EXPECT_FALSE(panel.hand.has("REPLACE"));
  panel.hand.click("SAVE AS/SAVE");
  panel.hand.click("REPLACE");
  EXPECT_EQ(read_config(panel.folder / "mine.json").title, "Other dunes");
}

TEST(SavePanel, CancelWritesNothing) {
  PanelHand panel(make_save_panel());
  const auto is_config = [](const auto& entry) { return entry.path().extension() == ".json"; };
  const auto configs = [&] {
    const std::filesystem::recursive_directory_iterator all(panel.folder.path());
    return std::count_if(begin(all), end(all), is_config);
  };
  panel.hand.click("SAVE AS/CANCEL");
  EXPECT_EQ(panel.closed, std::vector<std::string>{"SAVE AS"});
  EXPECT_EQ(configs(), 0);
  panel.hand.enter("SAVE AS/name", "no/such/folder/x");
  EXPECT_EQ(configs(), 0);
  EXPECT_EQ(panel.closed.size(), 1u) << "it stays, and says that there is no such folder";
}

TEST(ExportPanel, WritesEveryFormat) {
  PanelHand panel(ui::make_export_panel());
  panel.create();
  for (const session::ExportFormat& format : session::export_formats()) {
    panel.hand.click("EXPORT/" + format.key);
    panel.hand.click("EXPORT/EXPORT");
    panel.hand.enter("EXPORT TO/name", "out-" + format.key);
    ASSERT_NE(panel.app.running_export(), nullptr) << format.key;
    while (panel.app.running_export()->state() == Export::State::writing) panel.hand.frames();
    EXPECT_EQ(panel.app.running_export()->state(), Export::State::done)
        << format.key << ": " << panel.app.running_export()->problem();
    EXPECT_TRUE(std::filesystem::exists(panel.folder / ("out-" + format.key + format.ending))) << format.key;
  }
}

TEST(LogPanel, FiltersByLevelCopiesAndClears) {
  PanelHand panel(ui::make_log_panel());
  panel.app.log().clear();
  panel.app.log().information("a word");
  panel.app.log().warning("a warning");
  panel.app.log().error("an error");
  panel.hand.frames(2);
  panel.hand.click("LOG/ERRORS");
  panel.hand.click("LOG/COPY");
  const std::string copied = ImGui::GetClipboardText();
  EXPECT_NE(copied.find("an error"), std::string::npos);
  EXPECT_EQ(copied.find("a warning"), std::string::npos);
  panel.hand.click("LOG/CLEAR");
  EXPECT_TRUE(panel.app.log().lines().empty());
}

TEST(RecoveryPanel, ShowsNothingAfterAnOrderlyEnd) {
  PanelHand panel(make_recovery_panel());
  const ui::PanelContext context{panel.app, {}, ui::TerrainTool::camera, {}, {}, {}, {}, {}, {}};
  EXPECT_FALSE(make_recovery_panel()->wanted(context));
}

/// What a crash leaves at step 3 of the small terrain.
void leave_session(const TemporaryFolder& folder) {
  Config config = small_config();
  config.title = "left behind";
  session::AppModel app({folder / "settings", folder / "state", folder / "presets"});
  app.setup().replace(config);
  app.create();
  app.runner().run(3);
  app.runner().wait_until_still();
  app.rescue();
}

TEST(RecoveryPanel, RecoverGoesOnFromWhatWasSaved) {
  PanelHand panel(make_recovery_panel(), leave_session);
  ASSERT_EQ(panel.app.crashed_sessions().size(), 1u);
  panel.hand.click("RECOVERY/session 1/RECOVER");
  panel.settle();
  EXPECT_TRUE(panel.app.crashed_sessions().empty());
  EXPECT_EQ(panel.app.setup().config().title, "left behind");
  ASSERT_TRUE(panel.app.now().has_runs());
  EXPECT_EQ(panel.app.now().step(), 3);
  EXPECT_EQ(panel.app.now().activity, Activity::paused);
  EXPECT_EQ(panel.closed, (std::vector<std::string>{"RECOVERY", "GALLERY"}));
}

/// The question about unsaved work may be answered after the session has gone.
TEST(RecoveryPanel, RecoverOfWhatHasBeenDiscardedLeavesAllAsItIs) {
  PanelHand panel(make_recovery_panel(), leave_session);
  const std::filesystem::path saved = panel.app.crashed_sessions().at(0).folder;
  panel.hand.click("RECOVERY/session 1/DISCARD");
  EXPECT_FALSE(panel.app.recover(saved));
  EXPECT_FALSE(panel.app.now().has_runs());
  EXPECT_NE(panel.app.log().lines().back().text.find(saved.string()), std::string::npos);
}

TEST(RecoveryPanel, DiscardDeletesWhatWasSaved) {
  PanelHand panel(make_recovery_panel(), leave_session);
  ASSERT_EQ(panel.app.crashed_sessions().size(), 1u);
  const std::filesystem::path saved = panel.app.crashed_sessions().front().folder;
  ASSERT_TRUE(std::filesystem::exists(saved / "session.json"));
  panel.hand.click("RECOVERY/session 1/DISCARD");
  EXPECT_TRUE(panel.app.crashed_sessions().empty());
  EXPECT_FALSE(std::filesystem::exists(saved));
  EXPECT_FALSE(panel.app.now().has_runs());
  EXPECT_TRUE(panel.closed.empty());
}

}  // namespace
}  // namespace erg::test
