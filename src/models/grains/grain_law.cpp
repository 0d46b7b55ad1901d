#include "models/grains/grain_law.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/units.h"

namespace erg::models {
namespace {

constexpr double millimetre = 1e-3;

double median_diameter(const GrainValues& values) { return values.diameter * millimetre; }

double roughness(const GrainValues& values) { return median_diameter(values) / values.roughness_ratio; }

// Middle of the i-th of `draw_nodes` equal shares of probability.
double share_of(int node) { return (node + 0.5) / draw_nodes; }

// The quantile of the normal distribution: where its integral reaches `share`, by bisection.
double normal_quantile(double share) {
  double low = -8;
  double high = 8;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void fill_sizes(const GrainValues& values, GrainLaw& law) {
  const double ratio = values.air_density / values.grain_density;
  for (int node = 0; node < draw_nodes; ++node) {
    const double spread = values.diameter_spread * normal_quantile(share_of(node));
    const double diameter = median_diameter(values) * std::exp(spread);
    law.drag[node] = static_cast<float>(0.75 * ratio * values.drag_coefficient / diameter);
    law.viscous[node] = static_cast<float>(18 * values.air_viscosity / (values.grain_density * diameter * diameter));
    law.threshold[node] = static_cast<float>(lifting_threshold(values, diameter));
  }
}

void fill_profile(const GrainValues& values, double friction, GrainLaw& law) {
  for (int node = 0; node < profile_nodes; ++node) {
    const int octave = profile_lowest + node / profile_parts;
    const double height = std::ldexp(1 + (node % profile_parts) / static_cast<double>(profile_parts), octave);
    law.wind_speed[node] = static_cast<float>(profile_speed(values, friction, height));
  }
}

void fill_draws(const GrainValues& values, GrainLaw& law) {
  const double low = values.angle_low;
  const double range = values.angle_high - low;
  for (int node = 0; node < draw_nodes; ++node) {
    law.cotangent[node] = static_cast<float>(1 / std::tan(radians(low + range * share_of(node))));
    law.exponential[node] = static_cast<float>(-std::log(1 - share_of(node)));
  }
}

}  // namespace

double lifting_threshold(const GrainValues& values, double diameter) {
  const double weight = values.grain_density / values.air_density * values.gravity * diameter;
  const double sticking = values.cohesion / (values.air_density * diameter);
  return values.impact_ratio * std::sqrt(values.threshold_coefficient * (weight + sticking));
}

double friction_velocity(const GrainValues& values, double strength) {
  if (values.strength_is == StrengthIs::friction_velocity) return strength;
  const double height = values.wind_height;
  const double clear = karman * strength / std::log(height / roughness(values));
  const double threshold = lifting_threshold(values, median_diameter(values));
  if (clear <= threshold) return clear;
  const double focus = values.focus_height;
  return karman * (strength - profile_speed(values, threshold, focus)) / std::log(height / focus);
}

double profile_speed(const GrainValues& values, double friction, double height) {
  if (height <= roughness(values)) return 0;
  const double held = std::min(friction, lifting_threshold(values, median_diameter(values)));
  const double focus = values.focus_height;
  const double below = held / karman * std::log(std::min(height, focus) / roughness(values));
  return height > focus ? below + friction / karman * std::log(height / focus) : below;
}

double reptation(const GrainValues& values, double friction) {
  constexpr double most = 10;  // beyond all measurements, and it keeps ways finite where the threshold is next to 0
  const double ratio = std::min(most, friction / lifting_threshold(values, median_diameter(values)));
  return values.reptation * (1 + values.reptation_wind * std::max(0.0, ratio - 1));
}

GrainLaw grain_law(const GrainValues& values, const forcing::Forcing& wind, const forcing::WindFrame& frame,
                   double cell_size) {
  const double friction = friction_velocity(values, wind.strength);
  const double seconds = values.time_step * 1e-3;
  GrainLaw law;
  law.toward_u = static_cast<float>(frame.tangent * frame.cosine);
  law.toward_v = static_cast<float>(frame.cosine);
  law.friction_velocity = static_cast<float>(friction);
  law.cells_a_metre = static_cast<float>(1 / cell_size);
  law.gravity = static_cast<float>(values.gravity);
  law.time_step = static_cast<float>(seconds);
  law.longest_steps = static_cast<int>(values.longest_flight / seconds);
  law.lift_low = static_cast<float>(values.lift_low);
  law.lift_range = static_cast<float>(values.lift_high - values.lift_low);
  law.damping_normal = static_cast<float>(values.damping_normal);
  law.damping_along = static_cast<float>(values.damping_along);
  law.stop_speed_squared = static_cast<float>(values.stop_speed * values.stop_speed);
  law.bounce_limit = static_cast<int>(values.bounce_limit);
  law.splash = static_cast<float>(values.splash);
  law.splash_speed_squared = static_cast<float>(values.splash_speed * values.splash_speed);
  law.reptation_cells = static_cast<float>(reptation(values, friction) / cell_size);
  law.reptation_slope = static_cast<float>(values.reptation_slope);
  law.rolling = static_cast<float>(values.rolling);
  law.sideways = static_cast<float>(values.sideways);
  fill_sizes(values, law);
  fill_profile(values, friction, law);
  fill_draws(values, law);
  return law;
}

}  // namespace erg::models
