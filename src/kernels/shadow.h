// Wind shadow of a terrain: which cells lie sheltered behind higher ground.
#pragma once

#include <cstdint>

#include "core/terrain.h"
#include "forcing/wind_frame.h"

namespace erg::kernels {

/// The fall of the shadow line behind a peak, in quanta a cell: tan(angle) * cell_size / quantum. `angle` in degrees
/// (15 in print).
double shadow_fall(double angle, double cell_size, double quantum);

/// How far the shadow line has fallen, in quanta, from the ground one row upwind of a cell, from the second row, and
/// with each row from the third on.
struct ShadowFalls {
  double next;
  double second;
  double row;
};

/// The falls on the lines of a frame, for a shadow line that falls by `fall` quanta a cell.
///
/// Along an axis a step of one slab up to the next cell casts shadow, as in print. Under an oblique wind the next cell
/// stands straight ahead or on the diagonal, far from the wind's direction: by the same rule the flanks of a dune would
/// stay lit only between axis and diagonal, and it would lean. So it is the second row that counts as one cell away,
/// and the next one as four rows: sand does not stand that steeply, but a wall still casts shadow on the cell behind
/// it.
ShadowFalls shadow_falls(const forcing::WindFrame& frame, double fall);

/// 1 where a cell lies in shadow, else 0: some upwind cell at distance d (cells) is higher by more than d * fall, but
/// for the nearest two (shadow_falls). Reads lines of cells along the wind at any bearing. Torus terrains are closed.
Grid<std::uint8_t> shadow_map(const Terrain& terrain, double bearing, double fall);

/// The same as a field for pictures: "shadow".
Field shadow_field(const Terrain& terrain, double bearing, double fall);

}  // namespace erg::kernels
