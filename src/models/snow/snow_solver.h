// A step of sintering snow, and what carries it out: the processor's threads (on_processor.h), or kernels on a device
// (snow_on_device.h).
#pragma once

#include "compute/executor.h"
#include "core/random.h"
#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "forcing/wind_schedule.h"
#include "models/snow/snow_step.h"
#include "models/step_report.h"

namespace erg::models {

/// Lets snow drift, slide, fall and bond for one time step, and books in- and outflow. The terrain has the fields of
/// SnowLayer. Throws InputError if the snow has grown too high to be counted.
StepReport drift_snow(compute::Executor& executor, Terrain& terrain, const SnowStep& snow, const forcing::Forcing& wind,
                      StepKey key);

/// Holds a terrain of snow and lets it drift.
class SnowSolver : public compute::Solver {
 public:
  virtual void load(const Terrain& terrain, const forcing::WindFrame& frame) = 0;
  /// One step of the terrain that is loaded, whose layers need not be up to date. Throws InputError, before anything
  /// has changed, if the snow has grown too high to be counted.
  virtual StepReport step(Terrain& terrain, const SnowStep& snow, const forcing::Forcing& wind, StepKey key,
                          compute::Executor& executor) = 0;
};

}  // namespace erg::models
