#include "wind/regime.h"

#include <gtest/gtest.h>

namespace erg {
namespace {

Season season(double bearing, double first, double last, std::int64_t steps) {
  return {.bearing = bearing, .first = first, .last = last, .steps = steps, .curve = {}};
}

TEST(Regime, TheDefaultIsAWestWindOfFive) {
  const Regime wind;
  EXPECT_TRUE(wind.is_constant());
  EXPECT_EQ(wind, Regime::constant(270, 5));
  EXPECT_EQ(wind.at(0), (WindNow{270, 5}));
  EXPECT_EQ(wind.at(1'000'000'000), (WindNow{270, 5}));
}

TEST(Regime, IsConstantOnlyWithOneSeasonOfOneStrength) {
  EXPECT_TRUE((Regime{{season(10, 7, 7, 80)}}.is_constant()));
  EXPECT_FALSE((Regime{{season(10, 7, 8, 80)}}.is_constant()));
  EXPECT_FALSE((Regime{{season(10, 7, 7, 80), season(20, 7, 7, 80)}}.is_constant()));
}

TEST(Regime, SeasonsFollowEachOtherAndRepeat) {
  const Regime wind{{season(270, 5, 5, 3), season(0, 6, 6, 1), season(90, 7, 7, 2)}};
  EXPECT_EQ(wind.cycle(), 6);
  const double bearings[6] = {270, 270, 270, 0, 90, 90};
  for (std::int64_t step = 0; step < 60; ++step) EXPECT_EQ(wind.at(step).bearing, bearings[step % 6]) << step;
}

TEST(Regime, ReachesFirstAndLastStrengthExactly) {
  for (const auto& [first, last] : {std::pair{3.0, 8.0}, {8.0, 3.0}, {0.1, 0.3}, {5.0, 8192.0}}) {
    for (const std::int64_t steps : {2, 3, 80, 1000}) {
      const Regime wind{{season(270, first, last, steps)}};
      EXPECT_EQ(wind.at(0).strength, first);
      EXPECT_EQ(wind.at(steps - 1).strength, last);
      EXPECT_EQ(wind.at(steps).strength, first);  // the list repeats
    }
  }
}

TEST(Regime, AStraightCurveRisesEvenly) {
  const Regime wind{{season(270, 2, 12, 11)}};
  for (int step = 0; step <= 10; ++step) EXPECT_NEAR(wind.at(step).strength, 2 + step, 1e-12);
}

TEST(Regime, FollowsItsCurve) {
  Season gust = season(270, 0.5, 10.5, 5);
  gust.curve = {{0.5, 0}, {0.5, 1}};
  const Regime wind{{gust}};
  EXPECT_NEAR(wind.at(2).strength, 5.5, 1e-9);  // the middle of a symmetric curve
  for (int step = 0; step < 5; ++step) EXPECT_EQ(wind.at(step).strength, 0.5 + 10 * gust.curve.at(step / 4.0));
  EXPECT_LT(wind.at(1).strength, 3.0);  // below the straight line at first
}

TEST(Regime, ASeasonOfOneStepHasItsFirstStrength) {
  const Regime wind{{season(270, 4, 9, 1)}};
  EXPECT_EQ(wind.at(0).strength, 4);
  EXPECT_EQ(wind.at(17).strength, 4);
}

TEST(Regime, AConstantStrengthIsKeptToTheBit) {
  Season steady = season(270, 0.1, 0.1, 7);
  steady.curve = {{0.9, 0.2}, {0.3, 0.8}};
  const Regime wind{{steady}};
  for (int step = 0; step < 7; ++step) EXPECT_EQ(wind.at(step).strength, 0.1);
}

}  // namespace
}  // namespace erg
