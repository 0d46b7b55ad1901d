// Constants of nature that models share, in one place.
#pragma once

namespace erg {

/// Von Karman's constant, a pure number: the wind over ground grows by (friction velocity / karman) times the logarithm
/// of height. 0.4 as in Bagnold (1941) and Pomeroy & Gray (1990).
inline constexpr double karman = 0.4;

/// Weight of a kilogram on the Earth, m/s2: standard gravity (ISO 80000-3, 9.80665), rounded.
inline constexpr double earth_gravity = 9.81;

}  // namespace erg
