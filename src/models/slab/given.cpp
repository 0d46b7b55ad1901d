#include "models/slab/given.h"

#include <algorithm>
#include <cstdint>

#include "kernels/terrain_order.h"

namespace erg::models::slab {
namespace {

Wide wide_of(std::uint64_t word) { return wide(static_cast<u32>(word), static_cast<u32>(word >> 32)); }

/// The first number below `end` of which `reached` holds, as it does of all that follow; `end` where there is none.
template <typename Reached>
u32 first_reached(u32 end, const Reached& reached) {
  u32 first = 0;
  while (first < end) {
    const u32 middle = first + (end - first) / 2;
    if (reached(middle)) {
      end = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

i32 kept_fall(u32 fall) { return static_cast<i32>(std::min<u32>(fall, steepest_fall)); }

}  // namespace

Inflow whole_inflow(double inflow) {
  const auto slabs = [&](u32 random) { return static_cast<u32>(inflow + random * (1.0 / 65536)); };
  const u32 whole = slabs(0);
  return {whole, first_reached(0x10000, [&](u32 random) { return slabs(random) > whole; })};
}

HopTable::HopTable(const HopCurve& hop, double reference) : hop_(hop), reference_(reference) {
  if (hop.linear < 0 || hop.quadratic < 0) return;  // a hop may grow shorter again
  longest_ = hop_rows_256(hop, 1e9);
  longest_from_ = first_reached(hop_heights, [&](u32 height) { return computed(height) == longest_; });
}

void give_grid(const forcing::WindFrame& frame, bool open, Given& given) {
  given.width = frame.width;
  given.rows = frame.length;
  given.open = open ? 1 : 0;
  given.heads = std::max(frame.width, frame.length);
  const kernels::TerrainOrder order = kernels::terrain_order(frame);
  given.origin = static_cast<i32>(order.origin);
  given.step_u = static_cast<i32>(order.step_u);
  given.step_v = static_cast<i32>(order.step_v);
  const PlaneLayout tiles = plane_layout(frame, open);
  given.blocks = tiles.blocks;
  given.block_columns = tiles.block_columns;
  given.skew = static_cast<u32>(tiles.skew);
}

void give_sub_sweep(const SubSweep& sweep, Given& given) {
  given.sweep_word = wide_of(sweep.sweep_word);
  given.poll_word = wide_of(sweep.poll_word);
  given.poll_share_16 = sweep.poll_share_16;
  given.poll_rows = poll_rows(sweep);
  given.poll_mask = static_cast<u32>(sweep.sweeps - 1);
  given.permuted = sweep.permuted ? 1 : 0;
  for (u32 k = 0; k < PolledRows::permutations; k += 4) {
    const std::uint8_t* rows = sweep.polled_row + k;
    given.polled_rows[k / 4] = rows[0] | u32{rows[1]} << 8 | u32{rows[2]} << 16 | u32{rows[3]} << 24;
  }
  given.oblique = sweep.oblique ? 1 : 0;
  given.drift = static_cast<i32>(sweep.drift);
  given.phase = static_cast<i32>(sweep.phase);
  given.rows_around = static_cast<i32>(sweep.rows_around);
  given.p_sand_16 = sweep.p_sand_16;
  given.p_bare_16 = sweep.p_bare_16;
  given.lift_in_shadow = sweep.lift_in_shadow ? 1 : 0;
  given.row_fall = kept_fall(sweep.row_fall);
  given.next_fall = kept_fall(sweep.next_fall);
  given.second_fall = kept_fall(sweep.second_fall);
  const Inflow inflow = whole_inflow(sweep.inflow);
  given.inflow = inflow.whole;
  given.inflow_from = inflow.from;
  given.wall_step = static_cast<u32>(sweep.wall_step);
}

}  // namespace erg::models::slab
