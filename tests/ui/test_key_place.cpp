// Shortcuts on the keyboards of other countries. Symbols are written as X's headers have them.
#include <gtest/gtest.h>

#include "ui/widgets/gui.h"
#include "ui/window/key_place.h"

// Last: its macros are plain words.
#include <X11/keysym.h>

namespace erg::test {
namespace {

int place(unsigned long symbol, unsigned long plain, unsigned long shifted, const char* position = "",
          unsigned long latin = 0) {
  return ui::key_place({symbol, plain, shifted, latin, position});
}

TEST(KeyPlace, LettersAreThoseOnTheKeys) {
  EXPECT_EQ(place('z', 'z', 'Z', "AB01"), 'Z');
  EXPECT_EQ(place('z', 'z', 'Z', "AD06"), 'Z') << "German: undo is where Z is written";
  EXPECT_EQ(place('Q', 'q', 'Q', "AC01"), 'Q') << "French, with Shift";
}

TEST(KeyPlace, LettersOfOtherScriptsAreThoseOfTheirPlace) {
  EXPECT_EQ(place(XK_Cyrillic_shcha, XK_Cyrillic_shcha, XK_Cyrillic_SHCHA, "AD09"), 'O');
  EXPECT_EQ(place(XK_Cyrillic_ya, XK_Cyrillic_ya, XK_Cyrillic_YA, "AB01"), 'Z');
  EXPECT_EQ(place(XK_Greek_sigma, XK_Greek_sigma, XK_Greek_SIGMA, "AC02"), 'S');
  EXPECT_EQ(place(XK_hebrew_qoph, XK_hebrew_qoph, 0, "AD03"), 'E');
  EXPECT_EQ(place(XK_Cyrillic_yu, XK_Cyrillic_yu, XK_Cyrillic_YU, "AB09"), '.') << "one step";
  EXPECT_EQ(place(XK_Cyrillic_ya, XK_Cyrillic_ya, XK_Cyrillic_YA, "AB01", 'y'), 'Y') << "the German second layout";
}

TEST(KeyPlace, DigitsCountWithoutShift) {
  EXPECT_EQ(place('&', '&', '1', "AE01"), '1') << "French";
  EXPECT_EQ(place(XK_eacute, XK_eacute, '2', "AE02"), '2');
  EXPECT_EQ(place(XK_ecaron, XK_ecaron, '2', "AE02"), '2') << "Czech";
  EXPECT_EQ(place('!', '1', '!', "AE01"), '1') << "American, with Shift";
  EXPECT_EQ(place(XK_KP_4, XK_KP_Left, XK_KP_4), '4');
}

TEST(KeyPlace, WhatIsWrittenWithShiftCountsAsWritten) {
  EXPECT_EQ(place('.', ';', '.', "AB08"), '.') << "French full stop";
  EXPECT_EQ(place('+', '=', '+', "AE12"), '+');
  EXPECT_EQ(place('-', '-', '6', "AE06"), '-') << "the French 6 is a minus too";
  EXPECT_EQ(place(XK_KP_Add, XK_KP_Add, XK_KP_Add), '+');
  EXPECT_EQ(place(XK_KP_Separator, XK_KP_Delete, XK_KP_Separator), '.') << "the German keypad's comma";
}

TEST(KeyPlace, KeysThatWriteNothingHaveTheirPlaces) {
  EXPECT_EQ(place(XK_Escape, XK_Escape, 0), ui::keys::escape);
  EXPECT_EQ(place(XK_KP_Enter, XK_KP_Enter, 0), ui::keys::enter);
  EXPECT_EQ(place(XK_ISO_Left_Tab, XK_Tab, XK_ISO_Left_Tab), ui::keys::tab);
  EXPECT_EQ(place(XK_F12, XK_F12, 0), ui::keys::function + 12);
  EXPECT_EQ(place(XK_KP_Left, XK_KP_Left, XK_KP_4), ui::keys::left) << "without Num Lock";
  EXPECT_EQ(place(XK_Shift_L, XK_Shift_L, 0, "LFSH"), -1);
  EXPECT_EQ(place(XK_odiaeresis, XK_odiaeresis, XK_Odiaeresis, "AC10"), -1) << "no shortcut lies there";
}

}  // namespace
}  // namespace erg::test
