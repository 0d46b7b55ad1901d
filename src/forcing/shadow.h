// Wind shadow of a terrain: which cells lie sheltered behind higher ground.
#pragma once

#include <cstdint>

#include "core/terrain.h"

namespace erg {

/// The fall of the shadow line behind a peak, in quanta a cell: tan(angle) * cell_size / quantum. `angle` in degrees
/// (15 in print).
double shadow_fall(double angle, double cell_size, double quantum);

/// 1 where a cell lies in shadow, else 0: some upwind cell at distance d (cells) is higher by more than d * fall. Reads
/// lines of cells along the wind at any bearing with true distances, but the adjacent cell counts as one unit away, so
/// that a slope of one slab shelters equally at every bearing. Torus terrains are closed.
Grid<std::uint8_t> shadow_map(const Terrain& terrain, double bearing, double fall);

/// The same as a field for pictures: "shadow".
Field shadow_field(const Terrain& terrain, double bearing, double fall);

}  // namespace erg
