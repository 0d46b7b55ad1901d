// Where the cells of the wind's frame stand in the terrain's order.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/cell_rule.h"
#include "forcing/wind_frame.h"

namespace erg::kernels {

struct TerrainOrder {
  int width = 0;
  std::ptrdiff_t origin = 0;  ///< terrain cell of column 0, row 0; the others follow by these steps
  std::ptrdiff_t step_u = 0;
  std::ptrdiff_t step_v = 0;

  /// The place in the terrain of a cell (row * width + column) of the frame.
  ERG_CELL_RULE std::ptrdiff_t place(std::int32_t cell) const {
    return origin + cell % width * step_u + cell / width * step_v;
  }
};

TerrainOrder terrain_order(const forcing::WindFrame& frame);

}  // namespace erg::kernels
