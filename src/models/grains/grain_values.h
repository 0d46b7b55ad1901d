// What the parameters of the grain model say, as a plain struct.
#pragma once

#include <cstdint>

#include "core/binding.h"

namespace erg::models {

/// What the wind's strength is for the grain model.
enum class StrengthIs { speed, friction_velocity };

/// The values of the grain model's parameters, each under its key and in its unit: their declarations say what they
/// mean.
struct GrainValues {
  StrengthIs strength_is = StrengthIs::speed;
  double wind_height = 0;    ///< m
  double air_density = 0;    ///< kg/m3
  double grain_density = 0;  ///< kg/m3
  double diameter = 0;       ///< mm
  double diameter_spread = 0;
  double drag_coefficient = 0;
  double air_viscosity = 0;  ///< kg/(m s)
  double gravity = 0;        ///< m/s2
  double roughness_ratio = 0;
  double threshold_coefficient = 0;
  double cohesion = 0;  ///< kg/s2
  double impact_ratio = 0;
  double focus_height = 0;  ///< m
  double shadow_angle = 0;  ///< deg
  double lift_low = 0;
  double lift_high = 0;
  double angle_low = 0;   ///< deg
  double angle_high = 0;  ///< deg
  double damping_normal = 0;
  double damping_along = 0;
  double stop_speed = 0;  ///< m/s
  std::int64_t bounce_limit = 0;
  double time_step = 0;       ///< ms
  double longest_flight = 0;  ///< s
  double parcel_height = 0;   ///< mm
  std::int64_t sub_steps = 0;
  double splash = 0;        ///< grains
  double splash_speed = 0;  ///< m/s
  double reptation = 0;     ///< m per m/s
  double reptation_wind = 0;
  double reptation_slope = 0;
  double sideways = 0;
  double rolling = 0;
  double repose_angle = 0;  ///< deg
  std::int64_t plants = 0;
  double plant_diameter = 0;  ///< m
  double plant_height = 0;    ///< m
  double plant_shelter = 0;
  double wake_length = 0;  ///< plant heights
  double wake_spread = 0;
  double bonding_time = 0;  ///< steps
  double abrasion = 0;
  double settling = 0;
};

/// The declarations of all of them.
const Binding<GrainValues>& grain_binding();

}  // namespace erg::models
