// The shelter that plants give to grains: each takes wind away where it stands and along a wake behind it.
#pragma once

#include <vector>

#include "core/parameters.h"
#include "core/terrain.h"
#include "wind/wind_frame.h"

namespace erg {

/// The share of the wind that these plants leave in each cell of the frame (1 without plants): next to nothing
/// where a plant stands, less and less taken away along the wake behind it.
std::vector<float> plant_shelter(const ParameterValues& values, const Terrain& terrain, const Grid<float>& plants,
                                 const WindFrame& frame);

}  // namespace erg
