// The reference flights of SnowOnProcessor: one slab after another in random order, each seeing what the last one left.
#pragma once

#include "core/random.h"
#include "forcing/wind_frame.h"
#include "models/snow/snow_ground.h"
#include "models/snow/snow_planes.h"
#include "models/step_report.h"

namespace erg::models {

/// Moves the snow in the layers of the terrain by the rates that `planes` holds. `travel` of the report is in rows of
/// the frame.
StepReport fly_one_by_one(const SnowPlanes& planes, const SnowGround& ground, const forcing::WindFrame& frame,
                          StepKey key);

}  // namespace erg::models
