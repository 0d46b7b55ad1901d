#include "forcing/wind_schedule.h"

#include <gtest/gtest.h>

#include <cmath>

namespace erg {

using forcing::Forcing;
using forcing::WindInterval;
using forcing::WindSchedule;

namespace {

WindInterval season(double bearing, double first, double last, std::int64_t steps) {
  return {.bearing = bearing, .first = first, .last = last, .steps = steps, .curve = {}};
}

TEST(WindSchedule, TheDefaultIsAWestWindOfFive) {
  const WindSchedule wind;
  EXPECT_TRUE(wind.is_constant());
  EXPECT_EQ(wind, WindSchedule::constant(270, 5));
  EXPECT_EQ(wind.at(0), (Forcing{270, 5}));
  EXPECT_EQ(wind.at(1'000'000'000), (Forcing{270, 5}));
}

TEST(WindSchedule, IsConstantOnlyWithOneSeasonOfOneStrength) {
  EXPECT_TRUE((WindSchedule{{season(10, 7, 7, 80)}}.is_constant()));
  EXPECT_FALSE((WindSchedule{{season(10, 7, 8, 80)}}.is_constant()));
  EXPECT_FALSE((WindSchedule{{season(10, 7, 7, 80), season(20, 7, 7, 80)}}.is_constant()));
}

TEST(WindSchedule, SeasonsFollowEachOtherAndRepeat) {
  const WindSchedule wind{{season(270, 5, 5, 3), season(0, 6, 6, 1), season(90, 7, 7, 2)}};
  EXPECT_EQ(wind.cycle(), 6);
  const double bearings[6] = {270, 270, 270, 0, 90, 90};
  for (std::int64_t step = 0; step < 60; ++step) EXPECT_EQ(wind.at(step).bearing, bearings[step % 6]) << step;
}

TEST(WindSchedule, ReachesFirstAndLastStrengthExactly) {
  for (const auto& [first, last] : {std::pair{3.0, 8.0}, {8.0, 3.0}, {0.1, 0.3}, {5.0, 8192.0}}) {
    for (const std::int64_t steps : {2, 3, 80, 1000}) {
      const WindSchedule wind{{season(270, first, last, steps)}};
      EXPECT_EQ(wind.at(0).strength, first);
      EXPECT_EQ(wind.at(steps - 1).strength, last);
      EXPECT_EQ(wind.at(steps).strength, first);  // the list repeats
    }
  }
}

TEST(WindSchedule, AStraightCurveRisesEvenly) {
  const WindSchedule wind{{season(270, 2, 12, 11)}};
  for (int step = 0; step <= 10; ++step) EXPECT_NEAR(wind.at(step).strength, 2 + step, 1e-12);
}

TEST(WindSchedule, FollowsItsCurve) {
  WindInterval gust = season(270, 0.5, 10.5, 5);
  gust.curve = {{0.5, 0}, {0.5, 1}};
  const WindSchedule wind{{gust}};
  EXPECT_NEAR(wind.at(2).strength, 5.5, 1e-9);  // the middle of a symmetric curve
  for (int step = 0; step < 5; ++step) EXPECT_EQ(wind.at(step).strength, 0.5 + 10 * gust.curve.at(step / 4.0));
  EXPECT_LT(wind.at(1).strength, 3.0);  // below the straight line at first
}

TEST(WindSchedule, ASeasonOfOneStepHasItsFirstStrength) {
  const WindSchedule wind{{season(270, 4, 9, 1)}};
  EXPECT_EQ(wind.at(0).strength, 4);
  EXPECT_EQ(wind.at(17).strength, 4);
}

TEST(WindSchedule, AConstantStrengthIsKeptToTheBit) {
  WindInterval steady = season(270, 0.1, 0.1, 7);
  steady.curve = {{0.9, 0.2}, {0.3, 0.8}};
  const WindSchedule wind{{steady}};
  for (int step = 0; step < 7; ++step) EXPECT_EQ(wind.at(step).strength, 0.1);
}

WindInterval swinging(double bearing, double spread, std::int64_t steps, std::int64_t hold) {
  WindInterval one = season(bearing, 5, 5, steps);
  one.spread = spread;
  one.hold = hold;
  return one;
}

TEST(Spread, EverySixteenDrawsHaveTheMeanBearingAndTheSpread) {
  for (const double spread : {0.5, 10.0, 60.0}) {
    for (const std::uint64_t seed : {0u, 7u}) {
      const WindSchedule wind{{swinging(350, spread, 1, 4)}};
      for (int round = 0; round < 5; ++round) {
        double sum = 0;
        double squares = 0;
        for (std::int64_t step = 64 * round; step < 64 * (round + 1); ++step) {
          const Forcing now = wind.at(step, seed);
          EXPECT_EQ(now.swing, wind.at(step - step % 4, seed).swing) << "holds for four steps";
          EXPECT_EQ(now.mean_bearing(), 350);
          EXPECT_EQ(now.bearing, fold_bearing(350 + now.swing));
          sum += now.swing;
          squares += now.swing * now.swing;
        }
        EXPECT_EQ(sum, 0) << spread << ", round " << round;
        EXPECT_NEAR(std::sqrt(squares / 64), spread, 1e-4 * spread);
      }
    }
  }
}

TEST(Spread, DrawsOfASeasonGoOnWhereItReturns) {
  // Three steps a cycle: 16 draws of 4 steps take 64 steps of each season, of which the first has 3 of 5.
  const WindSchedule wind{{swinging(210, 10, 3, 4), swinging(330, 10, 2, 4)}};
  double sums[2] = {0, 0};
  int steps[2] = {0, 0};
  for (std::int64_t step = 0; step < 5 * 64; ++step) {
    const int season = step % 5 < 3 ? 0 : 1;
    sums[season] += wind.at(step, 3).swing;
    ++steps[season];
  }
  EXPECT_EQ(steps[0], 3 * 64);
  EXPECT_EQ(steps[1], 2 * 64);
  EXPECT_EQ(sums[0], 0);
  EXPECT_EQ(sums[1], 0);
  EXPECT_NE(wind.at(0, 3).swing, wind.at(3, 3).swing) << "seasons draw for themselves";
}

TEST(Spread, DrawsDifferBetweenSeedsAndRounds) {
  const WindSchedule wind{{swinging(270, 10, 1, 1)}};
  const auto draws = [&](std::uint64_t seed, std::int64_t first) {
    std::vector<double> swings;
    for (std::int64_t step = first; step < first + 16; ++step) swings.push_back(wind.at(step, seed).swing);
    return swings;
  };
  EXPECT_NE(draws(1, 0), draws(2, 0));
  EXPECT_NE(draws(1, 0), draws(1, 16));
  EXPECT_EQ(draws(1, 16), draws(1, 16));
}

TEST(Spread, WithoutItAndWithoutASeedTheWindBlowsFromItsBearing) {
  EXPECT_EQ((WindSchedule{{swinging(270, 0, 1, 4)}}.at(9, 5)), (Forcing{270, 5}));
  EXPECT_EQ((WindSchedule{{swinging(270, 10, 1, 4)}}.at(9)), (Forcing{270, 5}));
}

TEST(Spread, ATurnedWindSwingsAlikeToTheBit) {
  for (std::int64_t step = 0; step < 64; ++step) {
    const Forcing west = WindSchedule{{swinging(270, 13.7, 1, 1)}}.at(step, 5);
    const Forcing north = WindSchedule{{swinging(0, 13.7, 1, 1)}}.at(step, 5);
    EXPECT_EQ(fold_bearing(west.bearing + 90), north.bearing);
  }
}

}  // namespace
}  // namespace erg
