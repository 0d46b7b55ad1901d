// How far upwind a shadow can come from: one rule for all that look for shadow along lines of a torus.
#pragma once

#include "core/cell_rule.h"

namespace erg::kernels {

/// Lengths of the grid over which a shadow falls at most: one of higher ground, on oblique lines that meet other cells
/// at each turn, would be endless work.
inline constexpr int longest_shadow = 16;

/// Rows upwind of a cell on a torus in which a shadow is looked for at most. A line along an axis meets the same cells
/// again behind one length.
ERG_CELL_RULE int rows_around(int length, double tangent) { return (tangent > 0 ? longest_shadow : 1) * length; }

/// Rows before the grid at which lines that look for shadow begin: those in which a shadow line falls from the highest
/// surface to the lowest, `relief` below it, and some for what is rounded; at most `longest`, from where a line has met
/// all that it meets. `fall`: of the line for each cell of its way, in the unit of `relief`; `cosine`: cells of a row
/// for each cell of the way. Who begins further away finds the same shadow.
ERG_CELL_RULE int shadow_reach(double relief, double fall, double cosine, int longest) {
  const double reach = relief * cosine / (fall > 1e-12 ? fall : 1e-12) + 3;
  return reach < longest ? static_cast<int>(reach) : longest;
}

}  // namespace erg::kernels
