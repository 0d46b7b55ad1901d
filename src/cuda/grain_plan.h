// What the kernels of grains read and write, as one plain struct that every launch hands over by value. The bed lies on
// the device as on the processor (BedPlanes), in the wind's frame.
#pragma once

#include "cuda/device_plan.h"
#include "transport/grain_bed_cell.h"

namespace erg {

struct GrainPlan {
  BedPlanes bed;
  const GrainLaw* law = nullptr;  ///< on the device: its tables are more than a launch can hand over
  GrainMoment now;
  double inflow = 0;
  double abrasion = 0;
  double settling = 0;
  double bonding = 0;
  BedEdges edges;  ///< what a launch that slides or creeps works on
  int standing = 0;

  std::uint32_t* bounds = nullptr;  ///< over the lowest bedrock, quanta: the highest cell; ~ the lowest cell
  std::uint32_t* slid = nullptr;    ///< 1 where something slid
  TallyWord* tally = nullptr;       ///< tally_slots * the words of a GrainTally
};

}  // namespace erg
