#include "core/surface_range.h"

#include <algorithm>

namespace erg {

SurfaceRange surface_range(const Terrain& terrain) {
  check_surface(terrain);
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  SurfaceRange range{terrain.height(0, 0), terrain.height(0, 0)};
  for (std::size_t cell = 0; cell < bedrock.size(); ++cell) {
    const std::int32_t height = bedrock[cell] + mobile[cell];
    range.low = std::min(range.low, height);
    range.high = std::max(range.high, height);
  }
  return range;
}

std::int32_t lowest_bedrock(const Terrain& terrain) {
  check_surface(terrain);
  return *std::ranges::min_element(terrain.bedrock().cells());
}

}  // namespace erg
