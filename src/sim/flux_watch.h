// Where material is on the move: how often each cell gives some away.
#pragma once

#include <cstdint>

#include "core/terrain.h"

namespace erg::sim {

/// Counts, over some steps, how many quanta are lifted from each cell.
class FluxWatch {
 public:
  /// Steps over which a mean is taken: a single one would show chance more than the wind.
  static constexpr int steps_of_mean = 20;

  explicit FluxWatch(Extent extent) : counts_(extent), last_counts_(extent) {}

  /// Where an executor counts (Executor::count_lifts).
  Grid<std::int32_t>& counts() { return counts_; }
  /// A step has been counted.
  void stepped();
  /// The field "flux", lifts from each cell a step: the mean of the last whole `steps_of_mean` steps; of those there
  /// are while there are fewer; 0 before the first.
  Field mean() const;

 private:
  Grid<std::int32_t> counts_;
  Grid<std::int32_t> last_counts_;  // of the last whole number of steps
  int steps_ = 0;                   // in counts_
  int last_steps_ = 0;              // in last_counts_: 0 or all
};

}  // namespace erg::sim
