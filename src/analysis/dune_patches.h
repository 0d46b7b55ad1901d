// Single dunes: patches of thick sand, how long and wide each is, and which way its arms point.
#pragma once

#include <cstdint>
#include <vector>

#include "core/terrain.h"

namespace erg {

/// One patch of cells that touch each other along rows and columns.
struct DunePatch {
  std::int64_t cells = 0;
  double length = 0;  ///< along the wind, cells: of an ellipse with the same spread of cells
  double width = 0;   ///< across the wind, likewise
  /// Mean of x y^2 over the spreads of x and y^2, with x downwind and y across from the patch's middle. Positive where
  /// the sides lie downwind of the middle (horns of a barchan), negative where they lie upwind (arms of a parabolic
  /// dune); 0 for an ellipse or a rectangle.
  double arms = 0;
};

/// All patches of `terrain` whose mobile layer is at least `least` quanta thick, of at least `smallest` cells, for a
/// wind from `bearing` (degrees). The grid counts as a torus; a patch that reaches around it has no ends and is left
/// out.
std::vector<DunePatch> find_dunes(const Terrain& terrain, double bearing, int least, std::int64_t smallest);

/// Means over patches, each counted by its cells; all 0 where there is none.
struct DuneMeans {
  double dunes = 0;
  double length_over_width = 0;
  double arms = 0;
};
DuneMeans mean_of_dunes(const std::vector<DunePatch>& dunes);

}  // namespace erg
