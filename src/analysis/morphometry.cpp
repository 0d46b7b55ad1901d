#include "analysis/morphometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/surface_range.h"

namespace erg::analysis {
namespace {

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
  const SurfaceRange range = surface_range(terrain);
  const double origin = range.low;  // sums of differences from one height stay small on high ground
  double sum = 0;
  double squares = 0;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      const double height = terrain.height(x, y) - origin;
      sum += height;
      squares += height * height;
    }
  }
  const auto cells = static_cast<double>(terrain.extent().cells());
  const double mean = sum / cells;
  result.lowest = terrain.metres(range.low);
  result.highest = terrain.metres(range.high);
  result.sd_surface = std::sqrt(std::max(0.0, squares / cells - mean * mean)) * terrain.quantum();
}

}  // namespace

Morphometry measure(const Terrain& terrain) {
  check_whole(terrain);
  Morphometry result;
  if (terrain.extent().cells() == 0) return result;
  measure_mobile(terrain.mobile(), result);
  measure_heights(terrain, result);
  return result;
}

double shadow_fraction(const Grid<std::uint8_t>& shadow) {
  if (shadow.empty()) return 0;
  const auto dark = std::accumulate(shadow.cells().begin(), shadow.cells().end(), std::int64_t{0});
  return static_cast<double>(dark) / static_cast<double>(shadow.size());
}

}  // namespace erg::analysis
