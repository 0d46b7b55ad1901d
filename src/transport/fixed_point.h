// Heights of the shadow line and lengths of hops in fixed point, so that every executor rounds alike.
#pragma once

#include <cmath>
#include <cstdint>

namespace erg {

/// Binary places of the fixed-point numbers: 1/256 slab, 1/256 row.
inline constexpr int fixed_point_bits = 8;

inline std::int64_t fixed_point(double value) { return std::llround(value * (1 << fixed_point_bits)); }

/// A slab that has flown this many lengths of the grid lands wherever it is, so that chances of 0 cannot fly for ever.
inline constexpr int longest_flight = 16;

}  // namespace erg
