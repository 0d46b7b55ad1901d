#include "models/grains/grain_law.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/units.h"

namespace erg {
namespace {

constexpr double millimetre = 1e-3;

double median_diameter(const ParameterValues& values) { return values.real("diameter") * millimetre; }

double roughness(const ParameterValues& values) { return median_diameter(values) / values.real("roughness_ratio"); }

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

void fill_sizes(const ParameterValues& values, GrainLaw& law) {
  const double ratio = values.real("air_density") / values.real("grain_density");
  for (int node = 0; node < draw_nodes; ++node) {
    const double spread = values.real("diameter_spread") * normal_quantile(share_of(node));
    const double diameter = median_diameter(values) * std::exp(spread);
    law.drag[node] = static_cast<float>(0.75 * ratio * values.real("drag_coefficient") / diameter);
    law.viscous[node] =
        static_cast<float>(18 * values.real("air_viscosity") / (values.real("grain_density") * diameter * diameter));
    law.threshold[node] = static_cast<float>(lifting_threshold(values, diameter));
  }
}

void fill_profile(const ParameterValues& values, double friction, GrainLaw& law) {
  for (int node = 0; node < profile_nodes; ++node) {
    const int octave = profile_lowest + node / profile_parts;
    const double height = std::ldexp(1 + (node % profile_parts) / static_cast<double>(profile_parts), octave);
    law.wind_speed[node] = static_cast<float>(profile_speed(values, friction, height));
  }
}

void fill_draws(const ParameterValues& values, GrainLaw& law) {
  const double low = values.real("angle_low");
  const double range = values.real("angle_high") - low;
  for (int node = 0; node < draw_nodes; ++node) {
    law.cotangent[node] = static_cast<float>(1 / std::tan(radians(low + range * share_of(node))));
    law.exponential[node] = static_cast<float>(-std::log(1 - share_of(node)));
  }
}

Parameters air_and_grain_parameters() {
  return {
      choice_parameter("strength_is", "The wind's strength is", "speed", {"speed", "friction_velocity"},
                       "speed: m/s at wind_height; friction_velocity: m/s, the shear of the wind on the ground."),
      only_when(real_parameter("wind_height", "Height of the wind's speed", "m", 10, 0.1, 100,
                               "Height above the ground at which the wind has the speed given as its strength."),
                {"strength_is", "speed"}),
      real_parameter("air_density", "Density of the air", "kg/m3", 1.1644, 0.01, 10, "Density of the air.",
                     "Cimbura 2022, sec. 5.11"),
      real_parameter("grain_density", "Density of a grain", "kg/m3", 2655, 100, 10000,
                     "2655 for quartz sand, 917 for ice.", "Cimbura 2022, sec. 5.11"),
      real_parameter("diameter", "Diameter of a grain", "mm", 0.25, 0.02, 3, "Median diameter of the grains."),
      real_parameter("diameter_spread", "Spread of diameters", "", 0, 0, 1.5,
                     "Standard deviation of the logarithm of the diameter (log-normal); 0: all grains alike."),
      real_parameter(
          "drag_coefficient", "Drag coefficient", "", 1, 0, 10,
          "C of the drag (sqrt C + sqrt(24 / Re))^2: what is left of it at high speed; 1 for natural sand, .5 for "
          "spheres. Cimbura 2022 has .5 alone, which is right for grains of centimetres.",
          "Claudin & Andreotti 2006"),
      real_parameter(
          "air_viscosity", "Viscosity of the air", "kg/(m s)", 1.8e-5, 0, 1e-3,
          "Dynamic viscosity of the air: of the Reynolds number in the drag. 0: the drag coefficient alone."),
      real_parameter("gravity", "Gravity", "m/s2", earth_gravity, 0.1, 100, "Weight of a kilogram; 3.71 on Mars."),
      real_parameter("roughness_ratio", "Diameter over roughness", "", 30, 1, 1000,
                     "The log profile starts at the median diameter divided by this.", "Bagnold 1941"),
      real_parameter("threshold_coefficient", "Threshold coefficient", "", 0.0123, 0, 1,
                     "Square of the dimensionless friction velocity at which air alone lifts grains.",
                     "Shao & Lu 2000"),
      real_parameter("cohesion", "Cohesion", "kg/s2", 3e-4, 0, 1,
                     "How strongly grains stick to each other: fine ones lift later.", "Shao & Lu 2000"),
      real_parameter("impact_ratio", "Threshold under impacts", "", 0.7, 0.1, 1,
                     "Threshold among flying grains, as a share of that of the air alone (Bagnold's .08 over Shao & "
                     "Lu's .111, rounded).",
                     "Bagnold 1941"),
      real_parameter("focus_height", "Focus height", "m", 0.02, 0.0001, 0.09,
                     "Below this the flying grains hold the wind at the profile of the threshold; above it the profile "
                     "steepens with the friction velocity.",
                     "Bagnold 1941"),
      real_parameter("shadow_angle", "Shadow angle", "deg", 15, 1, 80,
                     "Below a line that falls at this angle behind every crest there is no wind; grains that land "
                     "there stay.",
                     "Werner 1995"),
  };
}

Parameters flight_parameters() {
  return {
      real_parameter("lift_low", "Slowest lift-off", "", 0.8, 0, 10,
                     "Smallest lift-off speed upward over friction velocity (B).", "Wang & Hu 2012"),
      real_parameter("lift_high", "Fastest lift-off", "", 2, 0, 10,
                     "Largest lift-off speed upward over friction velocity (B).", "Wang & Hu 2012"),
      real_parameter("angle_low", "Flattest lift-off", "deg", 21, 1, 90, "Smallest lift-off angle to the ground.",
                     "Wang & Hu 2012"),
      real_parameter("angle_high", "Steepest lift-off", "deg", 90, 1, 90, "Largest lift-off angle to the ground.",
                     "Wang & Hu 2012"),
      real_parameter("damping_normal", "Speed kept across the ground", "", 0.4, 0, 1,
                     "Share of the speed across the ground that a bounce gives back."),
      real_parameter("damping_along", "Speed kept along the ground", "", 0.6, 0, 1,
                     "Share of the speed along the ground that a bounce keeps."),
      real_parameter("stop_speed", "Stop speed", "m/s", 0.6, 0, 100,
                     "A grain that leaves a bounce more slowly stays where it is."),
      integer_parameter("bounce_limit", "Bounces", "", 6, 1, 1000, "A grain stays after so many bounces."),
      real_parameter("time_step", "Time step", "ms", 2, 0.01, 10, "Time step of the flight."),
      real_parameter("longest_flight", "Longest flight", "s", 20, 0.1, 1000,
                     "A grain still flying after this time is put down where it is and counted as cut off."),
  };
}

Parameters bed_parameters() {
  return {
      at_start(real_parameter("parcel_height", "Height of a parcel", "mm", 0.25, 0.001, 100,
                              "Grains move in parcels; one raises its cell by this. How many grains that is: see what "
                              "the values mean.")),
      integer_parameter("sub_steps", "Sub-steps", "", 4, 1, 64,
                        "A step polls every cell once, in so many parts; each sees the ground that the last one left."),
      real_parameter(
          "splash", "Splash", "grains", 4, 0, 100,
          "Most grains that one impact knocks loose: splash * v^2 / (v^2 + splash_speed^2). Without splash no "
          "ripple moves."),
      real_parameter("splash_speed", "Speed of half the splash", "m/s", 1, 0.01, 100,
                     "Impact speed v at which half of them come loose."),
      real_parameter(
          "reptation", "Reptation", "m per m/s", 0.0075, 0, 1,
          "Mean way on level ground of a grain knocked loose (exponential), for each m/s of the impact, in a "
          "wind at the threshold."),
      real_parameter(
          "reptation_wind", "Reptation in stronger winds", "", 0.7, 0, 10,
          "How much farther it gets in a stronger wind: 1 + this * (u* / threshold - 1) times as far. So the "
          "length of ripples rises with the friction velocity u*; 0: hardly.",
          "fitted to Andreotti et al. 2006"),
      real_parameter("reptation_slope", "Reptation uphill", "", 2, 0, 100,
                     "Cotangent of the angle at which it starts its low parabola. On a straight slope the way is "
                     "multiplied by 1 - this * slope, at least by .1; over a crest it is longer."),
      real_parameter("sideways", "Sideways", "", 0.3, 0, 1, "Share of reptating grains that go across the wind."),
      real_parameter("rolling", "Rolling", "", 4, 0, 100,
                     "Chance that a grain which comes to rest rolls on into a lower neighbour, for a slope of 1."),
      real_parameter("repose_angle", "Angle of repose", "deg", 33, 1, 80, "Slopes steeper than this slide."),
  };
}

Parameters plant_and_snow_parameters() {
  return {
      integer_parameter("plants", "Plants", "", 0, 0, 10000,
                        "Cylinders that stand on the ground, evenly strewn, the first in the middle."),
      real_parameter("plant_diameter", "Diameter of a plant", "m", 0.1, 0.001, 100, "Diameter of a plant."),
      real_parameter("plant_height", "Height of a plant", "m", 0.1, 0.001, 100, "Height of a plant."),
      real_parameter("plant_shelter", "Shelter of a plant", "", 0.8, 0, 1,
                     "Share of the wind that a plant takes away where it stands and just behind it."),
      real_parameter("wake_length", "Length of the wake", "plant heights", 10, 0, 100,
                     "The wind has recovered so far behind a plant.", "Wolfe & Nickling 1993"),
      real_parameter("wake_spread", "Spread of the wake", "", 0.15, 0, 2,
                     "How much the wake widens to either side, over the distance."),
      real_parameter(
          "bonding_time", "Bonding time", "steps", 0, 0, 1e9,
          "Mean time until the snow of a cell bonds, save what came or went in the last step; 0: never, as sand."),
      real_parameter("abrasion", "Abrasion", "", 0.02, 0, 1,
                     "Chance that an impact which finds nothing loose frees a bonded grain."),
      real_parameter("settling", "Settling", "", 0, 0, 0.25,
                     "Chance a step that a loose grain creeps to a neighbour one parcel lower: fresh snow evens out "
                     "before it bonds; 0 for sand."),
  };
}

}  // namespace

Parameters grain_parameters() {
  Parameters all = air_and_grain_parameters();
  for (const Parameters& more : {flight_parameters(), bed_parameters(), plant_and_snow_parameters()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

double lifting_threshold(const ParameterValues& values, double diameter) {
  const double weight = values.real("grain_density") / values.real("air_density") * values.real("gravity") * diameter;
  const double sticking = values.real("cohesion") / (values.real("air_density") * diameter);
  return values.real("impact_ratio") * std::sqrt(values.real("threshold_coefficient") * (weight + sticking));
}

double friction_velocity(const ParameterValues& values, double strength) {
  if (values.text("strength_is") == "friction_velocity") return strength;
  const double height = values.real("wind_height");
  const double clear = karman * strength / std::log(height / roughness(values));
  const double threshold = lifting_threshold(values, median_diameter(values));
  if (clear <= threshold) return clear;
  const double focus = values.real("focus_height");
  return karman * (strength - profile_speed(values, threshold, focus)) / std::log(height / focus);
}

double profile_speed(const ParameterValues& values, double friction, double height) {
  if (height <= roughness(values)) return 0;
  const double held = std::min(friction, lifting_threshold(values, median_diameter(values)));
  const double focus = values.real("focus_height");
  const double below = held / karman * std::log(std::min(height, focus) / roughness(values));
  return height > focus ? below + friction / karman * std::log(height / focus) : below;
}

double reptation(const ParameterValues& values, double friction) {
  constexpr double most = 10;  // beyond all measurements, and it keeps ways finite where the threshold is next to 0
  const double ratio = std::min(most, friction / lifting_threshold(values, median_diameter(values)));
  return values.real("reptation") * (1 + values.real("reptation_wind") * std::max(0.0, ratio - 1));
}

GrainLaw grain_law(const ParameterValues& values, const WindNow& wind, const WindFrame& frame, double cell_size) {
  const double friction = friction_velocity(values, wind.strength);
  const double seconds = values.real("time_step") * 1e-3;
  GrainLaw law;
  law.toward_u = static_cast<float>(frame.tangent * frame.cosine);
  law.toward_v = static_cast<float>(frame.cosine);
  law.friction_velocity = static_cast<float>(friction);
  law.cells_a_metre = static_cast<float>(1 / cell_size);
  law.gravity = static_cast<float>(values.real("gravity"));
  law.time_step = static_cast<float>(seconds);
  law.longest_steps = static_cast<int>(values.real("longest_flight") / seconds);
  law.lift_low = static_cast<float>(values.real("lift_low"));
  law.lift_range = static_cast<float>(values.real("lift_high") - values.real("lift_low"));
  law.damping_normal = static_cast<float>(values.real("damping_normal"));
  law.damping_along = static_cast<float>(values.real("damping_along"));
  law.stop_speed_squared = static_cast<float>(values.real("stop_speed") * values.real("stop_speed"));
  law.bounce_limit = static_cast<int>(values.integer("bounce_limit"));
  law.splash = static_cast<float>(values.real("splash"));
  law.splash_speed_squared = static_cast<float>(values.real("splash_speed") * values.real("splash_speed"));
  law.reptation_cells = static_cast<float>(reptation(values, friction) / cell_size);
  law.reptation_slope = static_cast<float>(values.real("reptation_slope"));
  law.rolling = static_cast<float>(values.real("rolling"));
  law.sideways = static_cast<float>(values.real("sideways"));
  fill_sizes(values, law);
  fill_profile(values, friction, law);
  fill_draws(values, law);
  return law;
}

}  // namespace erg
