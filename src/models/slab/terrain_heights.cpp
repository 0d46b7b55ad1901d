#include "models/slab/terrain_heights.h"

#include <algorithm>

#include "core/errors.h"

namespace erg::models {

TerrainHeights check_height(const Terrain& terrain) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  TerrainHeights heights;
  heights.lowest = *std::min_element(bedrock.begin(), bedrock.end());
  std::int64_t highest = 0;
  for (std::size_t cell = 0; cell < mobile.size(); ++cell) {
    highest = std::max<std::int64_t>(highest, static_cast<std::int64_t>(bedrock[cell]) + mobile[cell] - heights.lowest);
    heights.relief = heights.relief || bedrock[cell] != heights.lowest;
    heights.bedrock_total += bedrock[cell];
    heights.mobile_total += mobile[cell];
  }
  if (highest > highest_terrain) {
    throw InputError("terrain",
                     "it rises " + std::to_string(highest) + " slabs, more than " + std::to_string(highest_terrain),
                     "use a larger slab height or a lower terrain");
  }
  heights.highest = static_cast<std::int32_t>(highest);
  return heights;
}

}  // namespace erg::models
