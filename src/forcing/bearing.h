// Wind bearings as maps have them: where the wind blows FROM, in degrees clockwise from north.
#pragma once

#include <string>
#include <string_view>

#include "core/units.h"

namespace erg::forcing {

/// A direction on the ground: x east, y north, length 1.
struct Direction {
  double x = 0;
  double y = 0;
};

/// The direction that a wind of this bearing blows TOWARD: 270 (west wind) gives (1, 0).
Direction downwind(double bearing);

/// The bearing of a wind that blows toward (x, y), in [0, 360).
double bearing_of(Direction toward);

/// What a bearing may be given as: at most this far from north either way, or a point of the compass.
inline constexpr double largest_bearing = 360;
inline constexpr const char* accepted_bearings = "-360 to 360 degrees, or a compass point such as W or NNE";

/// Reads "270", "-90", "W", "ssw", "west"; in [0, 360). Throws InputError with `place`.
double parse_bearing(std::string_view text, const std::string& place);

/// The nearest point of the compass in capitals: "WSW" for 250.
std::string compass_name(double bearing);

}  // namespace erg::forcing
