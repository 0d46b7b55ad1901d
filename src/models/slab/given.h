// What the kernels of slabs are given of a sub-sweep, a grid and a law: the host's numbers in 32 bits.
#pragma once

#include "forcing/wind_frame.h"
#include "models/slab/plan.h"

namespace erg::models::slab {

/// Slabs that enter on a line: `whole`, and one more where a random number of 16 bits is `from` or more.
struct Inflow {
  u32 whole = 0;
  u32 from = 0x10000;
};

/// The same slabs as int(inflow + random / 65536), whatever the random number.
Inflow whole_inflow(double inflow);

void give_grid(const forcing::WindFrame& frame, bool open, Given& given);
void give_sub_sweep(const SubSweep& sweep, Given& given);

}  // namespace erg::models::slab
