// The wind over time: a list of seasons that repeats.
#pragma once

#include <cstdint>
#include <vector>

#include "core/bezier.h"

namespace erg {

/// One season: the wind blows from one bearing for `steps` time steps, and its strength goes from `first` to `last`
/// along a curve. Strength is in cells per hop for slab models, m/s for the others.
struct Season {
  double bearing = 270;  ///< degrees, where it blows from
  double first = 5;
  double last = 5;
  std::int64_t steps = 1;
  BezierCurve curve;
  double snowfall = 0;  ///< mm of snow an hour, for snow models
  bool operator==(const Season&) const = default;
};

/// The wind of one time step, and what comes with it.
struct WindNow {
  double bearing = 270;
  double strength = 5;
  double temperature = -10;  ///< deg C
  double snowfall = 0;       ///< mm of snow an hour
  bool operator==(const WindNow&) const = default;
};

/// Smallest and largest strength that a season may have (cells a hop, or m/s).
inline constexpr double smallest_strength = 0.1;
inline constexpr double largest_strength = 8192;
/// The heaviest snowfall that a season may have, mm of snow an hour.
inline constexpr double heaviest_snowfall = 200;

/// A repeating list of seasons, never empty. One season is a constant wind (or one that repeats its curve).
struct Regime {
  std::vector<Season> seasons{Season{}};

  /// A wind that never changes.
  static Regime constant(double bearing, double strength);
  /// True for one season whose strength does not change.
  bool is_constant() const;
  /// Steps until the list repeats.
  std::int64_t cycle() const;
  /// The wind during time step `step` (0 is the first). Within a season of n steps, step k is at time k / (n - 1) of
  /// the curve (n > 1), so that first and last strength are both reached.
  WindNow at(std::int64_t step) const;
  bool operator==(const Regime&) const = default;
};

}  // namespace erg
