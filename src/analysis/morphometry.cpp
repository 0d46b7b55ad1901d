#include "analysis/morphometry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/units.h"

namespace erg {
namespace {

// The neighbour one cell on, folded on a torus and held at an open edge.
int next_cell(int index, int step, int count, Boundary boundary) {
  if (boundary == Boundary::torus) return wrap(index + step, count);
  return std::clamp(index + step, 0, count - 1);
}

void measure_mobile(const Grid<std::int32_t>& mobile, Morphometry& result) {
  double sum = 0;
  double squares = 0;
  std::size_t bare = 0;
  for (const std::int32_t slabs : mobile.cells()) {
    result.max_slabs = std::max(result.max_slabs, slabs);
    sum += slabs;
    squares += static_cast<double>(slabs) * slabs;
    if (slabs == 0) ++bare;
  }
  const auto cells = static_cast<double>(mobile.size());
  result.mean_slabs = sum / cells;
  result.sd_slabs = std::sqrt(std::max(0.0, squares / cells - result.mean_slabs * result.mean_slabs));
  result.bare_fraction = static_cast<double>(bare) / cells;
}

void measure_heights(const Terrain& terrain, Morphometry& result) {
  std::int32_t low = terrain.height(0, 0);
  std::int32_t high = low;
  const double origin = low;  // sums of differences from one height stay small on high ground
  double sum = 0;
  double squares = 0;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      const std::int32_t height = terrain.height(x, y);
      low = std::min(low, height);
      high = std::max(high, height);
      sum += height - origin;
      squares += (height - origin) * (height - origin);
    }
  }
  const auto cells = static_cast<double>(terrain.extent().cells());
  const double mean = sum / cells;
  result.lowest = terrain.metres(low);
  result.highest = terrain.metres(high);
  result.sd_surface = std::sqrt(std::max(0.0, squares / cells - mean * mean)) * terrain.quantum();
}

void measure_slopes(const Terrain& terrain, Morphometry& result) {
  const double scale = terrain.quantum() / terrain.cell_size();
  std::int64_t largest_step = 0;
  double sum = 0;
  for (int y = 0; y < terrain.ny(); ++y) {
    const int north = next_cell(y, 1, terrain.ny(), terrain.boundary());
    const int south = next_cell(y, -1, terrain.ny(), terrain.boundary());
    for (int x = 0; x < terrain.nx(); ++x) {
      const int east = next_cell(x, 1, terrain.nx(), terrain.boundary());
      const int west = next_cell(x, -1, terrain.nx(), terrain.boundary());
      const std::int64_t here = terrain.height(x, y);
      largest_step =
          std::max({largest_step, std::abs(terrain.height(east, y) - here), std::abs(terrain.height(x, north) - here)});
      const double rise_x = 0.5 * (terrain.height(east, y) - terrain.height(west, y));
      const double rise_y = 0.5 * (terrain.height(x, north) - terrain.height(x, south));
      sum += degrees(std::atan(std::hypot(rise_x, rise_y) * scale));
    }
  }
  result.steepest_slope = degrees(std::atan(static_cast<double>(largest_step) * scale));
  result.mean_slope = sum / static_cast<double>(terrain.extent().cells());
}

}  // namespace

Morphometry measure(const Terrain& terrain) {
  Morphometry result;
  if (terrain.extent().cells() == 0) return result;
  measure_mobile(terrain.mobile(), result);
  measure_heights(terrain, result);
  measure_slopes(terrain, result);
  return result;
}

double shadow_fraction(const Grid<std::uint8_t>& shadow) {
  if (shadow.empty()) return 0;
  const auto dark = std::accumulate(shadow.cells().begin(), shadow.cells().end(), std::int64_t{0});
  return static_cast<double>(dark) / static_cast<double>(shadow.size());
}

}  // namespace erg
