// What a time step did, in counts.
#pragma once

#include <cstdint>
#include <string>

namespace erg {

/// What one time step did, in counts.
struct StepReport {
  std::int64_t polls = 0;      ///< cells that were asked for a slab
  std::int64_t lifts = 0;      ///< slabs lifted
  double travel = 0;           ///< cells travelled downwind, summed over all slabs
  std::int64_t slabs_in = 0;   ///< entered over an open edge
  std::int64_t slabs_out = 0;  ///< left over an open edge
  bool finished = false;       ///< nothing can move any more
  std::string why_finished;

  StepReport& operator+=(const StepReport& other);
};

}  // namespace erg
