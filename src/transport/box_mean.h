// Means over squares of cells, as exact integer sums: the same for any number of threads and however the grid is
// turned.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.h"
#include "core/terrain.h"
#include "transport/executor.h"

namespace erg {

/// out = sum of `in` over the square of 2 radius + 1 cells around each cell. Over the edges the grid goes on (torus) or
/// repeats its outermost cells (open). `scratch` is for the work only.
void box_sum(Extent extent, Boundary boundary, int radius, const std::vector<std::int64_t>& in,
             std::vector<std::int64_t>& scratch, std::vector<std::int64_t>& out, Executor& executor);

}  // namespace erg
