// Defects of a pattern of crests: places where a crest ends or forks.
#pragma once

#include "analysis/fourier.h"

namespace erg::analysis {

/// How many defects the crests have that lie `spacing` (cells of the terrain) apart under a wind from `bearing`
/// (degrees). The surface is narrowed to wave numbers within an octave of 1 / spacing, and to waves that face the wind;
/// its phase then rises by a whole turn from crest to crest, and a defect is a point around which it winds: one more
/// crest on one side of it than on the other. 0 for straight crests and where `spacing` is 0; on a torus the number is
/// even.
int count_crest_defects(const CoarseSurface& surface, double bearing, double spacing);

}  // namespace erg::analysis
