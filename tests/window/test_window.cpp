// The program as a person has it: a window, a mouse, a keyboard. With ERG_PICTURES=FOLDER in the environment, what the
// screen shows on the way is kept there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "../render/scene.h"
#include "../unit/temporary_folder.h"
#include "desktop_hand.h"
#include "io/config/config_file.h"
#include "io/formats/camera_file.h"

// Last: its macros are plain words.
#include <X11/Xlib.h>
#include <X11/extensions/Xrandr.h>

namespace erg::test {

using io::read_config;

namespace {

void keep_picture(const DesktopHand& hand, const std::string& name) {
  if (const char* const folder = std::getenv("ERG_PICTURES")) hand.picture(std::filesystem::path(folder) / name);
}

std::ptrdiff_t saved_sessions(const TemporaryFolder& folder) {
  const std::filesystem::recursive_directory_iterator all(folder / "state");
  return std::count_if(begin(all), end(all), [](const auto& file) { return file.path().filename() == "session.json"; });
}

/// Saves a picture of 320 x 200 pixels under the name proposed; its dialog stays open.
void save_small_picture(const DesktopHand& hand) {
  hand.key("F12");
  hand.enter("PICTURE/width", "320");
  hand.enter("PICTURE/height", "200");
  hand.click("PICTURE/save picture");
  hand.click("PICTURE/SAVE PICTURE/SAVE");
  hand.wait_for("PICTURE/saved", true);
}

TEST(Window, APresetIsOpenedGrownChangedSavedAndDrawn) {
  const TemporaryFolder folder;
  const Display display;
  DesktopHand hand(display, folder.path(), {"--width", "1000", "--height", "760"});
  hand.click("GALLERY/barchans");
  hand.wait_for("RUN/play");
  hand.click("SETUP/Model");  // folded away, so that the grid is in sight
  hand.key("space");
  hand.wait_for("RUN/step");

  hand.enter("SETUP/grid/Cells east", "96");
  hand.enter("SETUP/grid/Cells north", "96");
  hand.click("SETUP/CREATE");
  hand.enter("RUN/steps to run", "200");
  hand.click("RUN/run");
  hand.wait_for("RUN/step");
  keep_picture(hand, "window.png");

  hand.click("SETUP/fold");
  hand.click("WIND/SEASONS");
  hand.enter("WIND/last strength", "9");
  hand.enter("WIND/length", "100");
  hand.drag("WIND/curve/first", 20, -30);
  keep_picture(hand, "curve.png");
  hand.click("LOOK/show");
  hand.click("LOOK/show=slope");
  hand.key("ctrl+s");
  hand.enter("SAVE AS/name", (folder / "mine").string());
  hand.wait_for_file(folder / "mine.json");
  const sim::Config saved = read_config(folder / "mine.json");
  EXPECT_EQ(saved.grid.integer("nx"), 96);
  EXPECT_FALSE(saved.wind.intervals.front().curve == BezierCurve{});

  hand.wait_for("RUN/step");  // the 200 steps are done
  save_small_picture(hand);
  keep_picture(hand, "picture_dialog.png");
  hand.key("Escape");

  hand.enter("WIND/last strength", "7");
  hand.key("ctrl+q");
  hand.wait_for("UNSAVED/SAVE");
  keep_picture(hand, "unsaved_question.png");
  hand.click("UNSAVED/CANCEL");
  hand.key("ctrl+o");
  hand.click("OPEN/files/mine.json");
  hand.click("OPEN/OPEN");
  hand.click("UNSAVED/WITHOUT SAVING");
  hand.wait_for("RUN/play");
  hand.key("ctrl+q");
  EXPECT_EQ(hand.wait(), 0) << hand.errors();
  // The name carries the step that it shows.
  EXPECT_EQ(read_bytes(folder / "mine-200.png").substr(1, 3), "PNG");
  EXPECT_TRUE(std::filesystem::exists(folder / "config" / "erg" / "settings.json"));
}

TEST(Window, DrawsTheTerrainAsTheOffscreenContextsDo) {
  const TemporaryFolder folder;
  const Display display;
  const std::string config = write_small_terrain(folder.path());
  DesktopHand hand(display, folder.path(), {config});
  hand.wait_for("RUN/step");
  hand.enter("RUN/steps to run", "40");
  hand.click("RUN/run");
  hand.wait_for("RUN/step");
  hand.click("LOOK/Keep view");
  save_small_picture(hand);
  keep_picture(hand, "window_and_picture.png");
  const picture::RgbImage in_window = read_picture(folder / "small-40.png");
  ASSERT_EQ(in_window.width, 320);

  const std::filesystem::path view = folder / "config" / "erg" / "views" / "view 1.json";
  for (const std::string context : {"osmesa", "egl"}) {
    if (context == "osmesa" && !render::has_osmesa()) continue;
    const std::filesystem::path file = folder / (context + ".png");
    const std::string command = std::string("'") + ERG_PROGRAM + "' render '" + config + "' --steps 40 --camera '" +
                                view.string() + "' --copies 0 --size 320x200 --quiet --context " + context +
                                " --out '" + file.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const Difference apart = difference(in_window, read_picture(file));
    EXPECT_LT(apart.mean, 0.5) << context;
    EXPECT_LT(apart.largest, 12) << context;
  }
}

TEST(Window, ALostDisplayAndASignalEndTheProgramWithTheTerrainSaved) {
  const TemporaryFolder folder;
  Display display;
  DesktopHand hand(display, folder.path(), {write_small_terrain(folder.path())});
  hand.wait_for("RUN/step");
  hand.click("RUN/step");
  display.kill();
  EXPECT_EQ(hand.wait(), 1);
  EXPECT_NE(hand.errors().find("the display is gone"), std::string::npos) << hand.errors();

  // What was saved is offered at the next start.
  const Display next;
  DesktopHand again(next, folder.path(), {});
  again.wait_for("RECOVERY/session 1/RECOVER");
  keep_picture(again, "recovery.png");
  again.click("RECOVERY/session 1/RECOVER");
  again.wait_for("RUN/step");
  again.terminate();
  EXPECT_EQ(again.wait(), 0);
  EXPECT_NE(again.errors().find("the next start offers"), std::string::npos) << again.errors();
  EXPECT_EQ(saved_sessions(folder), 1) << "the new one instead of the old";
}

/// Asks for the copied text and is gone before the answer.
void ask_for_the_clipboard_and_go(const std::string& display_name) {
  ::Display* const display = XOpenDisplay(display_name.c_str());
  ASSERT_NE(display, nullptr);
  const ::Window asker = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
  const Atom clipboard = XInternAtom(display, "CLIPBOARD", False);
  EXPECT_NE(XGetSelectionOwner(display, clipboard), None) << "nothing was copied";
  XConvertSelection(display, clipboard, XInternAtom(display, "UTF8_STRING", False), clipboard, asker, CurrentTime);
  XDestroyWindow(display, asker);
  XCloseDisplay(display);
}

TEST(Window, AProgramThatAsksForTheCopiedTextAndGoesDoesNoHarm) {
  const TemporaryFolder folder;
  const Display display;
  DesktopHand hand(display, folder.path(), {write_small_terrain(folder.path())});
  hand.wait_for("RUN/step");
  hand.edit("RUN/steps to run");
  hand.key("ctrl+c");
  ask_for_the_clipboard_and_go(display.name());
  hand.key("Escape");
  hand.click("RUN/step");
  hand.key("ctrl+q");
  EXPECT_EQ(hand.wait(), 0) << hand.errors();
}

/// The window over a small terrain.
struct SmallTerrain : testing::Test {
  const TemporaryFolder folder;
  const Display display;
  DesktopHand hand{display, folder.path(), {write_small_terrain(folder.path())}};
  void SetUp() override { hand.wait_for("RUN/step"); }
};

/// Switches the keyboard of a display to another country's.
void use_keyboard(const Display& display, const std::string& country) {
  const std::string command = "DISPLAY=" + display.name() + " setxkbmap " + country;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

TEST_F(SmallTerrain, ShortcutsWorkOnKeyboardsOfOtherCountries) {
  // By the key's number: 32 is O, 10 the 1; 37 is Ctrl.
  use_keyboard(display, "ru");
  hand.raw("keydown 37 key 32 keyup 37");
  hand.wait_for("OPEN/CANCEL");
  hand.key("Escape");
  use_keyboard(display, "fr");
  hand.raw("key 10");
  hand.click("LOOK/Keep view");
  EXPECT_TRUE(io::read_camera(folder / "config" / "erg" / "views" / "view 1.json").orthographic)
      << "1 is the view from above";
  hand.raw("keydown 37 key 24 keyup 37");  // A, where Q lies elsewhere: no shortcut
  EXPECT_TRUE(hand.runs());
  hand.raw("keydown 37 key 38 keyup 37");  // Q
  EXPECT_EQ(hand.wait(), 0) << hand.errors();
}

TEST_F(SmallTerrain, DeadKeysAndOtherScriptsAreTyped) {
  use_keyboard(display, "fr");
  hand.click("LOOK/view name");
  hand.raw("key d key dead_circumflex key e");
  hand.click("LOOK/Keep view");
  hand.wait_for_file(folder / "config" / "erg" / "views" / "d\u00ea.json");
  use_keyboard(display, "ru");
  hand.click("LOOK/view name");
  hand.raw("key 42 key 32 key 31");
  hand.click("LOOK/Keep view");
  hand.wait_for_file(folder / "config" / "erg" / "views" / "\u043f\u0449\u0448.json");
}

TEST_F(SmallTerrain, ADecimalCommaIsADecimalPoint) {
  hand.click("SETUP/fold");  // so that WIND is in sight
  hand.enter("WIND/strength", "2,5");
  hand.key("ctrl+s");
  hand.wait_for_file(folder / "small.json");
  hand.key("ctrl+q");
  EXPECT_EQ(hand.wait(), 0) << hand.errors();
  EXPECT_EQ(read_config(folder / "small.json").wind.intervals.front().first, 2.5);
}

/// Makes two monitors of a screen, side by side: a usual one and one with twice as many pixels an inch.
void split_screen(const std::string& display_name) {
  ::Display* const display = XOpenDisplay(display_name.c_str());
  ASSERT_NE(display, nullptr);
  const auto add = [&](const char* name, int left, int height, bool primary) {
    XRRMonitorInfo* const monitor = XRRAllocateMonitor(display, 0);
    monitor->name = XInternAtom(display, name, False);
    monitor->primary = primary ? True : False;
    monitor->x = left;
    monitor->width = 1200;
    monitor->height = height;
    monitor->mheight = 286;
    XRRSetMonitor(display, DefaultRootWindow(display), monitor);
    XRRFreeMonitors(monitor);
  };
  add("usual", 0, 1080, true);
  add("dense", 1200, 2160, false);
  XCloseDisplay(display);
}

TEST(Window, IsAsLargeAsSuitsTheMonitorThatItIsMovedTo) {
  const TemporaryFolder folder;
  const Display display("2400x2160x24");
  split_screen(display.name());
  DesktopHand hand(display, folder.path(), {write_small_terrain(folder.path()), "--width", "1000", "--height", "760"});
  hand.wait_for("RUN/step");
  const auto letters_are = [&](const std::string& place, double times, double usual) {
    hand.move_window(place);
    return hand.comes_true([&] { return std::abs(hand.height("menu File") / usual - times) < 0.1; });
  };
  const double usual = hand.height("menu File");
  EXPECT_TRUE(letters_are("1300 0", 2, usual)) << hand.height("menu File") << " pixels, and before " << usual;
  EXPECT_TRUE(letters_are("650 20", 1, usual)) << "its middle is on the usual one again";
}

TEST(Window, WithoutAFolderForSessionsThatIsSaidAtOnce) {
  const TemporaryFolder folder;
  const Display display;
  DesktopHand hand(display, folder.path(), {write_small_terrain(folder.path())},
                   {{"XDG_STATE_HOME", ""}, {"XDG_CONFIG_HOME", ""}, {"HOME", ""}});
  hand.wait_for("RUN/step");
  EXPECT_NE(hand.errors().find("nothing is saved by itself"), std::string::npos) << hand.errors();
  hand.terminate();
  EXPECT_EQ(hand.wait(), 0);
  EXPECT_NE(hand.errors().find("the runs are lost"), std::string::npos) << hand.errors();
}

TEST(Window, AnOpenGLThatIsTooOldIsSaidAndNothingHappens) {
  const TemporaryFolder folder;
  const Display display;
  DesktopHand hand(display, folder.path(), {write_small_terrain(folder.path())},
                   {{"MESA_GL_VERSION_OVERRIDE", "2.1"}, {"MESA_GLSL_VERSION_OVERRIDE", "120"}});
  EXPECT_EQ(hand.wait(), 1);
  EXPECT_NE(hand.errors().find("OpenGL version 3.3 is needed"), std::string::npos) << hand.errors();
}

}  // namespace
}  // namespace erg::test
