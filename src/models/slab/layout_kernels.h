// Kernels that bring the terrain in and out, and that prepare a step: one thread, one cell (or one height).
#pragma once

#include "models/slab/line.h"

namespace erg::models::slab {

/// Heights over the lowest bedrock, from the terrain's order.
ERG_ON_DEVICE void scatter_surface(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) { plan.before[cell] = static_cast<std::uint32_t>(plan.staged[plan.order.place(cell)]); }
}

ERG_ON_DEVICE void scatter_bedrock(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) {
    plan.bedrock[cell] = static_cast<std::uint16_t>(plan.staged[plan.order.place(cell)]);
  }
}

/// Cover comes in as bytes.
ERG_ON_DEVICE void scatter_cover(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) {
    plan.cover[cell] = reinterpret_cast<const std::uint8_t*>(plan.staged)[plan.order.place(cell)];
  }
}

/// Shows the processor what has changed.
ERG_ON_DEVICE void show_surface(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) {
    const std::ptrdiff_t place = plan.order.place(cell);
    const auto height = static_cast<std::int32_t>(height_of(plan.before[cell]));
    if (plan.shown[place] == height) continue;
    plan.shown[place] = height;
    compute::raise(plan.bands_changed + place / band_cells, 1);
  }
}

/// The same ways back, for a turn.
ERG_ON_DEVICE void gather_surface(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) {
    plan.staged[plan.order.place(cell)] = static_cast<std::int32_t>(height_of(plan.before[cell]));
  }
}

ERG_ON_DEVICE void gather_bedrock(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) { plan.staged[plan.order.place(cell)] = plan.bedrock[cell]; }
}

/// How many cells have each height.
ERG_ON_DEVICE void count_heights(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells()) {
    compute::atomic_add(plan.height_counts + height_of(plan.before[cell]), std::uint32_t{1});
  }
}

/// Hops from ground of every height.
ERG_ON_DEVICE void fill_hop_table(const Plan& plan, compute::Items items) {
  const std::int32_t heights = plan.hop_by_height ? hop_heights : 1;
  EACH_ITEM(height, heights) {
    plan.hop_table[height] = hop_rows_256(plan.hop, static_cast<double>(height) - plan.hop_reference);
  }
}

}  // namespace erg::models::slab
