// How far apart crests stand along the wind, counted one by one.
#pragma once

#include "analysis/fourier.h"

namespace erg {

/// Mean distance (cells of the terrain) from crest to crest along lines with a wind from `bearing` (degrees). A crest
/// is where a line has climbed from half a standard deviation of the surface's height below its mean to as much above
/// it, so that rubble on a slope counts for none: the upcrossings by which waves at sea are counted. 0 where no line
/// meets two. Unlike the mean over the spectrum it is not pulled down by short waves, nor held to fractions of the
/// grid's side.
double crest_spacing(const CoarseSurface& surface, double bearing);

}  // namespace erg
