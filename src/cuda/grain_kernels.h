// Kernels of grains: one thread flies one grain, or does one cell or edge, by the rules of transport/grain_bed_cell.h.
// Grains add whole numbers to cells, so their order decides nothing.
#pragma once

#include "cuda/device_cells.h"
#include "cuda/grain_plan.h"

namespace erg::ERG_KERNEL_SPACE {

// --- the frozen ground ---

/// Heights and loose grains of all cells, and how high and low the bed reaches.
__global__ void grain_freeze(GrainPlan plan) {
  std::uint32_t highest = 0;
  std::uint32_t under_lowest = 0;
  for (std::int32_t cell = first_item(); cell < plan.bed.cells(); cell += item_stride()) {
    freeze_cell(plan.bed, cell % plan.bed.width, cell / plan.bed.width);
    const auto height = static_cast<std::uint32_t>(plan.bed.height(cell) - plan.bed.lowest);
    if (height > highest) highest = height;
    if (~height > under_lowest) under_lowest = ~height;
  }
  raise(plan.bounds, highest);
  raise(plan.bounds + 1, under_lowest);
}

/// The shadow that comes to row `first` of a line: the same bits as if it were followed from row `start`, in which all
/// lines begin. Looks back only as far as a cell as high as the `summit` (m) could still reach; to subtract with
/// rounding keeps an order, so what is lower here stays lower.
__device__ inline ShadowLine shadow_from_upwind(const BedPlanes& bed, std::int32_t line, std::int32_t start,
                                                std::int32_t first, float summit) {
  for (std::int32_t rows = shadow_rows;; rows *= 2) {
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
__global__ void grain_shadow(GrainPlan plan) {
  const BedPlanes& bed = plan.bed;
  const std::uint32_t highest = plan.bounds[0];
  const std::uint32_t lowest = ~plan.bounds[1];
  const std::int32_t start = first_shadow_row(bed, static_cast<std::int64_t>(highest) - lowest);
  const auto summit = static_cast<float>(static_cast<double>(highest) * bed.quantum);
  const std::int32_t pieces = (bed.length + shadow_rows - 1) / shadow_rows;
  for (std::int32_t item = first_item(); item < pieces * bed.width; item += item_stride()) {
    const std::int32_t line = item % bed.width;
    const std::int32_t first = item / bed.width * shadow_rows;
    const std::int32_t end = first + shadow_rows < bed.length ? first + shadow_rows : bed.length;
    ShadowLine shadow = shadow_from_upwind(bed, line, start, first, summit);
    follow_shadow(bed, line, start, first, end, true, shadow);
  }
}

__global__ void grain_rim(GrainPlan plan) {
  for (std::int32_t number = first_item(); number < rim_points(plan.bed); number += item_stride()) {
    freeze_rim(plan.bed, number);
  }
}

// --- flights ---

/// Adds what a thread has counted to the device's counters.
__device__ inline void book(const GrainPlan& plan, const GrainTally& tally) {
  constexpr int words = sizeof(GrainTallyWords) / sizeof(std::int64_t);
  const auto counted = __builtin_bit_cast(GrainTallyWords, tally);
  TallyWord* slot = plan.tally + (first_item() % tally_slots) * words;
  for (int k = 0; k < words; ++k) {
    if (counted.of[k] != 0) atomicAdd(slot + k, static_cast<TallyWord>(counted.of[k]));
  }
}

__global__ void grain_fly(GrainPlan plan) {
  GrainTally tally;
  const std::int64_t polls = polls_of(plan.now, plan.bed.cells());
  for (std::int32_t poll = first_item(); poll < polls; poll += item_stride()) {
    poll_grain(*plan.law, plan.bed, plan.now, poll, tally);
  }
  book(plan, tally);
}

/// Grains that enter an open grid. One thread, one cell of its upwind edges.
__global__ void grain_let_in(GrainPlan plan) {
  GrainTally tally;
  for (std::int32_t number = first_item(); number < upwind_cells(*plan.law, plan.bed); number += item_stride()) {
    let_grains_in(*plan.law, plan.bed, plan.now, plan.inflow, number, tally);
  }
  book(plan, tally);
}

/// Grains that impacts knocked loose hop. One thread, one cell.
__global__ void grain_hand_out(GrainPlan plan) {
  GrainTally tally;
  for (std::int32_t cell = first_item(); cell < plan.bed.cells(); cell += item_stride()) {
    hand_out(*plan.law, plan.bed, plan.now, plan.abrasion, cell, tally);
  }
  book(plan, tally);
}

__global__ void grain_settle_accounts(GrainPlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.bed.cells(); cell += item_stride()) {
    settle_account(plan.bed, cell);
  }
}

// --- the bed by itself ---

/// Edges of one class: they share no cell, so nobody waits for anybody.
__global__ void grain_slide(GrainPlan plan) {
  const std::int32_t edges = plan.edges.outer * plan.edges.inner;
  bool any = false;
  for (std::int32_t item = first_item(); item < edges; item += item_stride()) {
    BedEdge edge;
    if (!find_edge(plan.bed, plan.edges, item / plan.edges.inner, item % plan.edges.inner, edge)) continue;
    if (slide_grains(plan.bed, edge, plan.standing)) any = true;
  }
  if (any) raise(plan.slid, 1);
}

__global__ void grain_creep(GrainPlan plan) {
  const std::int32_t edges = plan.edges.outer * plan.edges.inner;
  for (std::int32_t item = first_item(); item < edges; item += item_stride()) {
    BedEdge edge;
    if (!find_edge(plan.bed, plan.edges, item / plan.edges.inner, item % plan.edges.inner, edge)) continue;
    creep_grain(plan.bed, edge, plan.edges.way, plan.settling, plan.now);
  }
}

__global__ void grain_bond(GrainPlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.bed.cells(); cell += item_stride()) {
    bond_cell(plan.bed, plan.bonding, plan.now, cell);
  }
}

}  // namespace erg::ERG_KERNEL_SPACE
