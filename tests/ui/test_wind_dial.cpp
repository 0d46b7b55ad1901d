// The wind's dial and its typed bearing.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "in_a_column.h"
#include "picture_of_gui.h"
#include "ui/widgets/wind_dial.h"

namespace erg::test {

using ui::wind_dial;

namespace {

struct DialHand {
  double bearing = 270;
  int changes = 0;
  UiHarness hand = in_a_column([this] {
    changes += wind_dial("dial", bearing, 140) ? 1 : 0;
    changes += ui::type_bearing("bearing", bearing) ? 1 : 0;
  });
};

TEST(WindDial, TurnsToWhereItIsDragged) {
  DialHand dial;
  dial.hand.drag("dial", {0.1f, 0.5f}, {0.5f, 0.05f});
  EXPECT_DOUBLE_EQ(dial.bearing, 0) << "up is north: it blows from there";
  dial.hand.drag("dial", {0.5f, 0.1f}, {0.95f, 0.5f});
  EXPECT_DOUBLE_EQ(dial.bearing, 90);
  dial.hand.drag("dial", {0.9f, 0.5f}, {0.15f, 0.85f});
  EXPECT_DOUBLE_EQ(dial.bearing, 225) << "lower left is southwest";
}

TEST(WindDial, ShiftSnapsToPointsOfTheCompass) {
  DialHand dial;
  hold_shift(true);
  dial.hand.drag("dial", {0.1f, 0.5f}, {0.8f, 0.22f});
  hold_shift(false);
  EXPECT_DOUBLE_EQ(dial.bearing, 45);
}

TEST(WindDial, TheFanOfASpreadDoesNotChangeWhatADragMeans) {
  double bearing = 270;
  UiHarness hand = in_a_column([&] { wind_dial("dial", bearing, 140, 60); });
  hand.drag("dial", {0.1f, 0.5f}, {0.5f, 0.05f});
  EXPECT_DOUBLE_EQ(bearing, 0);
}

TEST(WindDial, BearingsAreTypedInDegreesOrByName) {
  DialHand dial;
  dial.hand.enter("bearing", "123.5");
  EXPECT_DOUBLE_EQ(dial.bearing, 123.5);
  dial.hand.enter("bearing", "nnw");
  EXPECT_DOUBLE_EQ(dial.bearing, 337.5);
  dial.hand.enter("bearing", "-90");
  EXPECT_DOUBLE_EQ(dial.bearing, 270);
}

TEST(WindDial, WhatIsNoBearingChangesNothing) {
  DialHand dial;
  dial.hand.enter("bearing", "upwards");
  EXPECT_DOUBLE_EQ(dial.bearing, 270);
  EXPECT_EQ(dial.changes, 0);
}

TEST(WindDial, ABearingIsNotRoundedByBeingLookedAt) {
  DialHand dial;
  dial.bearing = 123.456789;
  dial.hand.click("bearing");
  dial.hand.key(ImGuiKey_Enter);
  EXPECT_EQ(dial.bearing, 123.456789);
}

/// How many pixels of the rose have the colour of what is filled.
std::ptrdiff_t filled(const std::array<double, 4>& blown, const std::array<double, 4>& coming) {
  UiHarness hand = in_a_column([&] { ui::draw_wind_rose("rose", blown, coming, 140); });
  hand.frames(2);
  const ImVec4& accent = hand.gui().theme().accent;
  const picture::RgbImage drawn = picture_of_gui(hand.gui(), ImGui::GetIO().DisplaySize);
  std::ptrdiff_t count = 0;
  for (int y = 0; y < 140; ++y) {
    for (int x = 0; x < 140; ++x) {
      const auto is = [&](int part, float wanted) { return std::abs(drawn.pixel(x, y)[part] - 255 * wanted) < 60; };
      count += is(0, accent.x) && is(1, accent.y) && is(2, accent.z);
    }
  }
  return count;
}

TEST(WindRose, WhatHasBlownIsSeenBesideAllThatIsToCome) {
  const std::ptrdiff_t none = filled({}, {900, 0, 0, 0});
  const std::ptrdiff_t alone = filled({1, 0, 0, 0}, {});
  EXPECT_GT(alone, none + 200);
  EXPECT_GT(filled({1, 0, 0, 0}, {0, 0, 900, 0}), none + (alone - none) * 9 / 10) << "a long run has just begun";
}

}  // namespace
}  // namespace erg::test
