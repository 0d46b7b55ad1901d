// What kernels that move slabs count in a step.
#pragma once

#include "compute/kernel.h"

namespace erg::kernels {

enum StepCounter : int { counted_polls, counted_lifts, counted_rows, counted_in, counted_out, step_counters };
using StepCounters = compute::Counters<step_counters>;

}  // namespace erg::kernels
