// Means over squares of cells from exact whole sums: the same for any number of threads and however the grid is turned.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.h"
#include "core/terrain.h"
#include "transport/executor.h"

namespace erg {

/// What a sum over a box is multiplied with to be the mean of its cells; `twice`: a sum of sums.
float box_share(int radius, bool twice);

class BoxMean {
 public:
  /// means = means over the squares of 2 radius + 1 cells around each cell; with `twice` the means of these means. Over
  /// the edges the grid goes on (torus) or repeats its outermost cells (open). No number may be over `most`.
  void measure(Extent extent, Boundary boundary, int radius, bool twice, const std::vector<std::uint32_t>& numbers,
               std::uint32_t most, std::vector<float>& means, Executor& executor);

 private:
  std::vector<std::uint32_t> sums_;
  std::vector<std::uint64_t> wide_sums_;  ///< where 32 bits cannot hold the sums
};

}  // namespace erg
