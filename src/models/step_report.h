// What time steps tell about themselves.
#pragma once

#include <cstdint>
#include <string>

namespace erg::models {

/// What one time step did, in counts, or several one after the other.
struct StepReport {
  std::int64_t polls = 0;      ///< cells that were asked for a slab
  std::int64_t lifts = 0;      ///< slabs lifted
  double travel = 0;           ///< cells travelled downwind, summed over all slabs
  std::int64_t slabs_in = 0;   ///< entered over an open edge
  std::int64_t slabs_out = 0;  ///< left over an open edge
  bool finished = false;       ///< nothing can move any more
  std::string why_finished;    ///< a clause for people; "" unless finished

  /// Adds what a later step did.
  StepReport& operator+=(const StepReport& other);
};

}  // namespace erg::models
