// Who gets the keys: the terrain, a dialog, a menu; and what CREATE shows.
#include <gtest/gtest.h>

#include "shell_hand.h"

namespace erg::test {
namespace {

TEST_F(ShellHand, KeysNeverActThroughADialogOrAMenu) {
  create();
  app.runner().step();
  settle();
  for (const char* const dialog : {"KEYS", "SAVE AS", "EXPORT", "PICTURE"}) {
    shell->open(dialog);
    hand.frames(3);
    hand.shortcut('R', false);
    hand.shortcut('.', false);
    hand.shortcut(' ', false);
    settle();
    EXPECT_EQ(now().step(), 1) << dialog;
    EXPECT_EQ(now().activity, session::Activity::paused) << dialog;
    hand.key(ui::keys::escape);
    EXPECT_FALSE(shell->is_open(dialog));
  }
  hand.click("menu Run");
  hand.shortcut('R', false);
  settle();
  EXPECT_EQ(now().step(), 1) << "a menu is open";
  hand.key(ui::keys::escape);
  hand.shortcut('R', false);
  settle();
  EXPECT_EQ(now().step(), 0) << "and now none is";
}

TEST_F(ShellHand, TheTerrainDoesNotFlyWhileADialogIsTypedInto) {
  create();
  const picture::Camera before = shell->view_state().camera.camera();
  shell->open("KEYS");
  hand.frames(3);
  hand.shortcut('W', false);
  EXPECT_EQ(shell->view_state().camera.camera(), before);
  hand.key(ui::keys::escape);
  hand.shortcut('W', false);
  EXPECT_NE(shell->view_state().camera.camera(), before);
}

TEST_F(ShellHand, EscapeClosesMenusAndListsAndTheNextClickCounts) {
  create();
  hand.click("menu File");
  EXPECT_TRUE(hand.has("menu File/Save"));
  hand.key(ui::keys::escape);
  EXPECT_FALSE(hand.has("menu File/Save"));
  hand.click("LOOK/show");
  EXPECT_TRUE(hand.has("LOOK/show=slope"));
  hand.key(ui::keys::escape);
  EXPECT_FALSE(hand.has("LOOK/show=slope"));
  hand.click("RUN/step");
  settle();
  EXPECT_EQ(now().step(), 1) << "the click was not swallowed";
}

TEST_F(ShellHand, AListInADialogClosesBeforeTheDialog) {
  create();
  shell->open("COMPARE");
  hand.frames(3);
  shell->open("KEYS");
  hand.frames(3);
  hand.click("menu Help");
  hand.key(ui::keys::escape);
  EXPECT_FALSE(hand.has("menu Help/Log"));
  EXPECT_TRUE(shell->is_open("KEYS"));
}

TEST_F(ShellHand, CreateShowsTheNewTerrainWhole) {
  create();
  hand.frames(3);
  hand.move(hand.place("terrain").middle());
  hand.scroll(8);
  hand.frames(2);
  const double near = shell->view_state().camera.camera().distance;
  hand.click("SETUP/CREATE");
  settle();
  hand.frames(3);
  EXPECT_GT(shell->view_state().camera.camera().distance, near);
}

}  // namespace
}  // namespace erg::test
