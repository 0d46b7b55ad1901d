// Which way the forms of a surface lie to the wind, and which of their faces are steeper: what tells waves from
// sastrugi.
#pragma once

#include <string>

#include "core/terrain.h"

namespace erg {

struct BedformShape {
  double across = 0;  ///< share of the squared slope that lies across the wind: ridges across it 0, along it 1
  double skew = 0;    ///< of the slope along the wind: positive where faces toward the wind are the steeper ones
  double relief = 0;  ///< standard deviation of height, quanta
};

/// Of the surface over level ground in means over squares of three cells, since single slabs are rubble; for a wind
/// from `bearing` (degrees), the grid taken as a torus.
BedformShape measure_bedforms(const Terrain& terrain, double bearing);

/// What a person would call it: "flat", "waves", "rough" or "sastrugi". Flat is a relief of less than 2 quanta, waves
/// have less than 0.4 across, sastrugi over 0.55 with the steeper faces toward the wind.
std::string bedform_name(const BedformShape& shape);

}  // namespace erg
