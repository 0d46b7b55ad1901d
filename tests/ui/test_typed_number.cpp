// Numbers as people of every country type and paste them.
#include <gtest/gtest.h>

#include "harness.h"
#include "ui/widgets/typed_number.h"
#include "ui/widgets/widgets.h"

namespace erg::test {

using ui::as_pasted_number;
using ui::as_typed_in_number;
using ui::real_row;

namespace {

TEST(TypedNumber, MarksAndDigitsOfEveryScriptAreRead) {
  EXPECT_EQ(as_typed_in_number(U','), U'.');
  EXPECT_EQ(as_typed_in_number(0x66b), U'.') << "Arabic";
  EXPECT_EQ(as_typed_in_number(0xff0e), U'.') << "full-width";
  EXPECT_EQ(as_typed_in_number(0x2212), U'-');
  EXPECT_EQ(as_typed_in_number(0x663), U'3') << "Arabic";
  EXPECT_EQ(as_typed_in_number(0xff17), U'7') << "full-width";
  EXPECT_EQ(as_typed_in_number(U'e'), U'e');
}

TEST(TypedNumber, PastedNumbersKeepTheirValue) {
  EXPECT_EQ(as_pasted_number("0,25"), "0.25");
  EXPECT_EQ(as_pasted_number("1.234,5"), "1234.5");
  EXPECT_EQ(as_pasted_number("1,234.5"), "1234.5");
  EXPECT_EQ(as_pasted_number("1 234,5"), "1234.5");
  EXPECT_EQ(as_pasted_number("1\u00a0234\u202f567,5"), "1234567.5");
  EXPECT_EQ(as_pasted_number("1,234,567"), "1234567");
  EXPECT_EQ(as_pasted_number("1.234.567"), "1234567");
  EXPECT_EQ(as_pasted_number("1'234.5"), "1234.5");
  EXPECT_EQ(as_pasted_number("\u22122,5e-3"), "-2.5e-3");
}

class NumberFields : public testing::Test {
 protected:
  double sliding = 0.5;
  double typed = 0.5;
  std::int64_t whole = 7;
  std::string text = "";
  UiHarness hand{[this] {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({320, 600});
    ImGui::Begin("window");
    {
      const ui::WidgetScope scope("PANEL");
      real_row({.label = "sliding"}, sliding, 0, 100);
      real_row({.label = "typed"}, typed, 0, 0);
      ui::integer_row({.label = "whole"}, whole, 1, 1000);
      ui::text_row({.label = "text"}, text);
    }
    ImGui::End();
  }};
};

TEST_F(NumberFields, ADecimalCommaIsADecimalPointInEveryOne) {
  hand.enter("sliding", "0,25");
  EXPECT_DOUBLE_EQ(sliding, 0.25);
  hand.enter("typed", "12,5");
  EXPECT_DOUBLE_EQ(typed, 12.5);
  hand.enter("whole", "12,7");
  EXPECT_EQ(whole, 12) << "127 was not meant";
  hand.enter("text", "1,5");
  EXPECT_EQ(text, "1,5") << "words keep their commas";
}

TEST_F(NumberFields, WhatIsPastedIsReadTheSameWay) {
  const auto paste = [&](const char* what) {
    hand.double_click("typed");
    hand.shortcut('A');
    ImGui::SetClipboardText(what);
    hand.shortcut('V');
    hand.key(ui::keys::enter);
  };
  paste("0,75");
  EXPECT_DOUBLE_EQ(typed, 0.75);
  paste("1.234,5");
  EXPECT_DOUBLE_EQ(typed, 1234.5);
}

}  // namespace
}  // namespace erg::test
