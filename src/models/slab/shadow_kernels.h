// The first kernel of a sub-sweep: which cells lie in shadow. One thread scans some rows of one line.
#pragma once

#include "models/slab/line.h"

namespace erg::slab {

/// Height of the shadow line (1/256 slabs) that falls on a row of a line, from all that stands upwind: what a scan from
/// there would bring along. Looks back only as far as the highest cell could still reach, and once around the torus.
ERG_ON_DEVICE std::int64_t shadow_from_upwind(const Plan& plan, std::int32_t line, std::int32_t row) {
  const std::int64_t fall = plan.sweep.row_fall;
  const std::int64_t highest = static_cast<std::int64_t>(*plan.highest) << fixed_point_bits;
  const std::int64_t rows_upwind = plan.open ? row - entering_row(plan, line, row) : plan.sweep.rows_around;
  LineWalk walk = LineWalk::at(plan, line, row);
  std::int64_t shade = 0;
  for (std::int64_t away = 1; away <= rows_upwind && highest - away * fall > shade; ++away) {
    walk.go_back(plan);
    const std::int64_t top = static_cast<std::int64_t>(height_of(plan.before[walk.cell(plan)])) << fixed_point_bits;
    if (top - away * fall > shade) shade = top - away * fall;
  }
  return shade;
}

/// The same from the next cell upwind, which an oblique wind meets nearer than a row's length.
ERG_ON_DEVICE std::int64_t shadow_from_next(const Plan& plan, std::int32_t line, std::int32_t row) {
  if (plan.open && entering_row(plan, line, row) == row) return 0;
  const std::uint32_t height = height_of(plan.before[cell_of(plan, line, row - 1)]);
  return (static_cast<std::int64_t>(height) << fixed_point_bits) - plan.sweep.adjacent_fall;
}

/// Marks the cells in shadow, lays the plane to be written, and finds the highest cell.
ERG_ON_DEVICE void cast_shadow(const Plan& plan, Items items) {
  const std::int32_t pieces = (plan.length + plan.shadow_rows - 1) / plan.shadow_rows;
  const std::int64_t fall = plan.sweep.row_fall;
  if (items.first == 0) *plan.aloft_count = 0;
  EACH_ITEM(item, pieces * plan.width) {
    const std::int32_t line = item % plan.width;
    const std::int32_t first = item / plan.width * plan.shadow_rows;
    const std::int32_t end = first + plan.shadow_rows < plan.length ? first + plan.shadow_rows : plan.length;
    std::int64_t far = shadow_from_upwind(plan, line, first);
    std::int64_t near = plan.sweep.oblique ? shadow_from_next(plan, line, first) : 0;
    std::uint32_t highest = 0;
    LineWalk walk = LineWalk::at(plan, line, first);
    for (std::int32_t row = first; row < end; ++row) {
      const std::int32_t cell = walk.cell(plan);
      const std::uint32_t height = height_of(plan.before[cell]);
      const std::int64_t top = static_cast<std::int64_t>(height) << fixed_point_bits;
      plan.after[cell] = height;
      plan.dark[cell] = top < far || (plan.sweep.oblique && top < near) ? 1 : 0;
      if (height > highest) highest = height;
      far = (top > far ? top : far) - fall;
      near = top - plan.sweep.adjacent_fall;
      if (walk.go_on(plan) && plan.open) far = near = 0;
    }
    raise(plan.next_highest, highest);
  }
}

}  // namespace erg::slab
