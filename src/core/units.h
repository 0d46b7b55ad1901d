// Angles, times and rounding, in one place.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace erg {

/// An angle in the other unit.
inline double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
inline double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

inline constexpr double seconds_a_day = 86400;
inline constexpr double seconds_a_year = 365.25 * seconds_a_day;

/// The same bearing (degrees) in [0, 360).
inline double fold_bearing(double degrees) {
  const double rest = std::fmod(degrees, 360.0);
  const double folded = rest < 0 ? rest + 360 : rest;
  return folded < 360 ? folded + 0.0 : 0.0;  // a tiny negative angle rounds up to 360; -0 becomes 0
}

/// The largest height step between neighbouring cells that still stands, in quanta, for an angle in degrees: a quantum
/// slides while the step exceeds it. tan(angle) * cell_size / quantum, rounded up (30 deg and slabs of a third of a
/// cell give 2, 33.7 deg gives 3).
inline int critical_step(double angle, double cell_size, double quantum) {
  return static_cast<int>(std::ceil(std::tan(radians(angle)) * cell_size / quantum - 1e-9));
}

}  // namespace erg
