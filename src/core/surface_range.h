// The lowest and the highest point of a surface.
#pragma once

#include <cstdint>

#include "core/terrain.h"

namespace erg {

struct SurfaceRange {
  std::int32_t low = 0;  ///< quanta
  std::int32_t high = 0;
};
/// Of the surface. The terrain must have a cell.
SurfaceRange surface_range(const Terrain& terrain);

}  // namespace erg
