// The first kernel of a sub-sweep: which cells lie in shadow. One thread scans some rows of one line.
#pragma once

#include "models/slab/line.h"

namespace erg::models::slab {

/// Height of the shadow line (1/256 slabs) that falls on a row of a line, from all that stands two rows upwind and
/// farther: what a scan from there would bring along. Looks back only as far as the highest cell could still reach, and
/// on a torus until the line has met all its cells, the one in the next row among them.
ERG_ON_DEVICE std::int64_t shadow_from_upwind(const Plan& plan, std::int32_t line, std::int32_t row) {
  const std::int64_t fall = plan.sweep.row_fall;
  const std::int64_t highest = static_cast<std::int64_t>(*plan.highest) << kernels::fixed_point_bits;
  const std::int64_t rows_upwind = plan.open ? row - entering_row(plan, line, row) : plan.sweep.rows_around + 1;
  LineWalk walk = LineWalk::at(plan, line, row);
  walk.go_back(plan);
  std::int64_t shade = 0;
  for (std::int64_t away = 2; away <= rows_upwind && highest - away * fall > shade; ++away) {
    walk.go_back(plan);
    const std::int64_t top = static_cast<std::int64_t>(height_of(plan.before[walk.cell(plan)]))
                             << kernels::fixed_point_bits;
    if (top - away * fall > shade) shade = top - away * fall;
  }
  return shade;
}

/// Height (1/256 slabs) of the cell some rows upwind on a line; 0 before the line comes into an open grid.
ERG_ON_DEVICE std::int64_t top_upwind(const Plan& plan, std::int32_t line, std::int32_t row, int away) {
  if (plan.open && row - away < entering_row(plan, line, row)) return 0;
  return static_cast<std::int64_t>(height_of(plan.before[cell_of(plan, line, row - away)]))
         << kernels::fixed_point_bits;
}

/// Marks the cells in shadow, lays the plane to be written, and finds the highest cell.
ERG_ON_DEVICE void cast_shadow(const Plan& plan, compute::Items items) {
  const std::int32_t pieces = (plan.length + plan.shadow_rows - 1) / plan.shadow_rows;
  const std::int64_t fall = plan.sweep.row_fall;
  if (items.first == 0) *plan.aloft_count = 0;
  EACH_ITEM(item, pieces * plan.width) {
    const std::int32_t line = item % plan.width;
    const std::int32_t first = item / plan.width * plan.shadow_rows;
    const std::int32_t end = first + plan.shadow_rows < plan.length ? first + plan.shadow_rows : plan.length;
    std::int64_t far = shadow_from_upwind(plan, line, first);
    std::int64_t next = top_upwind(plan, line, first, 1);
    std::int64_t second = top_upwind(plan, line, first, 2);
    std::uint32_t highest = 0;
    LineWalk walk = LineWalk::at(plan, line, first);
    for (std::int32_t row = first; row < end; ++row) {
      const std::int32_t cell = walk.cell(plan);
      const std::uint32_t height = height_of(plan.before[cell]);
      const std::int64_t top = static_cast<std::int64_t>(height) << kernels::fixed_point_bits;
      plan.after[cell] = height;
      plan.dark[cell] = top < far || top < next - plan.sweep.next_fall || top < second - plan.sweep.second_fall;
      if (height > highest) highest = height;
      far = (next - fall > far ? next - fall : far) - fall;
      second = next;
      next = top;
      if (walk.go_on(plan) && plan.open) far = next = second = 0;
    }
    compute::raise(plan.next_highest, highest);
  }
}

}  // namespace erg::models::slab
