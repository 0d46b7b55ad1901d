// What the kernels of grains read and write, as one plain struct that every launch hands over by value. The bed lies in
// the wind's frame.
#pragma once

#include "models/grains/grain_bed_cell.h"

namespace erg::models::grain {

struct Plan {
  BedPlanes bed;
  const GrainLaw* law = nullptr;  ///< in the back end's memory: its tables are more than a launch can hand over
  GrainMoment now;
  double inflow = 0;
  double abrasion = 0;
  double settling = 0;
  double bonding = 0;
  BedEdges edges;  ///< what a launch that slides or creeps works on
  int critical_step = 0;
  int shadow_rows = 32;  ///< of a line that one thread follows

  std::uint32_t* bounds = nullptr;           ///< over the lowest bedrock, quanta: the highest cell; ~ the lowest cell
  std::uint32_t* slid = nullptr;             ///< 1 where something slid
  compute::CounterWord* counters = nullptr;  ///< counter_slots * grain_counters
};

}  // namespace erg::models::grain
