// What holds for a single grain: its flight, its bounce, its hop, and the wind that it flies in.
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "grain_world.h"
#include "models/grains/plant_wakes.h"

namespace erg::test {

using forcing::wind_frame;
using models::bounce;
using models::friction_velocity;
using models::Grain;
using models::GrainDice;
using models::GrainLaw;
using models::GrainValues;
using models::GroundPoint;
using models::lifting_threshold;
using models::profile_speed;
using models::reptation;

namespace {

TEST(Grains, EnergyNeverRisesInABounce) {
  const GrainLaw law = calm_law();
  GrainDice dice{17};
  for (int k = 0; k < 20000; ++k) {
    const auto signed_unit = [&] { return 2 * dice.unit() - 1; };
    Grain grain;
    grain.speed_u = 8 * signed_unit();
    grain.speed_v = 8 * signed_unit();
    grain.speed_z = 4 * signed_unit();
    const models::GroundSpot spot{0, 0, 1, 3 * signed_unit(), 3 * signed_unit()};
    const auto energy = [&] {
      return grain.speed_u * grain.speed_u + grain.speed_v * grain.speed_v + grain.speed_z * grain.speed_z;
    };
    const float before = energy();
    bounce(law, spot, grain);
    EXPECT_LE(energy(), before * 1.00001f);
    EXPECT_GE(grain.speed_z - grain.speed_u * spot.slope_u - grain.speed_v * spot.slope_v, -1e-4f) << "into the ground";
  }
}

TEST(Grains, ABounceOnLevelGroundDampsBothParts) {
  const GrainLaw law = calm_law();
  Grain grain;
  grain.speed_v = 3;
  grain.speed_z = -1;
  bounce(law, {0, 0, 1, 0, 0}, grain);
  EXPECT_FLOAT_EQ(grain.speed_v, 1.8f);
  EXPECT_FLOAT_EQ(grain.speed_z, 0.4f);
}

/// Notes the first touch of the ground.
struct FirstImpact {
  float speed = 0;
  int count = 0;
  void at(const Grain&) {}
  void impact(int, int, int, float impact_speed) {
    if (count++ == 0) speed = impact_speed;
  }
};

TEST(Grains, WithoutAirAGrainFliesAParabola) {
  GrainLaw law = calm_law();
  law.time_step = 1e-4f;
  law.longest_steps = 100000;
  law.bounce_limit = 1;
  const std::vector<GroundPoint> level((64 + 2) * (64 + 2));
  const models::SurfaceSnapshot ground{level.data(), 64, 64, true};
  Grain grain;
  grain.u = grain.v = 20;
  grain.speed_v = 1.5f;
  grain.speed_z = 1;
  GrainDice dice{1};
  models::FlightCounters sums;
  FirstImpact watch;
  EXPECT_EQ(fly(law, ground, grain, dice, sums, watch), models::FlightEnd::rested);
  // Way 2 v w / g, speed of impact as at the start; the first-order time step errs by g dt / w.
  EXPECT_NEAR(grain.along, 2 * 1.5 * 1 / 9.81, 0.001);
  EXPECT_NEAR(watch.speed, std::hypot(1.5, 1.0), 0.003);
  EXPECT_NEAR(grain.v, 20 + 30.58, 0.1);
}

TEST(Grains, TheProfileIsLogarithmicAndItsTableExact) {
  const GrainValues values = grain_values();
  const double threshold = lifting_threshold(values, 0.25e-3);
  EXPECT_NEAR(threshold, 0.7 * std::sqrt(0.0123 * (2655 / 1.1644 * 9.81 * 0.25e-3 + 3e-4 / (1.1644 * 0.25e-3))), 1e-12);
  EXPECT_NEAR(profile_speed(values, 0.15, 1.0), 0.15 / 0.4 * std::log(1 / (0.25e-3 / 30)), 1e-9);
  // All winds over the threshold meet at the focus.
  EXPECT_DOUBLE_EQ(profile_speed(values, 0.3, 0.02), profile_speed(values, 0.6, 0.02));
  EXPECT_GT(profile_speed(values, 0.6, 0.1), profile_speed(values, 0.3, 0.1));
  for (const double speed : {6.0, 10.0, 15.0}) {
    EXPECT_NEAR(profile_speed(values, friction_velocity(values, speed), 10), speed, 1e-9);
  }
  const GrainLaw law = models::grain_law(values, {270, 12}, wind_frame({8, 8}, 270), 0.01);
  for (const double height : {1e-4, 0.003, 0.0199, 0.05, 0.7, 11.0}) {
    const double exact = profile_speed(values, friction_velocity(values, 12), height);
    EXPECT_NEAR(models::wind_at(law, static_cast<float>(height)), exact, 0.01 * exact) << height;
  }
}

// The speed at which a grain falls through still air for good.
double falling_speed(const GrainSettings& settings) {
  GrainLaw law = calm_law(settings);
  law.time_step = 1e-3f;
  Grain grain;
  models::give_size(law, 0, grain);
  for (int step = 0; step < 5000; ++step) models::advance(law, {-1000, -2000, 1, 0, 0}, grain);
  return -grain.speed_z;
}

TEST(Grains, FallThroughStillAirAsFastAsDragLets) {
  for (const double diameter : {0.1, 0.25, 0.6}) {
    for (const double coefficient : {0.2, 0.5, 1.0}) {
      const double speed = falling_speed({{"diameter", diameter}, {"drag_coefficient", coefficient}});
      // Weight is drag: C = (sqrt C0 + sqrt(24 / Re))^2, speed^2 = 4/3 (rho_grain / rho_air) g d / C.
      const double reynolds = 1.1644 * speed * diameter * 1e-3 / 1.8e-5;
      const double drag = std::pow(std::sqrt(coefficient) + std::sqrt(24 / reynolds), 2);
      EXPECT_NEAR(speed * speed, 4.0 / 3 * 2655 / 1.1644 * 9.81 * diameter * 1e-3 / drag, 0.01 * speed * speed);
    }
  }
  EXPECT_NEAR(falling_speed({}), 1.5, 0.3);  // m/s: sand of a quarter of a millimetre
  EXPECT_LT(falling_speed({{"gravity", 3.71}}), falling_speed({}));
}

/// Ground that rises by `before` a cell up to row `crest` and by `behind` from there on; slopes of 1 are 45 degrees.
std::vector<GroundPoint> two_slopes(int side, float before, float behind, int crest) {
  std::vector<GroundPoint> points(static_cast<std::size_t>(side + 2) * (side + 2));
  for (int v = -1; v <= side; ++v) {
    const float height = 10 + 0.01f * (v < crest ? before * (v - crest) : behind * (v - crest));
    for (int u = -1; u <= side; ++u) points[static_cast<std::size_t>(v + 1) * (side + 2) + u + 1].height = height;
  }
  return points;
}

TEST(Grains, HopsAreShorterUphillAndLongerOverACrest) {
  constexpr int side = 40;
  const GrainLaw law = calm_law();
  const auto way = [&](float before, float behind, float v) {
    const std::vector<GroundPoint> points = two_slopes(side, before, behind, 20);
    return models::way_over_ground(law, {points.data(), side, side, false}, 20, v, 0, 1, 6);
  };
  EXPECT_NEAR(way(0, 0, 10.5f), 6, 0.01);
  EXPECT_NEAR(way(0.2f, 0.2f, 10.5f), 6 * (1 - 2 * 0.2), 0.1);
  EXPECT_NEAR(way(-0.2f, -0.2f, 10.5f), 6 * (1 + 2 * 0.2), 0.1);
  EXPECT_NEAR(way(0.9f, 0.9f, 10.5f), 0.6, 0.01) << "a tenth is left on the steepest";
  EXPECT_GT(way(0.2f, -0.6f, 19.5f), 8) << "over a crest into the lee";
  EXPECT_LT(way(0, 0.8f, 18.5f), 4) << "against the foot of a steep slope";
}

TEST(Grains, ReptationIsLinearInTheFrictionVelocity) {
  const GrainValues values = grain_values({{"reptation", 0.01}, {"reptation_wind", 0.5}});
  const double threshold = lifting_threshold(values, 0.25e-3);
  EXPECT_DOUBLE_EQ(reptation(values, threshold), 0.01);
  EXPECT_DOUBLE_EQ(reptation(values, 2 * threshold), 0.015);
  EXPECT_DOUBLE_EQ(reptation(values, 3 * threshold), 0.02);
  EXPECT_DOUBLE_EQ(reptation(values, 0.5 * threshold), 0.01) << "no shorter than at the threshold";
  EXPECT_DOUBLE_EQ(reptation(values, 50 * threshold), reptation(values, 10 * threshold));
  EXPECT_DOUBLE_EQ(reptation(grain_values({{"reptation_wind", 0.0}}), 3 * threshold), 0.0075) << "as long in any wind";
  const GrainValues light = grain_values({{"threshold_coefficient", 0.0}});
  EXPECT_DOUBLE_EQ(reptation(light, 0.3), 0.0075 * (1 + 0.7 * 9)) << "finite where the threshold is nothing";
}

TEST(Grains, APlantSheltersWhatLiesBehindAndNothingElse) {
  const GrainValues values = grain_values({{"plant_height", 0.02}});  // a wake of 20 cells
  Terrain terrain({40, 40}, 0.01, 0.25e-3, Boundary::torus);
  Grid<float> plants(terrain.extent());
  plants(10, 20) = 1;
  const forcing::WindFrame frame = wind_frame(terrain.extent(), 270);
  const std::vector<float> shelter = models::plant_shelter(values, terrain, plants, frame);
  const auto left_at = [&](int x, int y) {
    for (int v = 0; v < frame.length; ++v) {
      for (int u = 0; u < frame.width; ++u) {
        if (frame.cell(u, v) == static_cast<std::size_t>(y) * 40 + static_cast<std::size_t>(x)) {
          return shelter[static_cast<std::size_t>(v) * frame.width + u];
        }
      }
    }
    return -1.0f;
  };
  EXPECT_FLOAT_EQ(left_at(10, 20), 0.2f);
  EXPECT_FLOAT_EQ(left_at(15, 20), 1 - 0.8f * (1 - 5.0f / 20));
  EXPECT_GT(left_at(25, 20), left_at(15, 20));
  for (const auto& [x, y] : {std::pair{9, 20}, {31, 20}, {11, 24}, {10, 18}}) EXPECT_EQ(left_at(x, y), 1) << x;
}

}  // namespace
}  // namespace erg::test
