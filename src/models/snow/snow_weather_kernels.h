// Kernels of sintering snow that make a step's weather: heights, their means over boxes, shadow, chances. One thread,
// one cell; shadow is followed for some rows.
#pragma once

#include "compute/kernel.h"
#include "core/grid.h"
#include "models/snow/plan.h"

namespace erg::models::snow {

/// Heights of all surfaces, how high and low they reach, and how much snow lies anywhere.
ERG_ON_DEVICE void measure(const SnowPlan& plan, compute::Items items) {
  std::uint32_t highest = 0;
  std::uint32_t not_lowest = 0;
  std::uint32_t snow = 0;
  EACH_ITEM(cell, plan.cell_count()) {
    const auto here = static_cast<std::size_t>(cell);
    const auto height = static_cast<std::uint32_t>(plan.ground.surface(here) - plan.base);
    const auto mobile = static_cast<std::uint32_t>(plan.ground.mobile[here]);
    plan.heights[cell] = height;
    if (height > highest) highest = height;
    if (~height > not_lowest) not_lowest = ~height;
    if (mobile > snow) snow = mobile;
  }
  compute::raise(plan.bounds + bound_highest, highest);
  compute::raise(plan.bounds + bound_not_lowest, not_lowest);
  compute::raise(plan.bounds + bound_snow, snow);
}

ERG_ON_DEVICE std::uint32_t lowest_surface(const SnowPlan& plan) { return ~plan.bounds[bound_not_lowest]; }

// --- means over boxes, from exact whole sums ---

/// A row or column number that may lie beyond the edges: the torus goes on, an open grid repeats its outermost cells.
ERG_ON_DEVICE std::int32_t folded(std::int32_t at, std::int32_t count, bool torus) {
  if (at >= 0 && at < count) return at;
  if (torus) return wrap(at, count);
  return at < 0 ? 0 : count - 1;
}

/// Sum over the cells of a box's column around (u, v).
template <typename Number>
ERG_ON_DEVICE std::uint64_t sum_of_column(const SnowPlan& plan, const Number* numbers, std::int32_t u, std::int32_t v) {
  std::uint64_t sum = 0;
  for (std::int32_t row = v - plan.radius; row <= v + plan.radius; ++row) {
    sum += numbers[folded(row, plan.length(), plan.ground.torus) * plan.width() + u];
  }
  return sum;
}

/// Sum over the columns of a box around a cell.
ERG_ON_DEVICE std::uint64_t sum_of_columns(const SnowPlan& plan, std::int32_t cell) {
  const std::int32_t u = cell % plan.width();
  const std::uint64_t* row = plan.columns + (cell - u);
  std::uint64_t sum = 0;
  for (std::int32_t column = u - plan.radius; column <= u + plan.radius; ++column) {
    sum += row[folded(column, plan.width(), plan.ground.torus)];
  }
  return sum;
}

/// Columns of boxes: heights over the lowest surface.
ERG_ON_DEVICE void sum_heights(const SnowPlan& plan, compute::Items items) {
  const std::uint64_t lowest = lowest_surface(plan);
  const auto cells = static_cast<std::uint64_t>(2 * plan.radius + 1);
  EACH_ITEM(cell, plan.cell_count()) {
    const std::uint64_t sum = sum_of_column(plan, plan.heights, cell % plan.width(), cell / plan.width());
    plan.columns[cell] = sum - cells * lowest;
  }
}

/// The same of sums over boxes.
ERG_ON_DEVICE void sum_columns(const SnowPlan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cell_count()) {
    plan.columns[cell] = sum_of_column(plan, plan.sums, cell % plan.width(), cell / plan.width());
  }
}

ERG_ON_DEVICE void sum_rows(const SnowPlan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cell_count()) { plan.sums[cell] = sum_of_columns(plan, cell); }
}

ERG_ON_DEVICE void average_rows(const SnowPlan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cell_count()) {
    plan.means[cell] = static_cast<float>(static_cast<std::int64_t>(sum_of_columns(plan, cell))) * plan.share;
  }
}

// --- shadow ---

/// Shadow lines of a step on the device.
ERG_ON_DEVICE SnowShadow shadow_of(const SnowPlan& plan) {
  const auto relief = static_cast<int>(plan.bounds[bound_highest] - lowest_surface(plan));
  return snow_shadow(plan.shadow_fall, plan.tangent, plan.cosine, !plan.ground.torus, plan.length(), relief);
}

/// The column in which a line's shadow meets a row, which may lie before the grid.
ERG_ON_DEVICE std::int32_t shadow_column(const SnowPlan& plan, const SnowShadow& shadow, std::int32_t line,
                                         std::int32_t row) {
  return wrap(static_cast<std::int32_t>(line + shadow.sideways(row)), plan.width());
}

/// Height over the lowest surface, in fixed point.
ERG_ON_DEVICE std::int64_t shadow_height(const SnowPlan& plan, std::int32_t column, std::int32_t row) {
  const std::uint32_t height = plan.heights[wrap(row, plan.length()) * plan.width() + column];
  return static_cast<std::int64_t>(height - lowest_surface(plan)) << kernels::fixed_point_bits;
}

/// The shadow line that comes to row `first` of a line from all that stands upwind, 0 where it lies below all ground.
/// Looks back only as far as the highest surface could still reach. Over an open side nothing comes in.
ERG_ON_DEVICE std::int64_t snow_shadow_from_upwind(const SnowPlan& plan, const SnowShadow& shadow, std::int32_t line,
                                                   std::int32_t first) {
  const std::int64_t summit = static_cast<std::int64_t>(plan.bounds[bound_highest] - lowest_surface(plan))
                              << kernels::fixed_point_bits;
  std::int64_t far = 0;
  std::int64_t fallen = shadow.fall_far;
  for (std::int32_t row = first - 1; row >= shadow.start && summit - fallen > far; --row) {
    const std::int32_t column = shadow_column(plan, shadow, line, row);
    const std::int64_t reaches = shadow_height(plan, column, row) - fallen;
    if (reaches > far) far = reaches;
    if (!plan.ground.torus && column == 0) break;
    fallen += shadow.fall_far;
  }
  return far;
}

/// Marks the cells in shadow. One thread follows a line for some rows.
ERG_ON_DEVICE void cast_shadow(const SnowPlan& plan, compute::Items items) {
  const SnowShadow shadow = shadow_of(plan);
  const std::int32_t pieces = (plan.length() + plan.shadow_rows - 1) / plan.shadow_rows;
  EACH_ITEM(item, pieces * plan.width()) {
    const std::int32_t line = item % plan.width();
    const std::int32_t first = item / plan.width() * plan.shadow_rows;
    const std::int32_t end = first + plan.shadow_rows < plan.length() ? first + plan.shadow_rows : plan.length();
    std::int64_t far = snow_shadow_from_upwind(plan, shadow, line, first);
    std::int64_t near = 0;
    if (first > shadow.start) {
      near = shadow_height(plan, shadow_column(plan, shadow, line, first - 1), first - 1) - shadow.fall_near;
    }
    for (std::int32_t row = first; row < end; ++row) {
      const std::int32_t column = shadow_column(plan, shadow, line, row);
      if (!plan.ground.torus && column == 0) far = near = 0;  // enters over the side, or begins here
      const std::int64_t height = shadow_height(plan, column, row);
      plan.dark[row * plan.width() + column] = height < (far > near ? far : near) ? 1 : 0;
      far = (height > far ? height : far) - shadow.fall_far;
      near = height - shadow.fall_near;
    }
  }
}

// --- chances ---

/// The weather of a cell, and the cell as flights find it.
ERG_ON_DEVICE void make_weather(const SnowPlan& plan, compute::Items items) {
  const SnowLaw& law = *plan.law;
  const bool torus = plan.ground.torus;
  std::uint32_t longest = 0;
  EACH_ITEM(cell, plan.cell_count()) {
    const std::int32_t u = cell % plan.width();
    const std::int32_t v = cell / plan.width();
    const auto level = [&](std::int32_t column, std::int32_t row) {
      return plan.level[folded(row, plan.length(), torus) * plan.width() + folded(column, plan.width(), torus)];
    };
    SnowPlace place;
    place.level = plan.level[cell];
    place.around = plan.around[cell];
    place.slope = plan.along * (level(u, v + 1) - level(u, v - 1)) + plan.across * (level(u + 1, v) - level(u - 1, v));
    place.surface = static_cast<std::int32_t>(plan.heights[cell] - lowest_surface(plan));
    place.rest = law.now - plan.ground.landed[cell];
    place.age = plan.age[cell];
    place.dark = plan.dark[cell];
    const TransportRates weather = transport_rates(law, place, static_cast<float>(plan.cosine));
    SnowCell made;
    made.snow = snow_word(plan.ground.loose[cell], plan.ground.mobile[cell]);
    made.chances = weather.chances;
    made.hops = weather.hops;
    plan.cells[cell] = made;
    plan.over[cell] = static_cast<std::int16_t>(weather.over);
    if (mean_hop_64(weather.hops) > longest) longest = mean_hop_64(weather.hops);
  }
  compute::raise(plan.bounds + bound_hop, longest);
}

}  // namespace erg::models::snow
