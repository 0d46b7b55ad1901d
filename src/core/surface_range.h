// How far up and down a terrain's columns reach.
#pragma once

#include <cstdint>

#include "core/terrain.h"

namespace erg {

struct SurfaceRange {
  std::int32_t low = 0;   ///< quanta: the lowest point of the surface
  std::int32_t high = 0;  ///< quanta: its highest point
};
/// The terrain must have a cell.
SurfaceRange surface_range(const Terrain& terrain);

/// Quanta. The terrain must have a cell.
std::int32_t lowest_bedrock(const Terrain& terrain);

}  // namespace erg
