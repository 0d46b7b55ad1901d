// Kernels that let slopes slide: one thread, one edge. Edges of one class share no cell, so nobody waits for anybody.
#pragma once

#include "cuda/device_cells.h"

namespace erg::ERG_KERNEL_SPACE {

/// The step that stands over an edge, seen from its higher cell.
__device__ inline std::uint32_t standing_step(const DevicePlan& plan, std::int64_t cell) {
  const bool covered = plan.cover != nullptr && plan.cover[cell] >= plan.covered_from;
  return static_cast<std::uint32_t>(covered ? plan.stands_covered : plan.stands);
}

/// One slab from cell to cell, if it lies too steeply there and is none of the bedrock.
__device__ inline bool slide_down(const DevicePlan& plan, std::int64_t from, std::int64_t to) {
  const std::uint32_t high = height_of(plan.after[from]);
  if (high <= height_of(plan.after[to]) + standing_step(plan, from)) return false;
  if (plan.bedrock != nullptr && high <= plan.bedrock[from]) return false;
  plan.after[from] -= 1;
  plan.after[to] += 1;
  return true;
}

__device__ inline void slide_edge(const DevicePlan& plan, std::int64_t a, std::int64_t b) {
  if (!slide_down(plan, a, b)) slide_down(plan, b, a);
}

__device__ inline std::int64_t at(const DevicePlan& plan, std::int32_t column, std::int32_t row) {
  return static_cast<std::int64_t>(row) * plan.width + column;
}

__device__ inline bool is_rising(EdgeClass edges) { return edges == rising_even || edges == rising_odd; }
__device__ inline bool is_diagonal(EdgeClass edges) { return edges >= rising_even; }

/// The edge of the class that goes up from a column and a row to row `up`, if both its columns lie in one tile.
__device__ inline void slide_between_rows(const DevicePlan& plan, std::int32_t column, std::int32_t row,
                                          std::int32_t up) {
  if (!is_diagonal(plan.edges)) {
    slide_edge(plan, at(plan, column, row), at(plan, column, up));
    return;
  }
  const std::int32_t right = column + 1;
  if (right == plan.width || right % plan.block_columns == 0) return;
  if (is_rising(plan.edges)) {
    slide_edge(plan, at(plan, column, row), at(plan, right, up));
  } else {
    slide_edge(plan, at(plan, right, row), at(plan, column, up));
  }
}

__device__ inline std::int32_t tiles_along(const DevicePlan& plan) {
  return plan.length < 2 * tile_rows ? 1 : plan.length / tile_rows;
}

/// Edges of a class inside tiles. An item for each pair of rows and column, or for each row and pair of columns.
__global__ void slide_tiles(DevicePlan plan) {
  const bool across = plan.edges == across_even || plan.edges == across_odd;
  const std::int32_t odd = plan.edges & 1;
  const std::int64_t pairs = ((across ? plan.width : plan.length) + 1) / 2;
  const std::int64_t others = across ? plan.length : plan.width;
  const std::int32_t last_tile = tiles_along(plan) - 1;
  for (std::int64_t item = first_item(); item < pairs * others; item += item_stride()) {
    if (across) {
      const auto column = static_cast<std::int32_t>(2 * (item % pairs)) + odd;
      const auto row = static_cast<std::int32_t>(item / pairs);
      const std::int32_t right = column + 1;
      if (right >= plan.width || right % plan.block_columns == 0) continue;
      slide_edge(plan, at(plan, column, row), at(plan, right, row));
      continue;
    }
    const auto column = static_cast<std::int32_t>(item % plan.width);
    const auto row = static_cast<std::int32_t>(2 * (item / plan.width)) + odd;
    const std::int32_t up = row + 1;
    const bool on_seam = up % tile_rows == 0 && up / tile_rows <= last_tile;
    if (up < plan.length && !on_seam) slide_between_rows(plan, column, row, up);
  }
}

/// Edges between one tile and the next along the rows. An item for each column and seam, the one over the torus edge
/// last.
__global__ void slide_row_seams(DevicePlan plan) {
  const std::int32_t tiles = tiles_along(plan);
  const std::int32_t seams = plan.open || plan.length <= 2 ? tiles - 1 : tiles;
  for (std::int64_t item = first_item(); item < static_cast<std::int64_t>(seams) * plan.width; item += item_stride()) {
    const auto column = static_cast<std::int32_t>(item % plan.width);
    const auto seam = static_cast<std::int32_t>(item / plan.width);
    const std::int32_t up = seam + 1 == tiles ? 0 : (seam + 1) * tile_rows;
    slide_between_rows(plan, column, up == 0 ? plan.length - 1 : up - 1, up);
  }
}

/// Edges between one tile and the next along the columns. An item for each row and seam, the one over the torus edge
/// last.
__global__ void slide_column_seams(DevicePlan plan) {
  const std::int32_t tiles = (plan.width + plan.block_columns - 1) / plan.block_columns;
  const std::int32_t seams = plan.open || plan.width <= 2 ? tiles - 1 : tiles;
  for (std::int64_t item = first_item(); item < static_cast<std::int64_t>(seams) * plan.length; item += item_stride()) {
    const auto row = static_cast<std::int32_t>(item % plan.length);
    const auto seam = static_cast<std::int32_t>(item / plan.length);
    const std::int32_t right = seam + 1 == tiles ? 0 : (seam + 1) * plan.block_columns;
    const std::int32_t left = right == 0 ? plan.width - 1 : right - 1;
    if (!is_diagonal(plan.edges)) {
      slide_edge(plan, at(plan, left, row), at(plan, right, row));
      continue;
    }
    const std::int32_t up = row + 1 == plan.length ? 0 : row + 1;
    if (plan.length < 2 || (up == 0 && plan.open)) continue;
    const bool rises = is_rising(plan.edges);
    slide_edge(plan, at(plan, rises ? left : right, row), at(plan, rises ? right : left, up));
  }
}

}  // namespace erg::ERG_KERNEL_SPACE
