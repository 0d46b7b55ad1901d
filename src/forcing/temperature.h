// The temperature over a run: from a first to a last value along a curve that people bend.
#pragma once

#include "core/bezier.h"

namespace erg {

/// A course of temperature.
struct Temperature {
  double first = -10;  ///< deg C, in the first time step
  double last = -10;   ///< deg C, in the last one
  BezierCurve curve;

  /// `share` of the run that is past, 0 to 1 (outside: as at the nearer end).
  double at(double share) const { return first + (last - first) * curve.at(share); }
  bool operator==(const Temperature&) const = default;
};

/// Lowest and highest temperature that a run may have, deg C.
inline constexpr double lowest_temperature = -60;
inline constexpr double highest_temperature = 0;

}  // namespace erg
