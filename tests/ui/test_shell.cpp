// Menus, run bar, look panel, terrain: what a hand does there reaches the view model.
#include <gtest/gtest.h>

#include <optional>
#include <thread>

#include "../session/torn_session.h"
#include "io/config/config_file.h"
#include "io/formats/camera_file.h"
#include "shell_hand.h"
#include "ui/land/look_panel.h"
#include "ui/window/picture_panel.h"

namespace erg::test {

using io::read_camera;
using io::read_config;
using io::write_config;
using picture::Camera;
using session::Activity;
using ui::Shell;
using ui::WidgetPlace;

namespace {

// It can be read, so that it fails only when its runs are made.
TEST(Shell, ARecoveryThatFailsInTheEndOpensTheLog) {
  const TemporaryFolder folder;
  leave_torn_session(folder.path(), small_config());
  session::AppModel app({{}, folder.path(), {}});
  ASSERT_EQ(app.crashed_sessions().size(), 1u);
  FlatHost host;
  std::optional<Shell> shell;
  UiHarness hand{[&] {
    app.tick();
    if (shell) shell->draw();
  }};
  shell.emplace(app, host, hand.gui());
  hand.frames(2);
  EXPECT_TRUE(app.recover(app.crashed_sessions().front().folder));
  EXPECT_FALSE(shell->is_open("LOG"));
  app.runner().wait_until_still();
  hand.frames(2);
  EXPECT_TRUE(shell->is_open("LOG"));
  shell->close("LOG");
  hand.frames(2);
  EXPECT_FALSE(shell->is_open("LOG")) << "closed, it stays so";
  shell.reset();
}

TEST_F(ShellHand, WithoutALandEverythingThatNeedsOneIsOffAndSaysSo) {
  EXPECT_FALSE(hand.place("RUN/play").enabled);
  EXPECT_FALSE(hand.place("RUN/step").enabled);
  EXPECT_FALSE(hand.place("RUN/reset").enabled);
  hand.shortcut(' ', false);
  EXPECT_EQ(now().activity, Activity::empty);
  hand.click("Choose a preset");
  EXPECT_TRUE(shell->is_open("GALLERY"));
}

TEST_F(ShellHand, StepRunAndResetDoWhatTheySay) {
  create();
  hand.click("RUN/step");
  settle();
  EXPECT_EQ(now().step(), 1);
  hand.enter("steps to run", "7");
  hand.click("RUN/run");
  settle();
  EXPECT_EQ(now().step(), 8);
  EXPECT_EQ(now().activity, Activity::paused);
  hand.click("RUN/reset");
  settle();
  EXPECT_EQ(now().step(), 0);
}

TEST_F(ShellHand, SpacePlaysAndPausesAndTheButtonSaysWhichItWillDo) {
  create();
  hand.shortcut(' ', false);
  app.runner().wait_for_commands();
  hand.frames(2);
  EXPECT_EQ(now().activity, Activity::running);
  EXPECT_FALSE(hand.place("RUN/step").enabled);
  hand.shortcut(' ', false);
  settle();
  EXPECT_EQ(now().activity, Activity::paused);
  EXPECT_TRUE(hand.place("RUN/step").enabled);
}

TEST_F(ShellHand, TheSpeedSliderLimitsTheSpeed) {
  create();
  hand.drag("RUN/speed", {0.95f, 0.5f}, {0.02f, 0.5f});
  settle();
  EXPECT_EQ(now().speed_limit, 1);
  hand.drag("RUN/speed", {0.05f, 0.5f}, {0.99f, 0.5f});
  settle();
  EXPECT_EQ(now().speed_limit, 0);
}

TEST_F(ShellHand, KeysDoNothingWhileOneTypes) {
  create();
  hand.click("steps to run");
  hand.shortcut('.', false);
  settle();
  EXPECT_EQ(now().step(), 0);
}

TEST_F(ShellHand, MenusOpenDialogsAndEscapeClosesThem) {
  create();
  hand.click("menu File");
  hand.click("menu File/Export\u2026");
  EXPECT_TRUE(shell->is_open("EXPORT"));
  hand.frames(3);
  hand.key(ui::keys::escape);
  EXPECT_FALSE(shell->is_open("EXPORT"));
  hand.key(ui::keys::function + 1);
  EXPECT_TRUE(shell->is_open("KEYS"));
  hand.click("RUN/step");  // the keyboard is elsewhere now
  hand.key(ui::keys::escape);
  EXPECT_FALSE(shell->is_open("KEYS"));
}

TEST_F(ShellHand, TheMenusReachTheViewModel) {
  create();
  hand.click("menu Run");
  hand.click("menu Run/One step");
  settle();
  EXPECT_EQ(now().step(), 1);
  const bool dark = app.settings().dark;
  hand.click("menu View");
  hand.click("menu View/Dark");
  EXPECT_NE(app.settings().dark, dark);
  hand.click("menu File");
  hand.click("menu File/Quit");
  EXPECT_TRUE(shell->is_open("UNSAVED")) << "this setup is in no file";
  hand.click("WITHOUT SAVING");
  EXPECT_TRUE(host.closed);
}

TEST_F(ShellHand, WithEverythingInAFileItQuitsAtOnce) {
  write_config(folder / "mine.json", small_config());
  ASSERT_TRUE(app.open(folder / "mine.json"));
  settle();
  hand.shortcut('Q');
  EXPECT_TRUE(host.closed);
}

TEST_F(ShellHand, QuittingWithAnUnsavedSetupAsksFirst) {
  write_config(folder / "mine.json", small_config());
  ASSERT_TRUE(app.open(folder / "mine.json"));
  settle();
  app.setup().set_title("changed");
  shell->quit();
  hand.frames(3);
  EXPECT_FALSE(host.closed);
  hand.click("UNSAVED/CANCEL");
  EXPECT_FALSE(shell->is_open("UNSAVED"));
  EXPECT_FALSE(host.closed);
  hand.shortcut('Q');
  hand.frames(3);
  hand.key(ui::keys::escape);
  EXPECT_FALSE(host.closed);
  hand.shortcut('Q');
  hand.frames(3);
  hand.click("UNSAVED/SAVE");
  hand.frames(3);
  EXPECT_TRUE(host.closed);
  EXPECT_EQ(read_config(folder / "mine.json").title, "changed");
}

TEST_F(ShellHand, AnUnsavedSetupWithoutAFileAsksForOne) {
  app.settings().last_folder = folder.path().string();
  create();
  shell->quit();
  hand.frames(3);
  hand.click("UNSAVED/SAVE");
  hand.frames(3);
  EXPECT_FALSE(host.closed);
  hand.enter("SAVE THE SETUP/name", "new");
  hand.frames(3);
  EXPECT_TRUE(host.closed);
  EXPECT_EQ(read_config(folder / "new.json"), small_config());
}

TEST_F(ShellHand, CreatingOverAPaintedTerrainAsksFirst) {
  app.settings().last_folder = folder.path().string();
  create();
  app.runner().paint(0, {.x = 10.5, .y = 10.5, .radius = 3, .amount = 9}, 1);
  settle();
  const std::uint64_t painted = state_hash(*now().runs[0].terrain);
  hand.shortcut('N');
  settle();
  EXPECT_EQ(state_hash(*now().runs[0].terrain), painted);
  hand.click("UNSAVED/SAVE");
  hand.frames(3);
  hand.enter("SAVE THE LAND/name", "painted");
  constexpr int patience = 2000;
  for (int frame = 0; frame < patience && shell->is_open("UNSAVED"); ++frame) hand.frames();
  settle();
  EXPECT_NE(state_hash(*now().runs[0].terrain), painted);
  EXPECT_EQ(state_hash(io::read_checkpoint(folder / "painted.checkpoint").state.terrain), painted);
}

TEST_F(ShellHand, TheLookPanelChangesTheLook) {
  create();
  hand.click("LOOK/show");
  hand.click("show=slope");
  EXPECT_EQ(shell->view_state().look.show, "slope");
  hand.click("LOOK/palette");
  hand.click("palette=cividis");
  EXPECT_EQ(shell->view_state().look.palette, "cividis");
  hand.click("palette reset");
  EXPECT_EQ(shell->view_state().look.palette, "");
  hand.click("LOOK/raw cells");
  EXPECT_TRUE(shell->view_state().look.raw_cells);
  // A quarter to the east of the dial's middle: the sun in the east, half way up.
  const WidgetPlace dial = hand.place("sun dial");
  const float radius = 0.45f * (dial.high.x - dial.low.x);
  hand.click(ImVec2(dial.middle().x + 0.5f * radius, dial.middle().y));
  EXPECT_NEAR(shell->view_state().look.sun_bearing, 90, 2);
  EXPECT_NEAR(shell->view_state().look.sun_altitude, 45, 2);
}

TEST_F(ShellHand, TheFluxIsCountedOnlyWhileItIsShown) {
  create();
  EXPECT_EQ(now().runs.front().flux, nullptr);
  hand.click("LOOK/show");
  hand.click("show=flux");
  settle();
  ASSERT_NE(now().runs.front().flux, nullptr);
  app.runner().step();
  settle();
  double sum = 0;
  for (const float value : now().runs.front().flux->values.cells()) sum += value;
  EXPECT_NEAR(sum, static_cast<double>(now().runs.front().totals.lifts), 1e-3 * sum);
  hand.click("LOOK/show");
  hand.click("show=material");
  settle();
  EXPECT_EQ(now().runs.front().flux, nullptr);
}

TEST_F(ShellHand, TheWindShadowIsAskedForOnlyWhileItIsShown) {
  create();
  EXPECT_EQ(now().runs.front().shadow, nullptr);
  hand.click("LOOK/show");
  hand.click("show=wind shadow");
  settle();
  EXPECT_NE(now().runs.front().shadow, nullptr);
}

TEST_F(ShellHand, AViewIsKeptAndComesBack) {
  create();
  hand.click("LOOK/Top");
  const Camera kept = shell->view_state().camera.camera();
  EXPECT_TRUE(kept.orthographic);
  hand.click("LOOK/Keep view");
  hand.click("LOOK/Side");
  EXPECT_FALSE(shell->view_state().camera.camera() == kept);
  hand.click("view 1/view 1");
  EXPECT_TRUE(shell->view_state().camera.camera() == kept);
  EXPECT_EQ(read_camera(folder / "settings/views/view 1.json"), kept);
}

TEST_F(ShellHand, AViewIsKeptUnderItsNameReplacedAndForgotten) {
  create();
  hand.click("LOOK/Top");
  const std::filesystem::path file = folder / "settings/views/lee-side.json";
  const auto keep = [&] {
    hand.click("view name");
    hand.type("lee/side");
    hand.click("LOOK/Keep view");
  };
  keep();
  EXPECT_TRUE(read_camera(file).orthographic);
  hand.click("LOOK/Side");
  keep();
  EXPECT_EQ(read_camera(file), shell->view_state().camera.camera());
  EXPECT_EQ(ui::Bookmarks(folder / "settings/views").entries().size(), 1u) << "the next start finds it";
  hand.click("LOOK/Block");
  hand.click("lee-side/lee-side");
  EXPECT_EQ(shell->view_state().camera.camera(), read_camera(file));
  hand.click("lee-side/remove");
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_FALSE(hand.has("lee-side/lee-side"));
}

TEST_F(ShellHand, TheMouseTurnsShiftsAndNearsTheTerrain) {
  create();
  hand.shortcut('3', false);
  const Camera before = shell->view_state().camera.camera();
  const ImVec2 middle = hand.place("terrain").middle();
  hand.drag(middle, ImVec2(middle.x + 80, middle.y));
  const Camera turned = shell->view_state().camera.camera();
  EXPECT_NE(turned.bearing, before.bearing);
  EXPECT_EQ(turned.target, before.target);
  hand.scroll(2);
  EXPECT_LT(shell->view_state().camera.camera().distance, turned.distance);
  hand.move(middle);
  hand.press(1);
  hand.move(ImVec2(middle.x + 60, middle.y + 10));
  hand.release(1);
  EXPECT_NE(shell->view_state().camera.camera().target, turned.target);
  EXPECT_EQ(shell->view_state().camera.camera().bearing, turned.bearing);
}

TEST_F(ShellHand, TheTerrainUnderThePointerIsRead) {
  create();
  hand.shortcut('1', false);
  EXPECT_FALSE(hand.has("LAND/reading"));
  hand.move(hand.place("terrain").middle());
  hand.frames(2);
  EXPECT_TRUE(hand.has("LAND/reading"));
}

TEST_F(ShellHand, APictureIsOrderedInTheSizeChosen) {
  create();
  hand.key(ui::keys::function + 12);
  hand.frames(3);
  hand.enter("PICTURE/width", "640");
  hand.enter("PICTURE/height", "360");
  hand.click("PICTURE/transparent");
  hand.click("PICTURE/save picture");
  hand.frames(3);
  hand.click("SAVE");
  hand.frames(6);
  ASSERT_EQ(host.orders.size(), 1u);
  EXPECT_EQ(host.orders[0].size.width, 640);
  EXPECT_EQ(host.orders[0].size.height, 360);
  EXPECT_TRUE(host.orders[0].transparent);
}

TEST_F(ShellHand, APictureThatTheMemoryDoesNotHoldIsSaidInWords) {
  create();
  host.has_memory = false;
  hand.key(ui::keys::function + 12);
  hand.frames(3);
  hand.click("PICTURE/save picture");
  hand.frames(3);
  hand.click("SAVE");
  hand.frames(6);
  EXPECT_TRUE(host.orders.empty());
  EXPECT_NE(app.log().text().find(": there is not enough memory"), std::string::npos) << app.log().text();
}

TEST_F(ShellHand, PanelsFoldAndColumnsAreDraggedAndBothAreRemembered) {
  create();
  hand.click("SETUP/fold");
  EXPECT_EQ(app.settings().layout.at("fold SETUP"), 0);
  const WidgetPlace edge = hand.place("edge left");
  hand.drag(edge.middle(), ImVec2(edge.middle().x + 60, edge.middle().y));
  EXPECT_NEAR(app.settings().layout.at("left width"), 390, 6);
  EXPECT_NEAR(hand.place("terrain").low.x, 390, 8);
  hand.key(ui::keys::function + 2);
  EXPECT_FALSE(hand.has("edge left"));
  EXPECT_EQ(hand.place("terrain").low.x, 0);
}

TEST_F(ShellHand, TheStatusSaysThatNoMassIsLost) {
  create();
  EXPECT_TRUE(hand.has("STATUS/drift"));
  EXPECT_TRUE(hand.has("STATUS/executor"));
  hand.click("STATUS/log");
  EXPECT_TRUE(shell->is_open("LOG"));
}

}  // namespace
}  // namespace erg::test
