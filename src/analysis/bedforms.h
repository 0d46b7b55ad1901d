// Which way the forms of a surface lie to the wind, and which of their faces are steeper: what tells waves from
// sastrugi.
#pragma once

#include <string>

#include "core/terrain.h"

namespace erg::analysis {

/// The forms of a surface in numbers.
struct BedformShape {
  double across = 0;  ///< share of the squared slope that lies across the wind: ridges across it 0, along it 1
  double skew = 0;    ///< of the slope along the wind: positive where faces toward the wind are the steeper ones
  double relief = 0;  ///< standard deviation of height, m
  double crust = 0;   ///< share of the cells on which bonded snow lies bare, by the field "bonded"; 0 without it
};

/// Of the surface over level ground in means over squares of three cells, since single slabs are rubble; for a wind
/// from `bearing` (degrees), the grid taken as a torus.
BedformShape measure_bedforms(const Terrain& terrain, double bearing);

/// What `bedform_name` goes by.
inline constexpr double least_relief = 0.005;          ///< m: less is flat
inline constexpr double waves_across = 0.4;            ///< less lies across the wind
inline constexpr double streaks_across = 0.55;         ///< more lies along the wind
inline constexpr double least_sastrugi_relief = 0.02;  ///< m: ridges of about 6 cm, as a sine would have them
inline constexpr double least_sastrugi_skew = 0.5;     ///< a surface without steeper faces has 0, give or take 0.2
inline constexpr double least_sastrugi_crust = 0.1;    ///< drift on fresh snow hardly bares any

/// What a person would call it: "flat", "waves" (ridges across the wind), "rough" (neither way), "streaks" (ridges
/// along the wind), or "sastrugi": streaks that are carved, so bonded snow lies bare, their faces toward the wind are
/// clearly the steeper ones, and they are high enough to be walked around (Filhol & Sturm 2015 have them 0.1 to 2 m
/// high).
std::string bedform_name(const BedformShape& shape);

}  // namespace erg::analysis
