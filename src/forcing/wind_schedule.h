// The wind over time: a list of seasons that repeats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "forcing/channels.h"

namespace erg::forcing {

/// Draws in whose mean a season's wind has its bearing exactly.
inline constexpr std::size_t draws_a_round = 16;
/// The swings of a wind with this spread, degrees clockwise, in rising order: the quantiles (k + 1/2) / 16 of a normal
/// distribution, scaled to this standard deviation.
std::array<double, draws_a_round> wind_swings(double spread);
/// The swing of draw number `draw` (from 0) of a season's wind: each 16 draws are all of its swings, in random order.
/// `season` is its place in the list.
double wind_swing(double spread, std::size_t season, std::uint64_t seed, std::int64_t draw);

/// A repeating list of seasons, never empty. One season is a constant wind (or one that repeats its curve).
struct WindSchedule {
  std::vector<WindInterval> intervals{WindInterval{}};

  /// A wind that never changes: one season without spread.
  static WindSchedule constant(double bearing, double strength);
  /// True for one season whose strength does not change (its bearing may swing).
  bool is_constant() const;
  /// Steps until the list repeats.
  std::int64_t cycle() const;
  /// The wind during time step `step` (0 is the first). Within a season of n steps, step k is at time k / (n - 1) of
  /// the curve (n > 1), so that first and last strength are both reached. Without a swing: the season's mean bearing.
  Forcing at(std::int64_t step) const { return wind_at(step, nullptr); }
  /// The same with the swing that this step has in a run with this seed. A season's draws are counted over its own
  /// steps, and go on where it returns.
  Forcing at(std::int64_t step, std::uint64_t seed) const { return wind_at(step, &seed); }
  bool operator==(const WindSchedule&) const = default;

 private:
  Forcing wind_at(std::int64_t step, const std::uint64_t* seed) const;
};

}  // namespace erg::forcing
