// How far upwind a shadow can come from: one rule for all that look for shadow along lines of a torus.
#pragma once

#include "core/cell_rule.h"

namespace erg::kernels {

/// Rows before the grid at which lines that look for shadow begin: those in which a shadow line falls from the highest
/// surface to the lowest, `relief` below it, and some for what is rounded; at most `longest`, from where a line has met
/// all that it meets. `fall`: of the line for each cell of its way, in the unit of `relief`; `cosine`: cells of a row
/// for each cell of the way. Who begins further away finds the same shadow.
ERG_CELL_RULE int shadow_reach(double relief, double fall, double cosine, int longest) {
  const double reach = relief * cosine / (fall > 1e-12 ? fall : 1e-12) + 3;
  return reach < longest ? static_cast<int>(reach) : longest;
}

}  // namespace erg::kernels
