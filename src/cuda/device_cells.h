// What all kernels use: a thread's share of the work, where lines lie, words that several threads write.
#pragma once

#include "cuda/device_plan.h"

// Both compilations of the kernels, nvcc's and a test's, may meet in one program: each has a namespace of its own.
#if defined(__CUDACC__)
#define ERG_KERNEL_SPACE on_device
#else
#include "cuda/emulation.h"
#define ERG_KERNEL_SPACE emulated
#endif

namespace erg::ERG_KERNEL_SPACE {

/// A thread's items are first_item(), and every item_stride() from there on.
/// All of them are below 2^29: whole divisions of 32 bits cost a card a fraction of those of 64.
__device__ inline std::int32_t first_item() { return static_cast<std::int32_t>(blockIdx.x * blockDim.x + threadIdx.x); }
__device__ inline std::int32_t item_stride() { return static_cast<std::int32_t>(gridDim.x * blockDim.x); }

__device__ inline std::uint32_t height_of(std::uint32_t ground_word) { return ground_word & height_mask; }

__device__ inline std::int32_t wrapped(std::int32_t value, std::int32_t period) {
  const std::int32_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

/// Columns that lines have moved sideways when they meet a row, which may lie before or beyond the grid.
__device__ inline std::int32_t offset_of(const DevicePlan& plan, std::int32_t row) {
  if (!plan.sweep.oblique) return 0;
  return line_offset(row, plan.sweep.drift, plan.sweep.phase, plan.length);
}

/// The cell where a line meets a row, which may lie before or beyond the grid.
__device__ inline std::int32_t cell_of(const DevicePlan& plan, std::int32_t line, std::int32_t row) {
  return wrapped(row, plan.length) * plan.width + wrapped(line + offset_of(plan, row), plan.width);
}

/// A line on its way from row to row, for those who visit many.
struct LineWalk {
  std::int64_t rest = 0;  // (row * drift + phase) mod length
  std::int32_t column = 0;
  std::int32_t row = 0;  // folded into the grid

  __device__ static LineWalk at(const DevicePlan& plan, std::int32_t line, std::int32_t row) {
    LineWalk walk;
    const std::int32_t offset = offset_of(plan, row);
    walk.rest = row * plan.sweep.drift + plan.sweep.phase - std::int64_t{offset} * plan.length;
    walk.column = wrapped(line + offset, plan.width);
    walk.row = wrapped(row, plan.length);
    return walk;
  }
  __device__ std::int32_t cell(const DevicePlan& plan) const { return row * plan.width + column; }
  /// Goes on to the next row; true where the line leaves one side of the grid and enters the other.
  __device__ bool go_on(const DevicePlan& plan) {
    row = row + 1 == plan.length ? 0 : row + 1;
    rest += plan.sweep.drift;
    if (rest < plan.length) return false;
    rest -= plan.length;
    column = column + 1 == plan.width ? 0 : column + 1;
    return column == 0;
  }
  __device__ void go_back(const DevicePlan& plan) {
    row = row == 0 ? plan.length - 1 : row - 1;
    rest -= plan.sweep.drift;
    if (rest >= 0) return;
    rest += plan.length;
    column = column == 0 ? plan.width - 1 : column - 1;
  }
};

/// Open boundary: the first row after `row` where the line has left the grid, sideways or at its end.
__device__ inline std::int32_t leaving_row(const DevicePlan& plan, std::int32_t line, std::int32_t row) {
  if (plan.sweep.drift == 0) return plan.length;
  const std::int64_t rounds = (line + offset_of(plan, row)) / plan.width + 1;
  const std::int64_t offset = rounds * plan.width - line;
  const std::int64_t first = (offset * plan.length - plan.sweep.phase + plan.sweep.drift - 1) / plan.sweep.drift;
  return first < plan.length ? static_cast<std::int32_t>(first) : plan.length;
}

/// Open boundary: the last row up to `row` at which the line came into the grid.
__device__ inline std::int32_t entering_row(const DevicePlan& plan, std::int32_t line, std::int32_t row) {
  if (plan.sweep.drift == 0) return 0;
  const std::int64_t rounds = (line + offset_of(plan, row)) / plan.width;
  if (rounds == 0) return 0;
  const std::int64_t offset = rounds * plan.width - line;
  const std::int64_t first = (offset * plan.length - plan.sweep.phase + plan.sweep.drift - 1) / plan.sweep.drift;
  return first > 0 ? static_cast<std::int32_t>(first) : 0;
}

/// Raises a bound that many threads share. Most find it high enough already and only look.
__device__ inline void raise(std::uint32_t* bound, std::uint32_t value) {
#if defined(__CUDACC__)
  const std::uint32_t seen = *static_cast<volatile std::uint32_t*>(bound);
#else
  const std::uint32_t seen = std::atomic_ref<std::uint32_t>(*bound).load(std::memory_order_relaxed);
#endif
  if (seen < value) atomicMax(bound, value);
}

/// What one thread has counted; added to the device's counters once, when it is done.
struct ThreadTally {
  std::int64_t counts[tallies] = {};

  __device__ void book(TallyWord* tally) const {
    TallyWord* slot = tally + (first_item() % tally_slots) * tallies;
    for (int k = 0; k < tallies; ++k) {
      if (counts[k] != 0) atomicAdd(slot + k, static_cast<TallyWord>(counts[k]));
    }
  }
};

}  // namespace erg::ERG_KERNEL_SPACE
