// How far a shadow reaches around a torus.
#pragma once

namespace erg::models {

/// Lengths of the grid over which a shadow falls at most: one of higher ground, on oblique lines that meet other cells
/// at each turn, would be endless work.
inline constexpr int longest_shadow = 16;

}  // namespace erg::models
