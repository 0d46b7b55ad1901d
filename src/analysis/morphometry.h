// The shape of a terrain in numbers.
#pragma once

#include <cstdint>

#include "core/terrain.h"

namespace erg::analysis {

/// What measure() finds.
struct Morphometry {
  // Of the mobile layer. On a flat bed its thickness is the dune's height, which is what is found in print as "max
  // slabs".
  std::int32_t max_slabs = 0;  ///< thickest column, quanta
  double mean_slabs = 0;       ///< quanta
  double sd_slabs = 0;         ///< standard deviation over all cells, quanta
  double bare_fraction = 0;    ///< share of cells with no mobile quantum

  // Of the surface.
  double lowest = 0;      ///< m
  double highest = 0;     ///< m
  double sd_surface = 0;  ///< m: standard deviation over all cells
};

/// Measures a terrain; all 0 for one without cells.
Morphometry measure(const Terrain& terrain);

/// The share of cells that are dark in a shadow map.
double shadow_fraction(const Grid<std::uint8_t>& shadow);

}  // namespace erg::analysis
