// The wind's dial and its typed bearing.
#include <gtest/gtest.h>

#include "in_a_column.h"
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

}  // namespace
}  // namespace erg::test
