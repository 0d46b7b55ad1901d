// The small widgets, by hand.
#include <gtest/gtest.h>

#include "harness.h"
#include "ui/widgets/widgets.h"

namespace erg::test {

using ui::button;
using ui::parameter_row;
using ui::RowEvent;

namespace {

// One window with these rows in it.
UiHarness in_a_window(std::function<void()> rows) {
  return UiHarness([rows = std::move(rows)] {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({320, 600});
    ImGui::Begin("window");
    {
      const ui::WidgetScope scope("PANEL");
      rows();
    }
    ImGui::End();
  });
}

TEST(Widgets, ASliderFollowsTheMouseAndTakesTypedNumbersWithinItsRange) {
  double value = 0.5;
  RowEvent last = RowEvent::none;
  UiHarness hand = in_a_window([&] {
    const RowEvent event = ui::real_row({.label = "landing chance"}, value, 0, 1);
    if (event != RowEvent::none) last = event;
  });
  hand.drag("PANEL/landing chance", {0.5f, 0.5f}, {0.95f, 0.5f});
  EXPECT_GT(value, 0.9);
  EXPECT_EQ(last, RowEvent::changed);
  hand.enter("landing chance", "0.25");
  EXPECT_DOUBLE_EQ(value, 0.25);
  hand.enter("landing chance", "7");
  EXPECT_DOUBLE_EQ(value, 1);
}

TEST(Widgets, AParameterIsResetToItsDefaultByItsDot) {
  const Parameter declared{.key = "hop",
                           .label = "hop length",
                           .unit = "cells",
                           .default_value = 5,
                           .minimum = 1,
                           .maximum = 100,
                           .meaning = "How far a slab hops."};
  ParameterValue value = std::int64_t{5};
  UiHarness hand = in_a_window([&] { parameter_row(declared, value); });
  EXPECT_FALSE(hand.has("hop length reset"));
  hand.enter("hop length", "42");
  EXPECT_EQ(std::get<std::int64_t>(value), 42);
  hand.click("hop length reset");
  EXPECT_EQ(std::get<std::int64_t>(value), 5);
  EXPECT_FALSE(hand.has("hop length reset"));
}

TEST(Widgets, AChoiceIsMadeFromItsList) {
  const Parameter declared{.key = "kind",
                           .label = "scene",
                           .default_value = "flat",
                           .choices = {"flat", "random", "rocks"},
                           .meaning = "What lies there."};
  ParameterValue value = std::string("flat");
  UiHarness hand = in_a_window([&] { parameter_row(declared, value); });
  hand.click("scene");
  hand.click("scene=rocks");
  EXPECT_EQ(std::get<std::string>(value), "rocks");
}

TEST(Widgets, WhatIsUnavailableCannotBeChangedOrPressed) {
  bool value = false;
  int pressed = 0;
  UiHarness hand = in_a_window([&] {
    ui::switch_row({.label = "open", .unavailable = "It is running."}, value);
    pressed += button("CREATE", {.unavailable = "Nothing has changed."}) ? 1 : 0;
    pressed += button("GROW") ? 100 : 0;
  });
  hand.click("open");
  hand.click("CREATE");
  EXPECT_FALSE(value);
  EXPECT_EQ(pressed, 0);
  EXPECT_FALSE(hand.place("CREATE").enabled);
  hand.click("GROW");
  EXPECT_EQ(pressed, 100);
}

TEST(Widgets, TextChangesWithEveryLetter) {
  std::string value = "old";
  UiHarness hand = in_a_window([&] { ui::text_row({.label = "title"}, value); });
  hand.click("title");
  hand.shortcut('A');
  hand.type("star dune");
  EXPECT_EQ(value, "star dune");
}

}  // namespace
}  // namespace erg::test
