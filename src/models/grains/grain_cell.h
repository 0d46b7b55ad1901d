// The rules of one grain: how it leaves the ground, flies, bounces, knocks others loose and comes to rest. Shared by
// every executor, so plain functions of plain data: + - * / and square roots only, all else from tables of the host.
//
// A grain here is a parcel: what raises its cell by one quantum. It sees a frozen ground and changes whole numbers
// only, so the order of grains does not matter. Places are cells of the wind's frame (u across, v along; cell i spans i
// to i + 1), heights and speeds metric.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/cell_rule.h"
#include "core/random.h"

namespace erg::models {

/// The frozen ground in one cell.
struct GroundPoint {
  float height = 0;        ///< m
  float shadow = 0;        ///< m: there is no wind below this height
  float wind = 1;          ///< share of the wind that plants leave
  std::int32_t loose = 0;  ///< grains that can leave
};

/// The frozen ground: a plane of (width + 2) x (length + 2) points, u fastest, with a rim of one cell all round that
/// repeats what lies beyond the edge.
struct SurfaceSnapshot {
  const GroundPoint* points = nullptr;
  int width = 0;
  int length = 0;
  bool torus = true;
  double base = 0;  ///< m: what the points' heights count from

  ERG_CELL_RULE const GroundPoint& of_cell(int u, int v) const {
    return points[static_cast<std::int64_t>(v + 1) * (width + 2) + u + 1];
  }
};

/// Sizes of the tables in a GrainLaw.
inline constexpr int profile_parts = 8;     ///< nodes an octave of height
inline constexpr int profile_lowest = -22;  ///< the first node stands 2^-22 m above the ground
inline constexpr int profile_octaves = 30;
inline constexpr int profile_nodes = profile_parts * profile_octaves + 1;
inline constexpr int draw_nodes = 256;  ///< entries of tables that turn a random number into something

/// Everything that decides how grains move in this wind. Nothing blows until all of it is given.
struct GrainLaw {
  float toward_u = 0;  ///< the wind's direction in the frame, length 1
  float toward_v = 1;
  float friction_velocity = 0;  ///< m/s
  float cells_a_metre = 0;
  float gravity = 0;      ///< m/s2
  float time_step = 0;    ///< s
  int longest_steps = 0;  ///< of one flight

  float lift_low = 0;  ///< lift-off speed upward over friction velocity, smallest and range
  float lift_range = 0;
  float damping_normal = 0;  ///< speed kept in a bounce, across and along the ground
  float damping_along = 0;
  float stop_speed_squared = 0;
  int bounce_limit = 0;
  float splash = 0;                ///< most grains that one impact knocks loose
  float splash_speed_squared = 0;  ///< (m/s)^2, of an impact that knocks half as many loose
  float reptation_cells = 0;       ///< mean reptation for an impact of 1 m/s in this wind, cells
  float reptation_slope = 0;       ///< how much a rise of 1 shortens it; cotangent of the angle it starts at
  float sideways = 0;              ///< share of reptating grains that go across the wind
  float rolling = 0;               ///< chance to roll to a lower neighbour, for a slope of 1

  float wind_speed[profile_nodes] = {};  ///< m/s at the heights of the nodes above the ground
  float cotangent[draw_nodes] = {};      ///< of the lift-off angle
  float exponential[draw_nodes] = {};    ///< quantiles of the exponential distribution of mean 1
  float drag[draw_nodes] = {};           ///< 1/m: deceleration over relative speed squared, by quantile of the size
  float viscous[draw_nodes] = {};        ///< 1/s: deceleration over relative speed, by quantile of the size
  float threshold[draw_nodes] = {};      ///< m/s: smallest friction velocity that lifts a grain of this quantile
};

/// Random numbers of one grain, drawn one after the other from a key of its own.
struct GrainDice {
  std::uint64_t word;

  ERG_CELL_RULE std::uint64_t next() { return word = mix64(word); }
  /// In [0, 1), 24 random bits.
  ERG_CELL_RULE float unit() { return static_cast<float>(next() >> 40) * 0x1.0p-24f; }
  /// An entry of a table of draw_nodes.
  ERG_CELL_RULE int node() { return static_cast<int>(next() >> 56); }
};

/// A grain in the air.
struct Grain {
  float u = 0;  ///< cells
  float v = 0;
  float z = 0;        ///< m
  float speed_u = 0;  ///< m/s
  float speed_v = 0;
  float speed_z = 0;
  float drag = 0;     ///< 1/m
  float viscous = 0;  ///< 1/s
  float mixed = 0;    ///< 1/sqrt(m s): the part of the drag that grows with the root of the relative speed
  float along = 0;    ///< m flown downwind so far
};

/// The ground under a point between cell centres.
struct GroundSpot {
  float height;
  float shadow;
  float wind;
  float slope_u;  ///< rise over run
  float slope_v;
};

enum class FlightEnd {
  rested,
  left,    ///< over an open edge
  cut_off  ///< flew longer than allowed and was put down where it was
};

/// What happened in a flight, in whole numbers so that sums do not depend on their order.
struct FlightCounters {
  std::int64_t grain_steps = 0;
  std::int64_t impacts = 0;
  std::int64_t hop_micrometres = 0;     ///< flown downwind between touches of the ground, summed
  std::int64_t angle_microradians = 0;  ///< between flight and level at impacts, summed
  std::int64_t splashed = 0;            ///< grains that impacts asked for
};

/// Folds a coordinate back onto a torus of `period` cells.
ERG_CELL_RULE float fold(float place, float period) {
  while (place < 0) place += period;
  while (place >= period) place -= period;
  return place;
}

/// The cell that holds a coordinate in [0, cells]; adding the period to a tiny negative number may round up to it.
ERG_CELL_RULE int cell_of(float place, int cells) {
  const int cell = static_cast<int>(place);
  return cell < cells ? cell : cells - 1;
}

/// The ground at (u, v), between cell centres by bilinear interpolation.
ERG_CELL_RULE GroundSpot ground_at(const SurfaceSnapshot& ground, float cells_a_metre, float u, float v) {
  const int column = static_cast<int>(u + 0.5f);  // of the plane with its rim
  const int row = static_cast<int>(v + 0.5f);
  const float right = u + 0.5f - static_cast<float>(column);
  const float ahead = v + 0.5f - static_cast<float>(row);
  const GroundPoint* here = ground.points + static_cast<std::int64_t>(row) * (ground.width + 2) + column;
  const GroundPoint* next = here + ground.width + 2;
  const float near_rise = here[1].height - here[0].height;
  const float far_rise = next[1].height - next[0].height;
  const float near = here[0].height + near_rise * right;
  const float far = next[0].height + far_rise * right;
  const float near_shadow = here[0].shadow + (here[1].shadow - here[0].shadow) * right;
  const float far_shadow = next[0].shadow + (next[1].shadow - next[0].shadow) * right;
  const float near_wind = here[0].wind + (here[1].wind - here[0].wind) * right;
  const float far_wind = next[0].wind + (next[1].wind - next[0].wind) * right;
  return {near + (far - near) * ahead, near_shadow + (far_shadow - near_shadow) * ahead,
          near_wind + (far_wind - near_wind) * ahead, (near_rise + (far_rise - near_rise) * ahead) * cells_a_metre,
          (far - near) * cells_a_metre};
}

/// Wind speed (m/s) at a height (m) above the ground. The bits of a positive float grow with its logarithm, piece by
/// piece linearly, so they are the place in a table of the log profile.
ERG_CELL_RULE float wind_at(const GrainLaw& law, float height) {
  constexpr std::uint32_t mantissa_bits = 20;  // 23, less three for eight parts an octave
  constexpr std::int32_t first = (127 + profile_lowest) * profile_parts;
  if (!(height > 0)) return 0;
  const std::uint32_t bits = __builtin_bit_cast(std::uint32_t, height);  // std::bit_cast is the host's alone
  const std::int32_t node = static_cast<std::int32_t>(bits >> mantissa_bits) - first;
  if (node < 0) return 0;
  if (node >= profile_nodes - 1) return law.wind_speed[profile_nodes - 1];
  const float share = static_cast<float>(bits & ((1u << mantissa_bits) - 1)) * 0x1.0p-20f;
  return law.wind_speed[node] + share * (law.wind_speed[node + 1] - law.wind_speed[node]);
}

/// The arc tangent of a positive number, radians, within 0.005 (Rajan et al. 2006 give the form for up to 1).
ERG_CELL_RULE float arc_tangent(float ratio) {
  constexpr float quarter_turn = 1.57079633f;
  if (ratio <= 1) return ratio / (1 + 0.28f * ratio * ratio);
  return quarter_turn - ratio / (ratio * ratio + 0.28f);
}

/// Makes the grain one of this quantile of sizes.
ERG_CELL_RULE void give_size(const GrainLaw& law, int size, Grain& grain) {
  grain.drag = law.drag[size];
  grain.viscous = law.viscous[size];
  grain.mixed = 2 * std::sqrt(grain.drag * grain.viscous);
}

/// Sets a grain off from a random place in the cell, in the local wind.
ERG_CELL_RULE void set_off(const GrainLaw& law, const SurfaceSnapshot& ground, int u, int v, GrainDice& dice,
                           Grain& grain) {
  grain.u = static_cast<float>(u) + dice.unit();
  grain.v = static_cast<float>(v) + dice.unit();
  const GroundSpot spot = ground_at(ground, law.cells_a_metre, grain.u, grain.v);
  const float upward = (law.lift_low + law.lift_range * dice.unit()) * law.friction_velocity * spot.wind;
  const float forward = upward * law.cotangent[dice.node()];
  grain.z = spot.height;
  grain.speed_u = forward * law.toward_u;
  grain.speed_v = forward * law.toward_v;
  grain.speed_z = upward + grain.speed_u * spot.slope_u + grain.speed_v * spot.slope_v;  // relative to the ground
  grain.along = 0;
  give_size(law, dice.node(), grain);
}

/// Sets a grain of the cell off into the air. False where none can leave: nothing loose, shelter, too weak a wind.
ERG_CELL_RULE bool lift_off(const GrainLaw& law, const SurfaceSnapshot& ground, int u, int v, GrainDice& dice,
                            Grain& grain) {
  const GroundPoint& cell = ground.of_cell(u, v);
  const int size = dice.node();
  if (cell.loose < 1 || cell.height < cell.shadow || law.friction_velocity * cell.wind < law.threshold[size]) {
    return false;
  }
  set_off(law, ground, u, v, dice, grain);
  give_size(law, size, grain);
  return true;
}

/// Turns the velocity of a grain that hits the ground: the part across the ground is reversed and damped, the part
/// along it damped. A grain that already moves away keeps its velocity.
ERG_CELL_RULE void bounce(const GrainLaw& law, const GroundSpot& spot, Grain& grain) {
  const float squared = 1 + spot.slope_u * spot.slope_u + spot.slope_v * spot.slope_v;
  const float into = (grain.speed_z - grain.speed_u * spot.slope_u - grain.speed_v * spot.slope_v) / squared;
  if (into >= 0) return;
  const float across_u = -spot.slope_u * into;
  const float across_v = -spot.slope_v * into;
  grain.speed_u = (grain.speed_u - across_u) * law.damping_along - across_u * law.damping_normal;
  grain.speed_v = (grain.speed_v - across_v) * law.damping_along - across_v * law.damping_normal;
  grain.speed_z = (grain.speed_z - into) * law.damping_along - into * law.damping_normal;
}

/// One time step of free flight in the wind over `spot`, the ground under the grain. The drag is implicit, so that no
/// step is too long for it.
ERG_CELL_RULE void advance(const GrainLaw& law, const GroundSpot& spot, Grain& grain) {
  const float wind = grain.z > spot.shadow ? wind_at(law, grain.z - spot.height) * spot.wind : 0.0f;
  const float against_u = wind * law.toward_u - grain.speed_u;
  const float against_v = wind * law.toward_v - grain.speed_v;
  const float relative = std::sqrt(against_u * against_u + against_v * against_v + grain.speed_z * grain.speed_z);
  const float pull = (grain.drag * relative + grain.mixed * std::sqrt(relative) + grain.viscous) * law.time_step;
  const float kept = 1 / (1 + pull);
  grain.speed_u += against_u * pull * kept;
  grain.speed_v += against_v * pull * kept;
  grain.speed_z = (grain.speed_z - law.gravity * law.time_step) * kept;
}

/// Moves the grain on by `seconds` at its speed. False when it left over an open edge.
ERG_CELL_RULE bool drift(const GrainLaw& law, const SurfaceSnapshot& ground, Grain& grain, float seconds) {
  const float cells = seconds * law.cells_a_metre;
  const auto width = static_cast<float>(ground.width);
  const auto length = static_cast<float>(ground.length);
  grain.u += grain.speed_u * cells;
  grain.v += grain.speed_v * cells;
  grain.z += grain.speed_z * seconds;
  grain.along += (grain.speed_u * law.toward_u + grain.speed_v * law.toward_v) * seconds;
  if (ground.torus) {
    grain.u = fold(grain.u, width);
    grain.v = fold(grain.v, length);
    return true;
  }
  return grain.u >= 0 && grain.u < width && grain.v >= 0 && grain.v < length;
}

/// Flies a grain until it rests, leaves or is cut off. `watch` is told of every point of the way (`at(grain)`) and of
/// every impact (`impact(cell_u, cell_v, grains, speed)`: so many grains are knocked loose there).
template <typename Watch>
ERG_CELL_RULE FlightEnd fly(const GrainLaw& law, const SurfaceSnapshot& ground, Grain& grain, GrainDice& dice,
                            FlightCounters& sums, Watch& watch) {
  GroundSpot spot = ground_at(ground, law.cells_a_metre, grain.u, grain.v);
  float clearance = 0;
  float hop_from = 0;
  int bounces = 0;
  watch.at(grain);
  for (int step = 0; step < law.longest_steps; ++step) {
    ++sums.grain_steps;
    advance(law, spot, grain);
    if (!drift(law, ground, grain, law.time_step)) return FlightEnd::left;
    spot = ground_at(ground, law.cells_a_metre, grain.u, grain.v);
    const float below = spot.height - grain.z;
    if (below <= 0) {
      clearance = -below;
      watch.at(grain);
      continue;
    }
    // Back to where it met the ground.
    if (!drift(law, ground, grain, -law.time_step * (below / (below + clearance)))) return FlightEnd::left;
    spot = ground_at(ground, law.cells_a_metre, grain.u, grain.v);
    grain.z = spot.height;
    clearance = 0;
    watch.at(grain);
    const float level_squared = grain.speed_u * grain.speed_u + grain.speed_v * grain.speed_v;
    const float squared = level_squared + grain.speed_z * grain.speed_z;
    const float level = std::sqrt(level_squared);
    const float downward = grain.speed_z < 0 ? -grain.speed_z : 0.0f;
    ++sums.impacts;
    sums.hop_micrometres += static_cast<std::int64_t>((grain.along - hop_from) * 1e6f);
    sums.angle_microradians += static_cast<std::int64_t>(arc_tangent(downward / (level + 1e-6f)) * 1e6f);
    hop_from = grain.along;
    const int loosened = static_cast<int>(law.splash * squared / (squared + law.splash_speed_squared) + dice.unit());
    sums.splashed += loosened;
    watch.impact(cell_of(grain.u, ground.width), cell_of(grain.v, ground.length), loosened, std::sqrt(squared));
    bounce(law, spot, grain);
    ++bounces;
    const float left_squared =
        grain.speed_u * grain.speed_u + grain.speed_v * grain.speed_v + grain.speed_z * grain.speed_z;
    if (left_squared < law.stop_speed_squared || spot.height < spot.shadow || bounces >= law.bounce_limit) {
      return FlightEnd::rested;
    }
  }
  return FlightEnd::cut_off;
}

/// A cell of the frame.
struct BedCell {
  int u;
  int v;
};

/// Where a grain that comes down at (grain.u, grain.v) stays: there, or in a lower neighbour that it rolls into, with a
/// chance that grows with the slope. So hollows of a cell fill up first.
ERG_CELL_RULE BedCell resting_place(const GrainLaw& law, const SurfaceSnapshot& ground, const Grain& grain,
                                    GrainDice& dice) {
  BedCell place{cell_of(grain.u, ground.width), cell_of(grain.v, ground.length)};
  const int way = static_cast<int>(dice.next() >> 62);
  const int next_u = place.u + (way == 0 ? 1 : way == 1 ? -1 : 0);
  const int next_v = place.v + (way == 2 ? 1 : way == 3 ? -1 : 0);
  const bool inside = next_u >= 0 && next_u < ground.width && next_v >= 0 && next_v < ground.length;
  if (!inside && !ground.torus) return place;
  const float fall = ground.of_cell(place.u, place.v).height - ground.of_cell(next_u, next_v).height;
  if (dice.unit() >= law.rolling * fall * law.cells_a_metre) return place;
  place.u = next_u < 0 ? ground.width - 1 : next_u >= ground.width ? 0 : next_u;
  place.v = next_v < 0 ? ground.length - 1 : next_v >= ground.length ? 0 : next_v;
  return place;
}

/// How far (cells) a grain gets from (u, v) along a direction of length 1, in a parabola that would end after `level`
/// cells on level ground: shorter uphill, longer downhill and over a crest.
ERG_CELL_RULE float way_over_ground(const GrainLaw& law, const SurfaceSnapshot& ground, float u, float v, float step_u,
                                    float step_v, float level) {
  constexpr int longest = 1000;  // cells; only so that no loop is without end
  const GroundSpot start = ground_at(ground, law.cells_a_metre, u, v);
  const float eased = 1 - law.reptation_slope * (start.slope_u * step_u + start.slope_v * step_v);
  const float share = eased > 0.1f ? eased : 0.1f;
  // On a straight slope the parabola ends here; so it does where that is near, or where hops are not to feel the
  // ground.
  if (level * share < 1 || law.reptation_slope <= 0) return level * share;
  const auto width = static_cast<float>(ground.width);
  const auto length = static_cast<float>(ground.length);
  const float rise = 1 / (law.reptation_slope * law.cells_a_metre);  // of the parabola at its start, m a cell
  float above = rise * share;  // m; stands for the curve up to the first cell, where the parabola begins on the ground
  for (int cells = 1; cells <= longest; ++cells) {
    const auto flown = static_cast<float>(cells);
    float ahead_u = u + flown * step_u;
    float ahead_v = v + flown * step_v;
    if (ground.torus) {
      ahead_u = fold(ahead_u, width);
      ahead_v = fold(ahead_v, length);
    } else if (ahead_u < 0 || ahead_u >= width || ahead_v < 0 || ahead_v >= length) {
      return flown;
    }
    const float now = start.height + rise * flown * (1 - flown / level) -
                      ground_at(ground, law.cells_a_metre, ahead_u, ahead_v).height;
    if (now < 0) return flown - 1 + above / (above - now);
    above = now;
  }
  return static_cast<float>(longest);
}

/// Where a grain goes that an impact of this speed (m/s) knocked loose from the cell: a short, low hop along the wind
/// or across it. Sets grain.u, grain.v and grain.along; false when it left over an open edge.
ERG_CELL_RULE bool reptate(const GrainLaw& law, const SurfaceSnapshot& ground, int u, int v, float speed,
                           GrainDice& dice, Grain& grain) {
  const float aside = dice.unit();
  const bool straight = aside >= law.sideways;
  const float hand = aside < 0.5f * law.sideways ? 1.0f : -1.0f;
  const float step_u = straight ? law.toward_u : hand * law.toward_v;
  const float step_v = straight ? law.toward_v : -hand * law.toward_u;
  const float start_u = static_cast<float>(u) + dice.unit();
  const float start_v = static_cast<float>(v) + dice.unit();
  const float level = law.reptation_cells * speed * law.exponential[dice.node()];
  const float way = way_over_ground(law, ground, start_u, start_v, step_u, step_v, level);
  grain.u = start_u + way * step_u;
  grain.v = start_v + way * step_v;
  grain.along = straight ? way / law.cells_a_metre : 0.0f;
  const auto width = static_cast<float>(ground.width);
  const auto length = static_cast<float>(ground.length);
  if (ground.torus) {
    grain.u = fold(grain.u, width);
    grain.v = fold(grain.v, length);
    return true;
  }
  return grain.u >= 0 && grain.u < width && grain.v >= 0 && grain.v < length;
}

}  // namespace erg::models
