// How far apart crests stand along the wind, counted one by one.
#pragma once

#include "analysis/fourier.h"

namespace erg::analysis {

/// Mean distance (cells of the terrain) from crest to crest along lines with a wind from `bearing` (degrees). A crest
/// is where a line has climbed from a quarter of the surface's standard deviation below its mean height to as much
/// above it: the upcrossings by which waves at sea are counted, with a margin for rubble. 0 where no line meets two.
/// Unlike the mean over the spectrum it is not pulled down by short waves, nor held to fractions of the grid's side.
double crest_spacing(const CoarseSurface& surface, double bearing, const ShareWork& share = do_alone);

}  // namespace erg::analysis
