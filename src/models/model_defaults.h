// Where a run of a model begins.
#pragma once

namespace erg::models {

/// Degrees by which a wind swings whose dunes are to look alike at every bearing (docs/conventions.md says why).
inline constexpr double natural_spread = 10;

/// Cells, wind and sand that a config has where it does not say: so that the model's forms come out of them.
struct ModelDefaults {
  double cell_size = 1;  ///< m
  double strength = 5;   ///< of a constant wind
  double sand = 3;       ///< mean thickness of the mobile layer, slabs a cell
  double spread = 0;     ///< of the wind's bearing, degrees (WindInterval::spread)
};

}  // namespace erg::models
