#include "forcing/bearing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/errors.h"

namespace erg {

using forcing::bearing_of;
using forcing::compass_name;
using forcing::Direction;
using forcing::downwind;
using forcing::parse_bearing;

namespace {

TEST(Bearing, AxisWindsAreExact) {
  const auto expect = [](double bearing, double x, double y) {
    EXPECT_EQ(downwind(bearing).x, x) << bearing;
    EXPECT_EQ(downwind(bearing).y, y) << bearing;
  };
  expect(270, 1, 0);
  expect(180, 0, 1);
  expect(90, -1, 0);
  expect(0, 0, -1);
  expect(-90, 1, 0);
  expect(360, 0, -1);
  expect(225, std::sqrt(0.5), std::sqrt(0.5));  // from the southwest to the northeast
}

TEST(Bearing, AQuarterTurnTurnsTheDirectionExactly) {
  // In eighths of a degree all angles are exact, so nothing may be lost by the turn (clockwise: x, y -> y, -x).
  for (int eighth = 0; eighth < 360 * 8; ++eighth) {
    const Direction before = downwind(eighth / 8.0);
    const Direction after = downwind(eighth / 8.0 + 90);
    EXPECT_EQ(after.x, before.y) << eighth / 8.0;
    EXPECT_EQ(after.y, -before.x) << eighth / 8.0;
  }
}

TEST(Bearing, AMirroredWindHasTheMirroredDirection) {
  for (int eighth = 0; eighth < 360 * 8; ++eighth) {
    const Direction one = downwind(eighth / 8.0);
    const Direction other = downwind(360 - eighth / 8.0);
    EXPECT_EQ(other.x, -one.x) << eighth / 8.0;
    EXPECT_EQ(other.y, one.y) << eighth / 8.0;
  }
}

TEST(Bearing, DirectionsHaveLengthOne) {
  for (double bearing = -720; bearing < 720; bearing += 0.37) {
    const Direction toward = downwind(bearing);
    EXPECT_NEAR(std::hypot(toward.x, toward.y), 1, 1e-15) << bearing;
  }
}

TEST(Bearing, ComesBackFromItsDirection) {
  for (double bearing = 0; bearing < 360; bearing += 0.25) {
    EXPECT_NEAR(bearing_of(downwind(bearing)), bearing, 1e-12);
  }
  EXPECT_EQ(bearing_of({1, 0}), 270.0);
  EXPECT_EQ(bearing_of({0, -1}), 0.0);
  EXPECT_EQ(bearing_of({5, 5}), 225.0);  // length does not matter
}

TEST(Bearing, FoldsIntoOneTurn) {
  EXPECT_EQ(fold_bearing(-90), 270.0);
  EXPECT_EQ(fold_bearing(360), 0.0);
  EXPECT_EQ(fold_bearing(725), 5.0);
  EXPECT_EQ(fold_bearing(-1e-20), 0.0);  // not 360, to which it would round
  EXPECT_FALSE(std::signbit(fold_bearing(-0.0)));
  EXPECT_FALSE(std::signbit(fold_bearing(-360)));
}

TEST(Bearing, ReadsDegreesAndCompassPoints) {
  EXPECT_EQ(parse_bearing("270", ""), 270.0);
  EXPECT_EQ(parse_bearing("-90", ""), 270.0);
  EXPECT_EQ(parse_bearing("22.5", ""), 22.5);
  EXPECT_EQ(parse_bearing("360", ""), 0.0);
  EXPECT_EQ(parse_bearing("N", ""), 0.0);
  EXPECT_EQ(parse_bearing("W", ""), 270.0);
  EXPECT_EQ(parse_bearing("ssw", ""), 202.5);
  EXPECT_EQ(parse_bearing("west", ""), 270.0);
  EXPECT_EQ(parse_bearing("North-East", ""), 45.0);
  EXPECT_EQ(parse_bearing("northnorthwest", ""), 337.5);
}

TEST(Bearing, IsNamedByTheNearestPointOfTheCompass) {
  EXPECT_EQ(compass_name(0), "N");
  EXPECT_EQ(compass_name(11), "N");
  EXPECT_EQ(compass_name(12), "NNE");
  EXPECT_EQ(compass_name(250), "WSW");
  EXPECT_EQ(compass_name(-90), "W");
  EXPECT_EQ(compass_name(355), "N");
}

TEST(Bearing, RefusesEverythingElse) {
  for (const char* text : {"", "-", "x", "NN", "wwest", "361", "-360.1", "nan", "inf", "1e400", "90 deg", "27O"}) {
    try {
      parse_bearing(text, "a.json:4");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), std::string("a.json:4: bearing is \"") + text +
                                  "\"; expected -360 to 360 degrees, or a compass point such as W or NNE");
    }
  }
}

}  // namespace
}  // namespace erg
