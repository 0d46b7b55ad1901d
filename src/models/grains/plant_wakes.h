// The shelter that plants give to grains: each takes wind away where it stands and along a wake behind it.
#pragma once

#include <vector>

#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "models/grains/grain_values.h"

namespace erg::models {

/// The share of the wind that these plants leave in each cell of the frame (1 without plants): least where a plant
/// stands, more and more along the wake behind it. `plants`: the share of each of the
/// terrain's cells that plants cover, 0 to 1.
std::vector<float> plant_shelter(const GrainValues& values, const Terrain& terrain, const Grid<float>& plants,
                                 const forcing::WindFrame& frame);

}  // namespace erg::models
