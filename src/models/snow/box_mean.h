// Means over squares of cells from exact whole sums: the same for any number of threads and however the grid is turned.
#pragma once

#include <cstdint>
#include <memory>

#include "core/grid.h"
#include "core/terrain.h"

namespace erg {

struct SnowKernels;

/// What a sum over a box is multiplied with to be the mean of its cells; `twice`: a sum of sums.
float box_share(int radius, bool twice);

/// Numbers of which means are taken. Over the edges the grid goes on (torus) or repeats its outermost cells (open).
struct BoxGrid {
  Extent extent;
  Boundary boundary = Boundary::torus;
  const std::uint16_t* numbers = nullptr;
  std::uint16_t most = 0;  ///< none is over it
  const SnowKernels* kernels = nullptr;
};

/// Gives the means of one row after another.
class BoxMeans {
 public:
  virtual ~BoxMeans() = default;
  /// Those of the next row's cells.
  virtual void next(float* means) = 0;
};

/// Means over the squares of 2 radius + 1 cells around each cell, row by row from `first` on, which on a torus may lie
/// beyond its edge; with `twice` the means of these means.
std::unique_ptr<BoxMeans> box_means(const BoxGrid& grid, int radius, bool twice, int first);

}  // namespace erg
