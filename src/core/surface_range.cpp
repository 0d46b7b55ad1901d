#include "core/surface_range.h"

#include <algorithm>

namespace erg {

SurfaceRange surface_range(const Terrain& terrain) {
  SurfaceRange range{terrain.height(0, 0), terrain.height(0, 0)};
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      range.low = std::min(range.low, terrain.height(x, y));
      range.high = std::max(range.high, terrain.height(x, y));
    }
  }
  return range;
}

}  // namespace erg
