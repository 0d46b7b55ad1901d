// Where a line along an oblique wind stands in a row of the wind's frame: one rule for all that walk along lines.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/cell_rule.h"

namespace erg::kernels {

/// Columns by which line 0 has moved sideways in a row that may lie beyond the grid, in whole numbers:
/// floor((row * drift + phase) / length). `drift`: columns over all `length` rows; `phase`, of the same unit as
/// row * drift: where the line begins within its column.
ERG_CELL_RULE std::int32_t line_offset(std::int64_t row, std::int64_t drift, std::int64_t phase, std::int64_t length) {
  const std::int64_t scaled = row * drift + phase;
  return static_cast<std::int32_t>(scaled >= 0 ? scaled / length : -((-scaled + length - 1) / length));
}

/// The same for a line through the middle of its first cell that keeps to the wind exactly: `tangent` columns a row.
ERG_CELL_RULE int line_offset(int row, double tangent) { return static_cast<int>(std::floor(row * tangent + 0.5)); }

}  // namespace erg::kernels
