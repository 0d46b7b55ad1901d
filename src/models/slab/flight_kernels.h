// Kernels that lift slabs and fly them until they stay. One thread lifts one slab and follows it; the carry over the
// torus edge takes a line.
#pragma once

#include "models/slab/line.h"

namespace erg::models::slab {

/// A cell as a slab meets it: chances, random words. `row` may lie beyond the grid; it keys the random numbers.
struct Ground {
  std::int32_t cell = 0;
  std::uint32_t line = 0;
  std::uint32_t height = 0;
  std::uint64_t word = 0;          // of the row
  std::uint32_t landing_word = 0;  // of the line's quad
  std::uint32_t chance = 0;        // to stay, of 256
  bool sure = false;               // everything stays
  bool held = false;               // nothing lifts
};

ERG_ON_DEVICE Ground ground_at(const Plan& plan, std::int32_t line, std::int32_t row) {
  Ground ground;
  ground.cell = cell_of(plan, line, row);
  ground.line = static_cast<std::uint32_t>(line);
  ground.height = height_of(plan.before[ground.cell]);
  ground.word = row_word(plan.sweep.sweep_word, static_cast<std::uint32_t>(row));
  ground.landing_word = quad_word(draw_key(ground.word, Draw::first_landing), ground.line >> 2);
  const bool dark = plan.dark[ground.cell] != 0;
  const bool sand = ground.height != (plan.bedrock ? plan.bedrock[ground.cell] : 0u);
  ground.chance = byte_chance(sand ? plan.sweep.p_sand_16 : plan.sweep.p_bare_16, ground.word);
  ground.sure = dark || ground.chance > 255;
  ground.held = !sand || (dark && !plan.sweep.lift_in_shadow);
  if (plan.cover) {
    const std::uint32_t cover = plan.cover[ground.cell];
    ground.held = ground.held || cover == 255 || line_byte(draw_key(ground.word, Draw::cover), ground.line) < cover;
    ground.sure = ground.sure || cover == 255;
    ground.chance = covered_chance(ground.chance, cover);
  }
  return ground;
}

ERG_ON_DEVICE std::uint32_t byte_of(std::uint32_t word, std::uint32_t line) {
  return (word >> (8 * (line & 3))) & 0xff;
}

/// Whether the slab that comes down as number `slab` (from 0) stays.
ERG_ON_DEVICE bool stays(const Ground& ground, std::uint32_t slab) {
  if (ground.sure) return true;
  if (slab == 0) return byte_of(ground.landing_word, ground.line) < ground.chance;
  if (slab == 1) return byte_of(next_word(ground.landing_word, Draw::second_landing), ground.line) < ground.chance;
  const std::uint32_t key = draw_key(ground.word, static_cast<std::uint32_t>(Draw::first_landing) + slab);
  return line_byte(key, ground.line) < ground.chance;
}

/// Rows of the hop from here: of a slab that is lifted.
ERG_ON_DEVICE std::int32_t hop_from(const Plan& plan, const Ground& ground, std::int32_t row) {
  if (plan.hop_by_height) {
    const std::uint32_t random = byte_of(next_word(ground.landing_word, Draw::hop), ground.line);
    return static_cast<std::int32_t>(hop_rows(plan.hop_table[ground.height], random));
  }
  const std::uint32_t rows_256 = plan.hop_table[0];
  const std::uint32_t key = hop_key(plan.sweep.sweep_word, static_cast<std::uint32_t>(row), rows_256);
  return static_cast<std::int32_t>(hop_rows(rows_256, line_byte(key, ground.line)));
}

/// Of one in the air.
ERG_ON_DEVICE std::int32_t rows_on_from(const Plan& plan, const Ground& ground, std::int32_t row) {
  return static_cast<std::int32_t>(rows_on(static_cast<std::uint32_t>(hop_from(plan, ground, row))));
}

ERG_ON_DEVICE void set_down(const Plan& plan, std::int32_t cell, std::uint32_t slabs) {
  if (slabs == 0) return;
  compute::raise(plan.next_highest, height_of(compute::atomic_add(plan.after + cell, slabs)) + slabs);
}

/// The first row from `row` on, before `end`, over which slabs drop because bedrock stands too steeply in the next one;
/// `end` where there is none (Cimbura 2022, algorithm 7).
ERG_ON_DEVICE std::int32_t wall_before(const Plan& plan, std::int32_t line, std::int32_t row, std::int32_t end) {
  if (!plan.walls) return end;
  LineWalk walk = LineWalk::at(plan, line, row);
  for (; row < end; ++row) {
    const std::uint32_t ground = height_of(plan.before[walk.cell(plan)]);
    walk.go_on(plan);
    if (plan.bedrock[walk.cell(plan)] > ground + static_cast<std::uint32_t>(plan.sweep.wall_step)) return row;
  }
  return end;
}

/// Lets `slabs` fly from `row` toward `end` on their line: they drop at a wall or leave an open grid on their way, or
/// get there. Returns whether they got there, and books the rows that they did not fly.
ERG_ON_DEVICE bool fly(const Plan& plan, std::int32_t line, std::int32_t row, std::int32_t end, std::uint32_t slabs,
                       kernels::StepCounters& counted) {
  const std::int32_t edge = plan.open ? leaving_row(plan, line, row) : end + 1;
  // Over an open edge no wall is met.
  const std::int32_t walls_end = end < edge - 1 ? end : edge - 1;
  const std::int32_t wall = wall_before(plan, line, row, walls_end);
  if (wall < walls_end) {
    set_down(plan, cell_of(plan, line, wall), slabs);
    counted.of[kernels::counted_rows] -= static_cast<std::int64_t>(end - wall) * slabs;
    return false;
  }
  if (end < edge) return true;
  counted.of[kernels::counted_out] += slabs;
  counted.of[kernels::counted_rows] -= static_cast<std::int64_t>(end - edge) * slabs;
  return false;
}

/// Hands a slab that comes down beyond the torus edge to its line's list.
ERG_ON_DEVICE void carry_over(const Plan& plan, std::int32_t line, std::int32_t row) {
  const std::int32_t place = compute::atomic_add(plan.aloft_count, 1);
  plan.aloft[place].row = row;
  plan.aloft[place].next = compute::atomic_exchange(plan.first_aloft + line, place);
}

/// Follows one slab from `row`, where it is in the air, to where it comes down next, and on until it stays.
ERG_ON_DEVICE void follow(const Plan& plan, std::int32_t line, std::int32_t row, std::int32_t end,
                          kernels::StepCounters& counted) {
  while (fly(plan, line, row, end, 1, counted)) {
    if (end >= plan.length) {
      carry_over(plan, line, end);
      return;
    }
    const Ground ground = ground_at(plan, line, end);
    const std::uint32_t number = compute::atomic_add(plan.after + ground.cell, one_arrival) >> 16;
    if (stays(ground, number)) {
      set_down(plan, ground.cell, 1);
      return;
    }
    const std::int32_t rows = rows_on_from(plan, ground, end);
    counted.of[kernels::counted_rows] += rows;
    row = end;
    end = row + rows;
  }
}

/// Open boundary: slabs come in at row 0 (items up to the width) and where lines enter sideways (one item a row).
ERG_ON_DEVICE void let_in(const Plan& plan, compute::Items items) {
  kernels::StepCounters counted;
  EACH_ITEM(item, plan.width + plan.length - 1) {
    std::int32_t row = 0;
    std::int32_t line = item;
    if (item >= plan.width) {
      row = item - plan.width + 1;
      const std::int32_t offset = offset_of(plan, row);
      if (offset == offset_of(plan, row - 1)) continue;
      line = wrapped(-offset, plan.width);
    }
    const Ground ground = ground_at(plan, line, row);
    const std::uint32_t random = mix32(draw_key(ground.word, Draw::inflow) ^ ground.line * 0x9e3779b9u);
    const int slabs = static_cast<int>(plan.sweep.inflow + (random >> 16) * (1.0 / 65536));
    const std::uint64_t rows_256 = plan.hop_table[plan.hop_by_height ? ground.height : 0];
    for (int slab = 0; slab < slabs; ++slab) {
      // Where in its hop a slab crosses the edge is random: it comes down up to one hop further on.
      const std::uint32_t part = mix32(random + static_cast<std::uint32_t>(slab)) >> 16;
      follow(plan, line, row, row + static_cast<std::int32_t>((rows_256 * part) >> 24), counted);
    }
    counted.of[kernels::counted_in] += slabs;
  }
  counted.add_to(plan.counters, items);
}

/// Whether a poll is among those that a shortened sub-sweep carries out.
ERG_ON_DEVICE bool carried_out(const SubSweep& sweep, std::uint64_t word, std::uint32_t line) {
  return sweep.poll_share_16 >= whole_share_16 ||
         line_byte(draw_key(word, Draw::share), line) < byte_chance(sweep.poll_share_16, word);
}

/// Polls one cell in each block of a line, lifts its slab and follows it.
ERG_ON_DEVICE void lift(const Plan& plan, compute::Items items) {
  kernels::StepCounters counted;
  const std::int32_t block = poll_rows(plan.sweep);
  const std::int32_t blocks = (plan.length + block - 1) / block;
  // Nobody reads this bound any more; it starts anew for the plane after the next.
  if (items.first == 0) *plan.highest = 0;
  EACH_ITEM(item, blocks * plan.width) {
    const std::int32_t line = item % plan.width;
    const auto number = static_cast<std::uint32_t>(item / plan.width);
    const std::uint64_t word = row_word(plan.sweep.poll_word, number);
    if (!carried_out(plan.sweep, word, static_cast<std::uint32_t>(line))) continue;
    const std::uint32_t random = line_byte(draw_key(word, Draw::poll), static_cast<std::uint32_t>(line));
    const std::uint32_t in_block = plan.sweep.permuted ? plan.sweep.polled_row[random]
                                                       : random & static_cast<std::uint32_t>(plan.sweep.sweeps - 1);
    const auto row = static_cast<std::int32_t>(number) * block + static_cast<std::int32_t>(in_block);
    if (in_block >= static_cast<std::uint32_t>(block) || row >= plan.length) continue;
    ++counted.of[kernels::counted_polls];
    const Ground ground = ground_at(plan, line, row);
    if (ground.held) continue;
    const std::int32_t rows = hop_from(plan, ground, row);
    ++counted.of[kernels::counted_lifts];
    // Nobody else polls this cell in this sub-sweep.
    if (plan.lift_counts) ++plan.lift_counts[plan.order.place(ground.cell)];
    if (rows == 0) continue;  // it lies where it lay
    compute::atomic_add(plan.after + ground.cell, ~std::uint32_t{0});
    counted.of[kernels::counted_rows] += rows;
    follow(plan, line, row, row + rows, counted);
  }
  counted.add_to(plan.counters, items);
}

/// The next row at which slabs of a list come down, and how many.
struct Arrivals {
  std::int32_t row = INT32_MAX;
  std::uint32_t slabs = 0;
};

ERG_ON_DEVICE Arrivals next_arrivals(const Plan& plan, std::int32_t first) {
  Arrivals arrivals;
  for (std::int32_t slab = first; slab >= 0; slab = plan.aloft[slab].next) {
    const std::int32_t row = plan.aloft[slab].row;
    if (row > arrivals.row || row == INT32_MAX) continue;
    arrivals.slabs = row == arrivals.row ? arrivals.slabs + 1 : 1;
    arrivals.row = row;
  }
  return arrivals;
}

/// Lets slabs that came down at `from` fly on: `slabs` of them to `to`; the others stay and leave the list.
ERG_ON_DEVICE void send_on(const Plan& plan, std::int32_t first, std::int32_t from, std::int32_t to,
                           std::uint32_t slabs) {
  for (std::int32_t slab = first; slab >= 0; slab = plan.aloft[slab].next) {
    if (plan.aloft[slab].row != from) continue;
    plan.aloft[slab].row = slabs > 0 ? to : INT32_MAX;
    slabs -= slabs > 0 ? 1 : 0;
  }
}

/// Slabs that flew over the torus edge go on until they stay, row after row of a line.
ERG_ON_DEVICE void carry(const Plan& plan, compute::Items items) {
  kernels::StepCounters counted;
  const std::int64_t last_free_row = static_cast<std::int64_t>(longest_flight + 1) * plan.length;
  EACH_ITEM(item, plan.width) {
    const std::int32_t line = item;
    const std::int32_t first = plan.first_aloft[line];
    plan.first_aloft[line] = -1;
    for (Arrivals now = next_arrivals(plan, first); now.slabs > 0; now = next_arrivals(plan, first)) {
      Ground ground = ground_at(plan, line, now.row);
      ground.sure = ground.sure || now.row > last_free_row;
      std::uint32_t landed = 0;
      for (std::uint32_t slab = 0; slab < now.slabs; ++slab) landed += stays(ground, slab) ? 1 : 0;
      set_down(plan, ground.cell, landed);
      std::uint32_t leaving = now.slabs - landed;
      const std::int32_t rows = rows_on_from(plan, ground, now.row);
      counted.of[kernels::counted_rows] += static_cast<std::int64_t>(rows) * leaving;
      if (leaving > 0 && !fly(plan, line, now.row, now.row + rows, leaving, counted)) leaving = 0;
      send_on(plan, first, now.row, now.row + rows, leaving);
    }
  }
  counted.add_to(plan.counters, items);
}

}  // namespace erg::models::slab
