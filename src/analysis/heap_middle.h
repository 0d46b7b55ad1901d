// Where a single heap stands along a wind from the west, however thin a veil of drift lies around it.
#pragma once

#include <cstdint>

#include "core/grid.h"

namespace erg::analysis {

/// The middle (cells from the west edge, on the torus) of what lies at most `reach` cells up- or downwind of the
/// thickest line across a west wind: the mean x, weighted by thickness, so that a veil of drift farther off does not
/// count. The first of several lines as thick; the line itself where nothing lies.
double heap_middle(const Grid<std::int32_t>& mobile, int reach);

}  // namespace erg::analysis
