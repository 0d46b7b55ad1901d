// Patches of thick sand: cells that touch each other, whole across the torus' edge.
#pragma once

#include <cstdint>
#include <vector>

#include "core/terrain.h"

namespace erg::analysis {

/// A cell of the endless plane that the torus tiles; on open ground a cell of the grid.
struct PatchCell {
  int x = 0;
  int y = 0;
  bool operator==(const PatchCell&) const = default;
};

/// The patches of a terrain.
struct SandPatches {
  std::vector<std::vector<PatchCell>> whole;  ///< each without jumps at the torus' edge
  std::int64_t endless = 0;                   ///< how many reach around the torus and meet themselves
  std::int64_t cut = 0;                       ///< how many an open edge cuts off
};

/// All patches of at least `smallest` cells whose mobile layer is at least `least` quanta thick. Cells belong together
/// that touch along rows and columns.
SandPatches find_patches(const Terrain& terrain, std::int32_t least, std::int64_t smallest);

}  // namespace erg::analysis
