// What the kernels of slabs share: heights, and where lines lie.
#pragma once

#include "compute/kernel.h"
#include "models/slab/plan.h"

namespace erg::models::slab {

ERG_ON_DEVICE std::uint32_t height_of(std::uint32_t ground_word) { return ground_word & height_mask; }

ERG_ON_DEVICE std::int32_t wrapped(std::int32_t value, std::int32_t period) {
  const std::int32_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

/// Columns that lines have moved sideways when they meet a row, which may lie before or beyond the grid.
ERG_ON_DEVICE std::int32_t offset_of(const Plan& plan, std::int32_t row) {
  if (!plan.sweep.oblique) return 0;
  return line_offset(row, plan.sweep.drift, plan.sweep.phase, plan.length);
}

/// The cell where a line meets a row, which may lie before or beyond the grid.
ERG_ON_DEVICE std::int32_t cell_of(const Plan& plan, std::int32_t line, std::int32_t row) {
  return wrapped(row, plan.length) * plan.width + wrapped(line + offset_of(plan, row), plan.width);
}

/// A line on its way from row to row, for those who visit many.
struct LineWalk {
  std::int64_t rest = 0;  // (row * drift + phase) mod length
  std::int32_t column = 0;
  std::int32_t row = 0;  // folded into the grid

  ERG_ON_DEVICE static LineWalk at(const Plan& plan, std::int32_t line, std::int32_t row) {
    LineWalk walk;
    const std::int32_t offset = offset_of(plan, row);
    walk.rest = row * plan.sweep.drift + plan.sweep.phase - std::int64_t{offset} * plan.length;
    walk.column = wrapped(line + offset, plan.width);
    walk.row = wrapped(row, plan.length);
    return walk;
  }
  ERG_ON_DEVICE std::int32_t cell(const Plan& plan) const { return row * plan.width + column; }
  /// Goes on to the next row; true where the line leaves one side of the grid and enters the other.
  ERG_ON_DEVICE bool go_on(const Plan& plan) {
    row = row + 1 == plan.length ? 0 : row + 1;
    rest += plan.sweep.drift;
    if (rest < plan.length) return false;
    rest -= plan.length;
    column = column + 1 == plan.width ? 0 : column + 1;
    return column == 0;
  }
  ERG_ON_DEVICE void go_back(const Plan& plan) {
    row = row == 0 ? plan.length - 1 : row - 1;
    rest -= plan.sweep.drift;
    if (rest >= 0) return;
    rest += plan.length;
    column = column == 0 ? plan.width - 1 : column - 1;
  }
};

/// Open boundary: the first row after `row` where the line has left the grid, sideways or at its end.
ERG_ON_DEVICE std::int32_t leaving_row(const Plan& plan, std::int32_t line, std::int32_t row) {
  if (plan.sweep.drift == 0) return plan.length;
  const std::int64_t rounds = (line + offset_of(plan, row)) / plan.width + 1;
  const std::int64_t offset = rounds * plan.width - line;
  const std::int64_t first = (offset * plan.length - plan.sweep.phase + plan.sweep.drift - 1) / plan.sweep.drift;
  return first < plan.length ? static_cast<std::int32_t>(first) : plan.length;
}

/// Open boundary: the last row up to `row` at which the line came into the grid.
ERG_ON_DEVICE std::int32_t entering_row(const Plan& plan, std::int32_t line, std::int32_t row) {
  if (plan.sweep.drift == 0) return 0;
  const std::int64_t rounds = (line + offset_of(plan, row)) / plan.width;
  if (rounds == 0) return 0;
  const std::int64_t offset = rounds * plan.width - line;
  const std::int64_t first = (offset * plan.length - plan.sweep.phase + plan.sweep.drift - 1) / plan.sweep.drift;
  return first > 0 ? static_cast<std::int32_t>(first) : 0;
}

}  // namespace erg::models::slab
