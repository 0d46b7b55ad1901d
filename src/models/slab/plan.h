// What the kernels of slabs read and write, as one plain struct that every launch hands over by value: numbers
// (given.k) and arrays in the back end's memory. The kernels are its members: the files .k, which are read by C++, by
// CUDA and by compilers of shaders alike (compute/subset.h).
#pragma once

#include <cstdint>

#include "compute/subset.h"
#include "core/terrain.h"
#include "kernels/fixed_point.h"
#include "kernels/step_counters.h"
#include "models/slab/plane_layout.h"
#include "models/slab/slab_cell.h"
#include "models/slab/sub_sweep.h"

namespace erg::models::slab {

#include "models/slab/given.k"

struct Plan {
#include "models/slab/flight.k"
#include "models/slab/ground.k"
#include "models/slab/layout.k"
#include "models/slab/lines.k"
#include "models/slab/shadow.k"
#include "models/slab/slides.k"
};

// The largest product in kernels, of a line that has crossed an open grid of the largest side (row_of_offset).
static_assert(std::int64_t{2} * largest_side * largest_side <= INT32_MAX);
// What the kernels' numbers have to agree with.
static_assert(1 << kernels::fixed_point_bits == 256 && steepest_fall > int{height_mask} << kernels::fixed_point_bits);
static_assert(tally_slots == compute::counter_slots && tallies == kernels::step_counters);
static_assert(tally_polls == kernels::counted_polls && tally_lifts == kernels::counted_lifts);
static_assert(tally_rows == kernels::counted_rows);
static_assert(tally_in == kernels::counted_in && tally_out == kernels::counted_out);
static_assert(rows_of_tile == tile_rows);
static_assert(along_odd == 2 * edges_along + 1 && across_odd == 2 * edges_across + 1);
static_assert(rising_odd == 2 * edges_rising + 1 && falling_odd == 2 * edges_falling + 1);
static_assert(sizeof(Given::polled_rows) == PolledRows::permutations);

}  // namespace erg::models::slab
