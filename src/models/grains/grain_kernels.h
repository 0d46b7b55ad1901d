// Kernels of grains: one thread flies one grain, or does one cell or edge, by the rules of
// models/grains/grain_bed_cell.h. Grains add whole numbers to cells, so their order decides nothing.
#pragma once

#include "compute/kernel.h"
#include "models/grains/plan.h"

namespace erg::models::grain {

struct Kernels {
#define ERG_KERNEL(family, name) static const compute::KernelOf<Plan> name;
#include "models/grains/grain_kernels.def"
#undef ERG_KERNEL
};

// --- the frozen ground ---

/// Heights and loose grains of all cells, and how high and low the bed reaches.
ERG_ON_DEVICE void snapshot(const Plan& plan, compute::Items items) {
  std::uint32_t highest = 0;
  std::uint32_t under_lowest = 0;
  EACH_ITEM(cell, plan.bed.cells()) {
    snapshot_cell(plan.bed, cell % plan.bed.width, cell / plan.bed.width);
    const auto height = static_cast<std::uint32_t>(plan.bed.height(cell) - plan.bed.lowest);
    if (height > highest) highest = height;
    if (~height > under_lowest) under_lowest = ~height;
  }
  compute::raise(plan.bounds, highest);
  compute::raise(plan.bounds + 1, under_lowest);
}

/// The shadow that comes to row `first` of a line: the same bits as if it were followed from row `start`, in which all
/// lines begin. Looks back only as far as a cell as high as the `summit` (m) could still reach; to subtract with
/// rounding keeps an order, so what is lower here stays lower.
ERG_ON_DEVICE ShadowLine shadow_from_upwind(const BedPlanes& bed, std::int32_t line, std::int32_t start,
                                            std::int32_t first, float summit) {
  for (std::int32_t rows = 32;; rows *= 2) {
    const std::int32_t from = first - rows > start ? first - rows : start;
    ShadowLine shadow;
    follow_shadow(bed, line, start, from, first, false, shadow);
    if (from == start) return shadow;
    float beyond = summit;
    for (std::int32_t row = 0; row <= rows; ++row) beyond -= bed.fall_far;
    if (beyond <= shadow.far) return shadow;
  }
}

/// Height of the shadow over every cell. One thread follows a line for some rows.
ERG_ON_DEVICE void shadow(const Plan& plan, compute::Items items) {
  const BedPlanes& bed = plan.bed;
  const std::uint32_t highest = plan.bounds[0];
  const std::uint32_t lowest = ~plan.bounds[1];
  const std::int32_t start = first_shadow_row(bed, static_cast<std::int64_t>(highest) - lowest);
  const auto summit = static_cast<float>(static_cast<double>(highest) * bed.quantum);
  const std::int32_t pieces = (bed.length + plan.shadow_rows - 1) / plan.shadow_rows;
  EACH_ITEM(item, pieces * bed.width) {
    const std::int32_t line = item % bed.width;
    const std::int32_t first = item / bed.width * plan.shadow_rows;
    const std::int32_t end = first + plan.shadow_rows < bed.length ? first + plan.shadow_rows : bed.length;
    ShadowLine shadow = shadow_from_upwind(bed, line, start, first, summit);
    follow_shadow(bed, line, start, first, end, true, shadow);
  }
}

ERG_ON_DEVICE void rim(const Plan& plan, compute::Items items) {
  EACH_ITEM(number, rim_points(plan.bed)) { snapshot_rim(plan.bed, number); }
}

// --- flights ---

ERG_ON_DEVICE void count(const Plan& plan, compute::Items items, const GrainCounters& counted) {
  __builtin_bit_cast(compute::Counters<grain_counters>, counted).add_to(plan.counters, items);
}

ERG_ON_DEVICE void fly(const Plan& plan, compute::Items items) {
  GrainCounters counted;
  const std::int64_t polls = polls_of(plan.now, plan.bed.cells());
  EACH_ITEM(poll, polls) { poll_grain(*plan.law, plan.bed, plan.now, poll, counted); }
  count(plan, items, counted);
}

/// Grains that enter an open grid. One thread, one cell of its upwind edges.
ERG_ON_DEVICE void inject(const Plan& plan, compute::Items items) {
  GrainCounters counted;
  EACH_ITEM(number, upwind_cells(*plan.law, plan.bed)) {
    inject_grains(*plan.law, plan.bed, plan.now, plan.inflow, number, counted);
  }
  count(plan, items, counted);
}

/// Grains that impacts knocked loose hop. One thread, one cell.
ERG_ON_DEVICE void resolve_splash(const Plan& plan, compute::Items items) {
  GrainCounters counted;
  EACH_ITEM(cell, plan.bed.cells()) {
    erg::models::resolve_splash(*plan.law, plan.bed, plan.now, plan.abrasion, cell, counted);
  }
  count(plan, items, counted);
}

ERG_ON_DEVICE void apply_deltas(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.bed.cells()) { apply_deltas_to(plan.bed, cell); }
}

// --- the bed by itself ---

/// Edges of one class: they share no cell, so nobody waits for anybody.
ERG_ON_DEVICE void slide(const Plan& plan, compute::Items items) {
  const std::int32_t edges = plan.edges.outer * plan.edges.inner;
  bool any = false;
  EACH_ITEM(item, edges) {
    BedEdge edge;
    if (!find_edge(plan.bed, plan.edges, item / plan.edges.inner, item % plan.edges.inner, edge)) continue;
    if (slide_grains(plan.bed, edge, plan.critical_step)) any = true;
  }
  if (any) compute::raise(plan.slid, 1);
}

ERG_ON_DEVICE void creep(const Plan& plan, compute::Items items) {
  const std::int32_t edges = plan.edges.outer * plan.edges.inner;
  EACH_ITEM(item, edges) {
    BedEdge edge;
    if (!find_edge(plan.bed, plan.edges, item / plan.edges.inner, item % plan.edges.inner, edge)) continue;
    creep_grain(plan.bed, edge, plan.edges.way, plan.settling, plan.now);
  }
}

ERG_ON_DEVICE void bond(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.bed.cells()) { bond_cell(plan.bed, plan.bonding, plan.now, cell); }
}

}  // namespace erg::models::grain
