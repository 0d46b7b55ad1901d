// Kernels that let slopes slide: one thread, one edge. Edges of one launch share no cell, so nobody waits for anybody.
#pragma once

#include "models/slab/line.h"

namespace erg::models::slab {

/// The step that stands over an edge, seen from its higher cell.
ERG_ON_DEVICE std::uint32_t critical_step_at(const Plan& plan, std::int32_t cell) {
  const bool covered = plan.cover != nullptr && plan.cover[cell] >= plan.covered_from;
  return static_cast<std::uint32_t>(covered ? plan.critical_step_covered : plan.critical_step);
}

/// One slab from cell to cell, if it lies too steeply there and is none of the bedrock.
ERG_ON_DEVICE bool slide_down(const Plan& plan, std::int32_t from, std::int32_t to) {
  const std::uint32_t high = height_of(plan.after[from]);
  if (high <= height_of(plan.after[to]) + critical_step_at(plan, from)) return false;
  if (plan.bedrock != nullptr && high <= plan.bedrock[from]) return false;
  plan.after[from] -= 1;
  plan.after[to] += 1;
  return true;
}

/// A cell by its row and its place in the blocks (plane_layout.h).
ERG_ON_DEVICE std::int32_t cell_in(const Plan& plan, std::int32_t place, std::int32_t row) {
  return row * plan.width + plan.tiles.wrapped(place + plan.tiles.skew(row));
}

ERG_ON_DEVICE void slide_edge(const Plan& plan, std::int32_t a, std::int32_t b) {
  if (!slide_down(plan, a, b)) slide_down(plan, b, a);
}

ERG_ON_DEVICE bool is_across(EdgeClass edges) { return edges == across_even || edges == across_odd; }
ERG_ON_DEVICE bool is_rising(EdgeClass edges) { return edges == rising_even || edges == rising_odd; }
/// Columns from the lower to the upper cell of an edge between rows.
ERG_ON_DEVICE std::int32_t columns_over(EdgeClass edges) {
  if (!is_diagonal(edges)) return 0;
  return is_rising(edges) ? 1 : -1;
}

/// Whether two places lie side by side in one block (and not over the torus edge).
ERG_ON_DEVICE bool in_one_block(const Plan& plan, std::int32_t a, std::int32_t b) {
  return b >= 0 && b < plan.width && plan.tiles.block_of(a) == plan.tiles.block_of(b);
}

/// Places by which the row above is shifted to the left; not over the torus edge.
ERG_ON_DEVICE std::int32_t skew_step(const Plan& plan, std::int32_t row) {
  return row + 1 < plan.length ? plan.tiles.skew(row + 1) - plan.tiles.skew(row) : 0;
}

/// The edge of the launch's class from a place up to the next row, if both its cells lie in one block.
ERG_ON_DEVICE void slide_up(const Plan& plan, std::int32_t place, std::int32_t row) {
  const std::int32_t up = row + 1;
  const std::int32_t above = place + columns_over(plan.edges) - skew_step(plan, row);
  if (in_one_block(plan, place, above)) slide_edge(plan, cell_in(plan, place, row), cell_in(plan, above, up));
}

/// The same from the last row to row 0. What lies above a block may stand in others there.
ERG_ON_DEVICE void slide_over_torus_edge(const Plan& plan, std::int32_t place) {
  const std::int32_t over = columns_over(plan.edges);
  if (!in_one_block(plan, place, place + over)) return;
  const std::int32_t last = plan.length - 1;
  slide_edge(plan, cell_in(plan, place, last), plan.tiles.wrapped(place + over + plan.tiles.skew(last)));
}

ERG_ON_DEVICE std::int32_t tiles_along(const Plan& plan) {
  return plan.length < 2 * tile_rows ? 1 : plan.length / tile_rows;
}

/// Edges of a class inside tiles. An item for each pair of rows and place, or for each row and pair of places.
ERG_ON_DEVICE void slide_tiles(const Plan& plan, compute::Items items) {
  const bool across = is_across(plan.edges);
  const std::int32_t odd = plan.edges & 1;
  const std::int32_t pairs = ((across ? plan.width : plan.length) + 1) / 2;
  const std::int32_t others = across ? plan.length : plan.width;
  const std::int32_t last_tile = tiles_along(plan) - 1;
  EACH_ITEM(item, pairs * others) {
    if (across) {
      const std::int32_t place = 2 * (item % pairs) + odd;
      const std::int32_t row = item / pairs;
      if (!in_one_block(plan, place, place + 1)) continue;
      slide_edge(plan, cell_in(plan, place, row), cell_in(plan, place + 1, row));
      continue;
    }
    const std::int32_t row = 2 * (item / plan.width) + odd;
    const std::int32_t up = row + 1;
    const bool on_seam = up % tile_rows == 0 && up / tile_rows <= last_tile;
    if (up < plan.length && !on_seam) slide_up(plan, item % plan.width, row);
  }
}

/// Edges between one tile and the next along the rows. An item for each place and seam, the one over the torus edge
/// last.
ERG_ON_DEVICE void slide_row_seams(const Plan& plan, compute::Items items) {
  const std::int32_t tiles = tiles_along(plan);
  const std::int32_t seams = plan.open || plan.length <= 2 ? tiles - 1 : tiles;
  EACH_ITEM(item, seams * plan.width) {
    const std::int32_t place = item % plan.width;
    const std::int32_t tile = item / plan.width;
    if (tile + 1 == tiles) {
      slide_over_torus_edge(plan, place);
    } else {
      slide_up(plan, place, (tile + 1) * tile_rows - 1);
    }
  }
}

/// The diagonal edges above a row that cross from one block to the next. `left` and `right` are the places beside the
/// seam.
ERG_ON_DEVICE void slide_diagonals_across(const Plan& plan, std::int32_t left, std::int32_t right, std::int32_t row) {
  const bool rises = is_rising(plan.edges);
  const std::int32_t lower = rises ? left : right;
  const std::int32_t upper = rises ? right : left;
  if (row + 1 == plan.length) {
    slide_edge(plan, cell_in(plan, lower, row), plan.tiles.wrapped(upper + plan.tiles.skew(row)));
  } else if (skew_step(plan, row) == 0) {
    slide_edge(plan, cell_in(plan, lower, row), cell_in(plan, upper, row + 1));
  } else if (!rises) {
    slide_edge(plan, cell_in(plan, right, row), cell_in(plan, left - 1, row + 1));
    slide_edge(plan, cell_in(plan, right + 1, row), cell_in(plan, left, row + 1));
  }
}

/// Edges of a class between one block and the next. An item for each row and seam, the one over the torus edge last.
ERG_ON_DEVICE void slide_column_seams(const Plan& plan, compute::Items items) {
  const std::int32_t blocks = plan.tiles.blocks;
  const std::int32_t seams = plan.open || plan.width <= 2 ? blocks - 1 : blocks;
  // The last row has one above it over the torus edge; on skewed tiles the corners are for slide_corners.
  const std::int32_t rows_below = plan.open || plan.tiles.lean != 0 ? plan.length - 1 : plan.length;
  EACH_ITEM(item, seams * plan.length) {
    const std::int32_t row = item % plan.length;
    const std::int32_t seam = item / plan.length;
    const std::int32_t right = seam + 1 == blocks ? 0 : (seam + 1) * plan.tiles.block_columns;
    const std::int32_t left = right == 0 ? plan.width - 1 : right - 1;
    if (is_across(plan.edges)) {
      slide_edge(plan, cell_in(plan, left, row), cell_in(plan, right, row));
    } else if (row >= rows_below) {
      continue;
    } else if (is_diagonal(plan.edges)) {
      if (plan.length > 1) slide_diagonals_across(plan, left, right, row);
    } else if (skew_step(plan, row) != 0) {
      slide_edge(plan, cell_in(plan, right, row), cell_in(plan, left, row + 1));
    }
  }
}

/// Skewed tiles: diagonal edges between blocks over the torus edge, whose upper cells may belong to any other seam. An
/// item for each seam.
ERG_ON_DEVICE void slide_corners(const Plan& plan, compute::Items items) {
  EACH_ITEM(seam, plan.tiles.blocks) {
    const std::int32_t right = seam + 1 == plan.tiles.blocks ? 0 : (seam + 1) * plan.tiles.block_columns;
    slide_diagonals_across(plan, right == 0 ? plan.width - 1 : right - 1, right, plan.length - 1);
  }
}

}  // namespace erg::models::slab
