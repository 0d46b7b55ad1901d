#include "forcing/mean_wind.h"

#include <gtest/gtest.h>

namespace erg {

using forcing::resultant_bearing;
using forcing::WindSchedule;

namespace {

forcing::WindInterval season(double bearing, double first, double last, std::int64_t steps, BezierCurve curve = {}) {
  return {.bearing = bearing, .first = first, .last = last, .steps = steps, .curve = curve};
}

TEST(MeanWind, IsTheMeanOverAllStepsOfACycle) {
  const BezierCurve late{{0.9, 0}, {0.9, 0.2}};
  const BezierCurve early{{0, 0.7}, {0.1, 1}};
  for (const WindSchedule& wind :
       {WindSchedule::constant(270, 5), WindSchedule{{season(0, 3, 9, 1)}}, WindSchedule{{season(0, 3, 9, 2, late)}},
        WindSchedule{{season(270, 3, 8, 100, late), season(90, 5, 5, 50), season(10, 9, 1, 7, early)}},
        WindSchedule{{season(270, 2, 12, 3000, early), season(180, 0.1, 0.1, 500)}}}) {
    double sum = 0;
    for (std::int64_t step = 0; step < wind.cycle(); ++step) sum += wind.at(step).strength;
    EXPECT_NEAR(forcing::mean_strength(wind), sum / static_cast<double>(wind.cycle()), 0.01);
  }
}

TEST(MeanWind, DrivesWhereItsSeasonsDoTogether) {
  EXPECT_EQ(resultant_bearing(WindSchedule::constant(285, 5)), 285);
  EXPECT_NEAR(resultant_bearing(WindSchedule{{season(240, 5, 5, 10), season(300, 5, 5, 10)}}).value(), 270, 1e-9);
  EXPECT_NEAR(resultant_bearing(WindSchedule{{season(0, 3, 3, 10), season(90, 5, 5, 6)}}).value(), 45, 1e-9)
      << "30 each";
  EXPECT_FALSE(resultant_bearing(WindSchedule{{season(90, 5, 5, 10), season(270, 5, 5, 10)}}));
  EXPECT_FALSE(resultant_bearing(WindSchedule{{season(0, 5, 5, 10), season(120, 5, 5, 10), season(240, 5, 5, 10)}}));
}

}  // namespace
}  // namespace erg
