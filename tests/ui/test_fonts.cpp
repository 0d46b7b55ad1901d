// Letters of every script: found, loaded when they are needed, and named where no font has them.
#include <gtest/gtest.h>

#include <filesystem>

#include "harness.h"
#include "picture_of_gui.h"
#include "ui/widgets/fonts.h"

namespace erg::test {

using ui::take_letter;

namespace {

bool has_glyph(UiHarness& hand, char32_t letter) {
  return hand.gui().heading_font()->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr;
}

TEST(Fonts, LettersGoToUtf8AndBack) {
  for (const char32_t letter : {U'a', U'\u00e9', U'\u0416', U'\u4e2d', U'\U0001f3dc'}) {
    const std::string bytes = ui::utf8_of(letter);
    std::string_view rest = bytes;
    EXPECT_EQ(take_letter(rest), letter);
    EXPECT_TRUE(rest.empty());
  }
  for (const std::string damaged : {"\xff", "\xc3", "\xe4\xb8", "\x80"}) {
    std::string_view rest = damaged;
    EXPECT_EQ(take_letter(rest), 0xfffdu);
  }
}

TEST(Fonts, AFontIsFoundForTheInterfaceAndForALetter) {
  ui::FontFinder finder;
  const auto plain = finder.interface_font();
  ASSERT_TRUE(plain.has_value());
  EXPECT_TRUE(std::filesystem::is_regular_file(plain->path)) << plain->path;
  const auto cyrillic = finder.font_with(U'\u0416');
  ASSERT_TRUE(cyrillic.has_value());
  EXPECT_TRUE(std::filesystem::is_regular_file(cyrillic->path)) << cyrillic->path;
  EXPECT_EQ(finder.font_with(0xfdd0), std::nullopt) << "which is no letter";
}

TEST(Fonts, CyrillicAndGreekAreThereAtOnce) {
  UiHarness hand([] {});
  for (const char32_t letter : {U'\u0416', U'\u0451', U'\u03a9', U'\u0159'}) {
    EXPECT_TRUE(has_glyph(hand, letter)) << static_cast<unsigned>(letter);
  }
}

TEST(Fonts, ALetterIsLoadedWhenItIsNeeded) {
  constexpr char32_t armenian = 0x531;  // DejaVu Sans has it, and the interface does not load it by itself
  UiHarness hand([] {});
  const int version = hand.gui().font_version();
  EXPECT_FALSE(has_glyph(hand, armenian));
  hand.gui().need("\u0531");
  hand.frames();
  EXPECT_TRUE(has_glyph(hand, armenian));
  EXPECT_GT(hand.gui().font_version(), version) << "the texture is to be uploaded anew";
  const int loaded = hand.gui().font_version();
  hand.gui().need("\u0531");
  hand.frames();
  EXPECT_EQ(hand.gui().font_version(), loaded) << "once";
  hand.gui().set_scale(2);
  EXPECT_TRUE(has_glyph(hand, armenian)) << "in every size";
}

TEST(Fonts, EveryRendererDrawsTheSameLetters) {
  std::string words = "Werner 1995";
  UiHarness hand([&] { ImGui::GetForegroundDrawList()->AddText({20, 20}, 0xffffffff, words.c_str()); });
  const auto picture = [&] {
    hand.frames();
    return picture_of_gui(hand.gui(), ImGui::GetIO().DisplaySize).pixels;
  };
  const auto first = picture();
  EXPECT_EQ(picture(), first);
  words = "Momiji 2000";
  EXPECT_NE(picture(), first) << "which shows letters at all";
}

TEST(Fonts, ALetterThatNoFontHasIsNamedOnce) {
  UiHarness hand([] {});
  hand.gui().need("\uFDD0");
  hand.frames();
  EXPECT_NE(hand.gui().take_missing_letters().find("U+FDD0"), std::string::npos);
  hand.gui().need("\uFDD0");
  hand.frames();
  EXPECT_EQ(hand.gui().take_missing_letters(), "");
}

}  // namespace
}  // namespace erg::test
