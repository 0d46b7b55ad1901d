// The wind over time: a list of seasons that repeats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/bezier.h"
#include "core/units.h"

namespace erg {

/// One season: the wind blows from one bearing for `steps` time steps, and its strength goes from `first` to `last`
/// along a curve. Strength is in cells per hop for slab models, m/s for the others. A real wind varies about its mean
/// bearing: with a `spread` each draw of `hold` steps has a bearing of its own.
struct Season {
  double bearing = 270;  ///< degrees, where it blows from (the mean)
  double first = 5;
  double last = 5;
  std::int64_t steps = 1;
  BezierCurve curve;
  double snowfall = 0;    ///< mm of snow an hour, for snow models
  double spread = 0;      ///< standard deviation of the bearing from draw to draw, degrees
  std::int64_t hold = 4;  ///< steps of the season for which a draw holds
  bool operator==(const Season&) const = default;
};

/// The wind of one time step, and what comes with it.
struct WindNow {
  double bearing = 270;
  double strength = 5;
  double temperature = -10;  ///< deg C
  double snowfall = 0;       ///< mm of snow an hour
  double swing = 0;          ///< degrees by which `bearing` lies clockwise of the season's
  /// The bearing about which the season's wind swings.
  double mean_bearing() const { return fold_bearing(bearing - swing); }
  bool operator==(const WindNow&) const = default;
};

/// Smallest and largest strength that a season may have (cells a hop, or m/s). 0 is a calm: time passes, nothing moves.
inline constexpr double smallest_strength = 0;
inline constexpr double largest_strength = 8192;
/// The heaviest snowfall that a season may have, mm of snow an hour.
inline constexpr double heaviest_snowfall = 200;
/// The widest spread that a season may have, degrees.
inline constexpr double widest_spread = 60;

/// Draws in whose mean a season's wind has its bearing exactly.
inline constexpr std::size_t draws_a_round = 16;
/// The swings of a wind with this spread, degrees clockwise, in rising order: the quantiles (k + 1/2) / 16 of a normal
/// distribution, scaled to this standard deviation.
std::array<double, draws_a_round> wind_swings(double spread);
/// The swing of draw number `draw` (from 0) of a season's wind: each 16 draws are all of its swings, in random order.
/// `season` is its place in the list.
double wind_swing(double spread, std::size_t season, std::uint64_t seed, std::int64_t draw);

/// A repeating list of seasons, never empty. One season is a constant wind (or one that repeats its curve).
struct Regime {
  std::vector<Season> seasons{Season{}};

  /// A wind that never changes: one season without spread.
  static Regime constant(double bearing, double strength);
  /// True for one season whose strength does not change (its bearing may swing).
  bool is_constant() const;
  /// Steps until the list repeats.
  std::int64_t cycle() const;
  /// The wind during time step `step` (0 is the first). Within a season of n steps, step k is at time k / (n - 1) of
  /// the curve (n > 1), so that first and last strength are both reached. Without a swing: the season's mean bearing.
  WindNow at(std::int64_t step) const { return wind_at(step, nullptr); }
  /// The same with the swing that this step has in a run with this seed. A season's draws are counted over its own
  /// steps, and go on where it returns.
  WindNow at(std::int64_t step, std::uint64_t seed) const { return wind_at(step, &seed); }
  bool operator==(const Regime&) const = default;

 private:
  WindNow wind_at(std::int64_t step, const std::uint64_t* seed) const;
};

}  // namespace erg
