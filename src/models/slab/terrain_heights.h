// How high a terrain of slabs reaches.
#pragma once

#include <cstdint>

#include "core/terrain.h"

namespace erg::models {

/// The highest cell over the lowest bedrock that slabs are moved over, in slabs: 16 bits, with room for what a step may
/// add.
inline constexpr int highest_terrain = 40000;
/// What needs to be known of a terrain before its slabs are moved.
struct TerrainHeights {
  std::int32_t lowest = 0;   ///< bedrock
  std::int32_t highest = 0;  ///< surface, over the lowest bedrock
  bool relief = false;       ///< the bedrock is not level
  std::int64_t bedrock_total = 0;
  std::int64_t mobile_total = 0;
};
/// Throws InputError if the highest cell stands more than `highest_terrain` over the lowest bedrock.
TerrainHeights check_height(const Terrain& terrain);

}  // namespace erg::models
