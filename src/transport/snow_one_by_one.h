// The reference flights of SnowSolver: one slab after another in random order, each seeing what the last one left.
#pragma once

#include "core/random.h"
#include "transport/snow_ground.h"
#include "transport/snow_planes.h"
#include "wind/wind_frame.h"

namespace erg {

/// Moves the snow in the layers of the terrain by the rates that `planes` holds. `travel` of the report is in rows of
/// the frame.
StepReport fly_one_by_one(const SnowPlanes& planes, const SnowGround& ground, const WindFrame& frame, StepKey key);

}  // namespace erg
