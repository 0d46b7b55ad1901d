// Heights of the shadow line and lengths of hops in fixed point, so that every executor rounds alike.
#pragma once

#include <cstdint>

#include "core/cell_rule.h"

namespace erg::kernels {

/// Binary places of the fixed-point numbers: 1/256 slab, 1/256 row.
inline constexpr int fixed_point_bits = 8;

/// The nearest fixed-point number; halves go away from zero.
ERG_CELL_RULE std::int64_t fixed_point(double value) {
  const double scaled = value * (1 << fixed_point_bits);
  const auto whole = static_cast<std::int64_t>(scaled);
  const double rest = scaled - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

}  // namespace erg::kernels
