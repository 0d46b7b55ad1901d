// Where a run of a model begins.
#pragma once

namespace erg {

/// Cells, wind and sand that a config has where it does not say: so that the model's forms come out of them.
struct ModelStart {
  double cell_size = 1;  ///< m
  double strength = 5;   ///< of a constant wind
  double sand = 3;       ///< mean thickness of the mobile layer, slabs a cell
};

}  // namespace erg
