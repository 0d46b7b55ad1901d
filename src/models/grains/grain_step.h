// A time step of single grains as data: all that an executor knows of a model of grains.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "models/grains/grain_cell.h"
#include "models/slab/slab_law.h"
#include "models/step_report.h"

namespace erg::models {

/// The terrain's layer of grains that have bonded, in parcels. A terrain may do without.
inline constexpr const char* bonded_field = "bonded";

struct GrainStepLaw {
  GrainLaw grain;          ///< of every single grain
  int sub_steps = 4;       ///< each polls another part of the cells and sees the ground that the last one left
  double shadow_fall = 1;  ///< quanta a cell: the shadow line behind a crest
  ReposeSteps repose;
  double abrasion = 0;  ///< chance that an impact which finds nothing loose frees a bonded grain
  double settling = 0;  ///< chance that a loose grain creeps to a neighbour one parcel lower
  double bonding = 0;   ///< share of the cells in which the grains that have rested in this step bond
  /// Share of the wind that plants leave in each cell of the wind's frame; never null, never changed.
  std::shared_ptr<const std::vector<float>> shelter;
};

/// What a step did.
struct GrainReport {
  StepReport step;
  FlightCounters flights;
  std::int64_t cut_off = 0;  ///< flights that were cut off
};

}  // namespace erg::models
