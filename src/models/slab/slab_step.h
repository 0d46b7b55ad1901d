// A step of the slab machine, and what carries it out: one slab at a time (slab_reference.h), sub-sweeps on the
// processor's threads (slab_engine.h), sub-sweeps as kernels on a device (slab_on_device.h).
#pragma once

#include <cstdint>

#include "compute/executor.h"
#include "core/random.h"
#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "forcing/wind_schedule.h"
#include "models/slab/slab_law.h"
#include "models/step_report.h"

namespace erg::models {

/// Moves the slabs of one time step and books in- and outflow in the terrain's ledger; a wind of strength 0 is a calm,
/// in which nothing moves. Throws InputError for a terrain that is too high (terrain_heights.h).
StepReport move_slabs(compute::Executor& executor, Terrain& terrain, const SlabLaw& law, const forcing::Forcing& wind,
                      StepKey key);

/// Holds a terrain of slabs and moves them.
class SlabSolver : public compute::Solver {
 public:
  virtual void load(const Terrain& terrain, const forcing::WindFrame& frame) = 0;
  /// One step of the terrain that is loaded, whose layers need not be up to date. `lift_counts`: Executor::lift_counts.
  virtual StepReport step(Terrain& terrain, const SlabLaw& law, const forcing::WindFrame& frame, double strength,
                          StepKey key, Grid<std::int32_t>* lift_counts) = 0;
};

}  // namespace erg::models
