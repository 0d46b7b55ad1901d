// Kernels of sintering snow in flight. One thread follows one line of the wind through all sub-sweeps of a step; slabs
// in the air wait in the line's own ring of rows, so threads never meet. Oblique lines that go on as others behind the
// torus edge hand over what is in the air to the next launch.
#pragma once

#include "compute/kernel.h"
#include "models/snow/plan.h"

namespace erg::models::snow {

/// The column in which a line meets a row from -1 to length + reach.
ERG_ON_DEVICE std::int32_t column_of(const SnowPlan& plan, std::int32_t line, std::int32_t row) {
  const std::int32_t column = plan.offsets[row + 1] + line;
  return column < plan.width() ? column : column - plan.width();
}
ERG_ON_DEVICE std::int32_t cell_of(const SnowPlan& plan, std::int32_t line, std::int32_t row) {
  const std::int32_t folded_row = row < plan.length() ? row : row % plan.length();
  return folded_row * plan.width() + column_of(plan, line, row);
}
/// The line to which a cell belongs.
ERG_ON_DEVICE std::int32_t line_of(const SnowPlan& plan, std::int32_t cell) {
  const std::int32_t line = cell % plan.width() - plan.offsets[cell / plan.width() + 1];
  return line >= 0 ? line : line + plan.width();
}

/// Bedrock and snow of a cell while flights last.
ERG_ON_DEVICE std::int32_t flown_surface(const SnowPlan& plan, std::int32_t cell) {
  return mobile_of(plan.cells[cell].snow) + plan.ground.bedrock[cell];
}

/// What comes to a cell before bedrock that stands too high over it stays there: hops end at it, and none leave it.
ERG_ON_DEVICE void find_walls(const SnowPlan& plan, compute::Items items) {
  const bool open = !plan.ground.torus;
  EACH_ITEM(cell, plan.cell_count()) {
    const std::int32_t line = line_of(plan, cell);
    const std::int32_t row = cell / plan.width();
    if (open && (row + 1 == plan.length() || column_of(plan, line, row + 1) < cell % plan.width())) continue;
    const std::int32_t next = cell_of(plan, line, row + 1);
    if (plan.ground.bedrock[next] - flown_surface(plan, cell) <= plan.law->wall) continue;
    plan.cells[cell].chances = 0;
    plan.cells[cell].hops = 0;
    plan.over[cell] = over_wall;
  }
}

/// Rows that slabs can fly from each cell before higher ground ends their hop. Beyond an open edge there is none.
ERG_ON_DEVICE void find_runs(const SnowPlan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cell_count()) {
    const std::int32_t line = line_of(plan, cell);
    const std::int32_t row = cell / plan.width();
    const std::int32_t beyond = plan.ground.torus ? row + plan.reach + 1 : plan.length();
    const int height = flying_height(plan.over[cell], plan.law->clearance_16);
    std::int16_t run = unhindered_run;
    for (std::int32_t rows = 1; rows <= plan.reach && row + rows < beyond; ++rows) {
      if (plan.over[cell_of(plan, line, row + rows)] <= height) continue;
      run = static_cast<std::int16_t>(rows);
      break;
    }
    plan.cells[cell].run = run;
  }
}

/// Strength of the uppermost bonded snow in a cell of the terrain. Not a lambda: one of a kernel is the device's alone,
/// and rules are for the host too.
struct StrengthAt {
  const SnowLaw& law;
  std::int32_t place;
  std::int32_t nx;
  std::int32_t mobile;

  ERG_CELL_RULE float operator()() const { return snow_strength(law, place % nx, place / nx, mobile); }
};

/// A line on its way through the sub-sweeps.
class SnowLine {
 public:
  ERG_ON_DEVICE SnowLine(const SnowPlan& plan, std::int32_t number, kernels::StepCounters& counted)
      : plan_(plan), number_(number), counted_(counted) {}

  /// Slabs in the air.
  ERG_ON_DEVICE std::int64_t aloft() const { return aloft_; }

  /// Counts the slabs that were in the air when a launch began.
  ERG_ON_DEVICE void find_aloft() {
    for (std::int32_t row = 0; row <= plan_.ring_mask; ++row) aloft_ += slabs_of(load(row));
  }

  ERG_ON_DEVICE void sweep(const SnowSweep& sweep) {
    std::int32_t polled = -1;  // the row of the block at hand in which a slab lifts
    for (std::int32_t row = 0; row < plan_.length(); ++row) {
      if (sweep.polls && (row & (plan_.polling - 1)) == 0) polled = poll(sweep, row);
      if (!plan_.ground.torus) cross_open_edge(sweep, row);
      if (!sweep.polls && aloft_ == 0) break;
      if (row == polled || aloft_ > 0) visit(sweep, row, row == polled);
    }
    leave_grid();
  }

 private:
  ERG_ON_DEVICE std::uint64_t& load(std::int32_t row) const {
    const auto ring_row = static_cast<std::int32_t>((first_ + static_cast<std::uint32_t>(row)) &
                                                    static_cast<std::uint32_t>(plan_.ring_mask));
    return plan_.ring[static_cast<std::ptrdiff_t>(ring_row) * plan_.width() + number_];
  }

  /// The row of the block that begins at `row` in which a slab lifts; -1 if none does.
  ERG_ON_DEVICE std::int32_t poll(const SnowSweep& sweep, std::int32_t row) const {
    const std::uint32_t word = snow_poll_word(snow_poll_key(sweep, row), static_cast<std::uint32_t>(number_));
    const std::int32_t polled = row + static_cast<std::int32_t>(sweep.polled_row[word >> 24]);
    if (polled >= plan_.length()) return -1;
    const SnowCell& cell = plan_.cells[cell_of(plan_, number_, polled)];
    return snow_lifts(word, sweep.key, cell.snow, cell.chances) ? polled : -1;
  }

  ERG_ON_DEVICE void visit(const SnowSweep& sweep, std::int32_t row, bool lifts) {
    std::uint64_t& waiting = load(row);
    const std::uint64_t arriving = waiting;
    if (!lifts && arriving == 0) return;
    const std::int32_t here = cell_of(plan_, number_, row);
    const std::uint64_t row_word = flight_row_word(sweep.key, row);
    SnowCell cell = plan_.cells[here];
    if (lifts) {
      cell.snow = without_slab(cell.snow);
      ++counted_.of[kernels::counted_lifts];
      if (plan_.lift_counts != nullptr) ++plan_.lift_counts[here];
      launch(cell, row, static_cast<std::uint32_t>(snow_line_word(row_word, number_)));
    }
    if (arriving != 0) {
      waiting = 0;
      aloft_ -= slabs_of(arriving);
      arrive(cell, here, row, arriving, snow_line_word(~row_word, number_), sweep.last);
    }
    plan_.cells[here] = cell;
  }

  ERG_ON_DEVICE void launch(const SnowCell& cell, std::int32_t row, std::uint32_t random) {
    const SnowHop hop = snow_hop(cell.hops, cell.run, random);
    load(row + hop.rows) += hop.load;
    ++aloft_;
    counted_.of[kernels::counted_rows] += hop.rows;
  }

  /// Slabs come down in a cell: they strike it, stay or fly on. All decide on the snow as they find it.
  ERG_ON_DEVICE void arrive(SnowCell& cell, std::int32_t here, std::int32_t row, std::uint64_t arriving,
                            std::uint64_t word, bool last) {
    const std::uint32_t before = cell.snow;
    std::int32_t mobile = mobile_of(before);
    std::int32_t loose = loose_of(before);
    const std::uint32_t rest = last ? certain : chance_to_stay(plan_.rests, before, cell.hops);
    if (loose == 0 && mobile > 0) {
      loose += strikes(cell, here, row, arriving, word);
    }
    for (std::uint32_t slabs = slabs_of(arriving); slabs > 0; --slabs, word = mix64(word)) {
      if (snow_stays(word, rest)) {
        ++mobile;
        ++loose;
        cell.landed = 1;
      } else if (snow_carried_off(word, plan_.rests)) {
        ++counted_.of[kernels::counted_out];
      } else {
        launch(cell, row, static_cast<std::uint32_t>(word >> 32));
      }
    }
    cell.snow = snow_word(loose < mobile ? loose : mobile, mobile);
  }

  /// How many slabs of bonded snow the impacts on a cell free.
  ERG_ON_DEVICE std::int32_t strikes(const SnowCell& cell, std::int32_t here, std::int32_t row, std::uint64_t arriving,
                                     std::uint64_t word) const {
    if (abrasion_of(cell.hops) <= 0) return 0;
    const std::int32_t mobile = mobile_of(cell.snow);
    const float power = strike_power(*plan_.law, cell.hops, arriving, rise(mobile + plan_.ground.bedrock[here], row));
    const auto place = static_cast<std::int32_t>(plan_.order.place(here));
    return freed_slabs(*plan_.law, arriving, word, power, StrengthAt{*plan_.law, place, plan_.nx, mobile});
  }

  /// Slabs by which a surface stands over the cell upwind. Behind the torus edge that is as it was before the flights.
  ERG_ON_DEVICE float rise(std::int32_t surface, std::int32_t row) const {
    if (row > 0) return static_cast<float>(surface - flown_surface(plan_, cell_of(plan_, number_, row - 1)));
    if (!plan_.ground.torus) return 0;
    const std::int32_t upwind = (plan_.length() - 1) * plan_.width() + column_of(plan_, number_, -1);
    return static_cast<float>(surface - plan_.ground.surface(static_cast<std::size_t>(upwind)));
  }

  // --- edges ---

  /// What is in the air over the last row goes on at the other end of the torus, or has left over the open edge.
  ERG_ON_DEVICE void leave_grid() {
    if (plan_.ground.torus && plan_.closes) {
      first_ += static_cast<std::uint32_t>(plan_.length());
    } else if (!plan_.ground.torus) {
      drop_out(plan_.length());
    } else if (aloft_ > 0) {
      hand_over();
    }
  }

  /// To the line that goes on as this one.
  ERG_ON_DEVICE void hand_over() {
    const auto line = static_cast<std::int32_t>((number_ + plan_.drift) % plan_.width());
    for (std::int32_t rows = 0; rows <= plan_.ring_mask; ++rows) {
      std::uint64_t& waiting = load(plan_.length() + rows);
      plan_.aloft[static_cast<std::ptrdiff_t>(rows) * plan_.width() + line] += waiting;
      waiting = 0;
    }
    aloft_ = 0;
    compute::raise(plan_.left, 1);
  }

  /// A line that enters an open grid at this row: what flew in it has left on the other side, and drift comes in.
  ERG_ON_DEVICE void cross_open_edge(const SnowSweep& sweep, std::int32_t row) {
    if (row > 0) {
      if (column_of(plan_, number_, row) != 0 || plan_.offsets[row + 1] == plan_.offsets[row]) return;
      drop_out(row);
    }
    if (plan_.inflow > 0 && sweep.polls) enter(sweep, row);
  }

  ERG_ON_DEVICE void enter(const SnowSweep& sweep, std::int32_t row) {
    std::uint32_t word = entering_word(sweep, number_);
    const int slabs = entering_slabs(plan_.inflow, plan_.polling, word);
    const SnowCell cell = plan_.cells[cell_of(plan_, number_, row)];
    for (int slab = 0; slab < slabs; ++slab) {
      word = next_snow_word(word);
      const int rows = entering_rows(cell.hops, cell.run, word);
      load(row + rows) += one_slab + whole_hop;
      counted_.of[kernels::counted_rows] += rows;
    }
    aloft_ += slabs;
    counted_.of[kernels::counted_in] += slabs;
  }

  /// The slabs in the air at this row have left over an open side.
  ERG_ON_DEVICE void drop_out(std::int32_t row) {
    for (std::int32_t rows = 0; aloft_ > 0 && rows <= plan_.ring_mask; ++rows) {
      std::uint64_t& waiting = load(row + rows);
      const std::int64_t slabs = slabs_of(waiting);
      counted_.of[kernels::counted_out] += slabs;
      counted_.of[kernels::counted_rows] -= slabs * (rows + 1);
      aloft_ -= slabs;
      waiting = 0;
    }
  }

  const SnowPlan& plan_;
  const std::int32_t number_;
  kernels::StepCounters& counted_;
  std::uint32_t first_ = 0;  // the ring's row of the grid's first row
  std::int64_t aloft_ = 0;
};

/// All sub-sweeps. Lines that close on themselves bring down all that is in the air.
ERG_ON_DEVICE void fly(const SnowPlan& plan, compute::Items items) {
  kernels::StepCounters counted;
  EACH_ITEM(number, plan.width()) {
    SnowLine line(plan, number, counted);
    for (int sweep = 0; sweep < plan.polling || (plan.closes && line.aloft() > 0); ++sweep) {
      line.sweep(plan.sweeps[sweep < plan.last_sweep ? sweep : plan.last_sweep]);
    }
  }
  counted.add_to(plan.counters, items);
}

/// A pass without polls, in which lines bring down what others have handed over.
ERG_ON_DEVICE void bring_down(const SnowPlan& plan, compute::Items items) {
  kernels::StepCounters counted;
  EACH_ITEM(number, plan.width()) {
    SnowLine line(plan, number, counted);
    line.find_aloft();
    if (line.aloft() > 0) line.sweep(plan.sweeps[plan.sweep]);
  }
  counted.add_to(plan.counters, items);
}

/// Snow as the flights have left it.
ERG_ON_DEVICE void store(const SnowPlan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cell_count()) {
    const SnowCell flown = plan.cells[cell];
    plan.ground.mobile[cell] = mobile_of(flown.snow);
    plan.ground.loose[cell] = loose_of(flown.snow);
    if (flown.landed != 0) plan.ground.landed[cell] = plan.law->now;
  }
}

}  // namespace erg::models::snow
