#include "transport/snow_strip.h"

#include <algorithm>
#include <limits>

namespace erg {
namespace {

constexpr std::int32_t no_surface = std::numeric_limits<std::int32_t>::min();

std::uint64_t bit(int line) { return std::uint64_t{1} << line; }

}  // namespace

/// The ring while a sub-sweep runs.
struct SnowStrip::Air {
  std::uint64_t* ring;
  std::uint64_t* arrivals;
  int mask;
  std::int64_t rows_flown = 0;

  std::uint64_t& arrived(int row) { return arrivals[row & mask]; }
  std::uint64_t& load(int row, int line) { return ring[(row & mask) * snow_lines + line]; }
  /// Sends a slab from a cell to the row where it comes down next.
  void launch(const SnowCell& cell, int row, int line, std::uint32_t random) {
    const SnowHop hop = snow_hop(cell, random);
    load(row + hop.rows, line) += hop.load;
    arrived(row + hop.rows) |= bit(line);
    rows_flown += hop.rows;
  }
};

// --- terrain in and out ---

int SnowStrip::column(int row, int line) const {
  const int column = offset(row) + first_ + line;
  return column < plan_.frame.width ? column : column - plan_.frame.width;
}

/// Calls visit(cell of a layer, cell of the terrain), neighbours in memory one after another. Rows may lie beyond the
/// grid.
template <typename Visit>
void SnowStrip::for_cells(int begin, int end, const Visit& visit) const {
  // Copies, which nothing that a visit writes can change.
  const WindFrame frame = plan_.frame;
  const int* const offsets = plan_.offsets + 1;
  const int first_line = first_;
  const int lines = lines_;
  const auto cell_of = [&](int row, int line) {
    const int u = offsets[row] + first_line + line;
    const int v = row < frame.length ? row : row % frame.length;
    return frame.cell(u < frame.width ? u : u - frame.width, v);
  };
  if (next_row_ != 1) {
    for (int row = begin; row < end; ++row) {
      const std::size_t here = at(row, 0);
      for (int line = 0; line < lines; ++line) visit(here + static_cast<std::size_t>(line), cell_of(row, line));
    }
    return;
  }
  // Oblique lines cross the terrain's rows: a part of all lines at a time, so that what they meet is still at hand.
  constexpr int rows_at_once = 64;
  const bool straight = plan_.drift == 0 && end <= frame.length;
  for (int first = begin; first < end; first += rows_at_once) {
    const int rows = std::min(rows_at_once, end - first);
    for (int line = 0; line < lines; ++line) {
      const std::size_t here = at(first, line);
      if (straight) {
        const auto cell = static_cast<std::ptrdiff_t>(cell_of(first, line));
        const std::ptrdiff_t step = frame.step_v;
        for (int k = 0; k < rows; ++k) {
          visit(here + static_cast<std::size_t>(k), static_cast<std::size_t>(cell + k * step));
        }
      } else {
        for (int k = 0; k < rows; ++k) visit(here + static_cast<std::size_t>(k), cell_of(first + k, line));
      }
    }
  }
}

/// Cells lie side by side as they do in the terrain; lines a little apart, so that they do not compete for one place in
/// a cache.
void SnowStrip::lay_out() {
  const WindFrame& frame = plan_.frame;
  const int rows = frame.length + plan_.reach + 64;
  const bool lines_in_memory = frame.step_v == 1 || frame.step_v == -1;
  next_row_ = lines_in_memory ? 1 : snow_lines;
  next_line_ = lines_in_memory ? (rows + 127) / 128 * 128 + 36 : 1;
  const std::size_t cells = lines_in_memory ? at(0, lines_) : at(rows, 0);
  cells_.resize(cells);
  over_.resize(cells);
  ground_.resize(plan_.relief ? cells : 0);
}

void SnowStrip::load(const SnowFlightPlan& plan, int first, int lines) {
  plan_ = plan;
  first_ = first;
  lines_ = lines;
  counts_ = {};
  carried_.clear();
  rests_ = snow_rests(*plan.law);
  lay_out();
  ring_.assign(static_cast<std::size_t>(plan.ring_rows) * snow_lines, 0);
  arrived_.assign(static_cast<std::size_t>(plan.ring_rows), 0);
  const int length = plan.frame.length;
  SnowCell* const cells = cells_.data();
  std::int16_t* const over = over_.data();
  for_cells(0, length, [=, from = plan](std::size_t here, std::size_t cell) {
    cells[here] = {snow_word(from.loose[cell], from.mobile[cell]), from.chances[cell], from.hops[cell], 0, 0};
    over[here] = from.over[cell];
  });
  std::fill(upwind_, upwind_ + snow_lines, no_surface);
  load_beyond_edge();
  if (plan.relief) find_walls();
  find_runs();
}

/// What a hop over the edge meets. Beyond an open one nothing stands in the way.
void SnowStrip::load_beyond_edge() {
  const int length = plan_.frame.length;
  const int end = length + plan_.reach;
  if (plan_.boundary == Boundary::open) {
    for_cells(length, end, [&](std::size_t here, std::size_t) { over_[here] = -highest_over; });
    return;
  }
  for_cells(length, end, [&](std::size_t here, std::size_t cell) {
    cells_[here].snow = snow_word(0, plan_.mobile[cell]);
    over_[here] = plan_.over[cell];
  });
  for (int line = 0; line < lines_; ++line) {
    const std::size_t cell = plan_.frame.cell(column(-1, line), length - 1);
    upwind_[line] = plan_.mobile[cell] + (plan_.relief ? plan_.bedrock[cell] : 0);
  }
}

/// What comes to a cell before bedrock that stands too high over it stays there: hops end at it, and none leave it.
void SnowStrip::find_walls() {
  const bool open = plan_.boundary == Boundary::open;
  const int rows = open ? plan_.frame.length : plan_.frame.length + plan_.reach;
  for_cells(0, rows, [&](std::size_t here, std::size_t cell) { ground_[here] = plan_.bedrock[cell]; });
  for (int line = 0; line < lines_; ++line) {
    for (int row = 0; row + 1 < rows; ++row) {
      const std::size_t here = at(row, line);
      if (ground_[at(row + 1, line)] - surface(here) <= plan_.law->wall) continue;
      if (open && column(row + 1, line) < column(row, line)) continue;
      cells_[here].chances = 0;
      cells_[here].hops = 0;
      over_[here] = over_wall;
    }
  }
}

void SnowStrip::find_runs() {
  const int length = plan_.frame.length;
  const auto find = [&](std::size_t here, int count) {
    plan_.kernels->find_runs(over_.data() + here, next_row_, plan_.law->clearance_16, plan_.reach, cells_.data() + here,
                             count);
  };
  if (next_row_ != 1) {
    for (int row = 0; row < length; ++row) find(at(row, 0), snow_lines);
    return;
  }
  for (int line = 0; line < lines_; ++line) {
    for (int row = 0; row < length; row += 64) find(at(row, line), std::min(64, length - row));
  }
}

void SnowStrip::store() {
  const float now = plan_.law->now;
  const SnowCell* const cells = cells_.data();
  for_cells(0, plan_.frame.length, [=, to = plan_](std::size_t here, std::size_t cell) {
    const SnowCell& mine = cells[here];
    to.mobile[cell] = mobile_of(mine.snow);
    to.loose[cell] = loose_of(mine.snow);
    to.landed[cell] = mine.landed != 0 ? now : to.landed[cell];
  });
}

// --- a sub-sweep ---

void SnowStrip::sweep(const SnowSweep& sweep) {
  std::uint64_t lifts[64] = {};
  Air air{ring_.data(), arrived_.data(), plan_.ring_rows - 1};
  const int length = plan_.frame.length;
  for (int row = 0; row < length; ++row) {
    std::uint64_t lifted = sweep.polls ? find_lifts(row, sweep, lifts) : 0;
    if (plan_.boundary == Boundary::open) cross_open_edges(row, sweep);
    if ((lifted | air.arrived(row)) == 0) continue;
    const std::uint64_t row_word = snow_row_word(sweep.key, row);
    SnowCell* cells = cells_.data() + at(row, 0);
    counts_.lifts += __builtin_popcountll(lifted);
    for (; lifted != 0; lifted &= lifted - 1) {
      const int line = __builtin_ctzll(lifted);
      SnowCell& cell = cells[line * next_line_];
      cell.snow = without_slab(cell.snow);
      if (plan_.lift_counts != nullptr) ++(*plan_.lift_counts)[plan_.frame.cell(column(row, line), row)];
      air.launch(cell, row, line, static_cast<std::uint32_t>(line_word(row_word, line)));
    }
    for (std::uint64_t all = air.arrived(row); all != 0; all &= all - 1) {
      const int line = __builtin_ctzll(all);
      arrive(cells[line * next_line_], row, line, row_word, sweep.last, air);
    }
    air.arrived(row) = 0;
  }
  counts_.rows_flown += air.rows_flown;
  leave_grid();
}

/// Slabs come down in a cell: they strike it, stay or fly on. All decide on the snow as they find it.
inline void SnowStrip::arrive(SnowCell& cell, int row, int line, std::uint64_t row_word, bool last, Air& air) {
  std::uint64_t& waiting = air.load(row, line);
  const std::uint64_t load = waiting;
  waiting = 0;
  const std::uint32_t before = cell.snow;
  std::int32_t mobile = mobile_of(before);
  std::int32_t loose = loose_of(before);
  const std::uint32_t rest = last ? certain : chance_to_stay(rests_, before, cell.hops);
  std::uint64_t word = line_word(~row_word, line);
  if (loose == 0 && mobile > 0) loose += strikes(row, line, load, mix32(static_cast<std::uint32_t>(word >> 32)));
  for (std::uint32_t slabs = slabs_of(load);; word = mix64(word)) {
    if (snow_stays(word, rest)) {
      ++mobile;
      ++loose;
      cell.landed = 1;
    } else if (snow_carried_off(word, rests_)) {
      ++counts_.slabs_out;
    } else {
      air.launch(cell, row, line, static_cast<std::uint32_t>(word >> 32));
    }
    if (--slabs == 0) break;
  }
  cell.snow = snow_word(std::min(loose, mobile), mobile);
}

/// The lines that lift a slab in this row. Those of a block of rows are found together.
std::uint64_t SnowStrip::find_lifts(int row, const SnowSweep& sweep, std::uint64_t (&lifts)[64]) {
  const int in_block = row & (plan_.sweeps - 1);
  if (in_block == 0) {
    std::fill(lifts, lifts + plan_.sweeps, std::uint64_t{0});
    SnowPolls polls;
    polls.rows = std::min(plan_.sweeps, plan_.frame.length - row);
    polls.key = snow_poll_key(sweep, row);
    polls.chance_key = sweep.key;
    polls.first_line = static_cast<std::uint32_t>(first_);
    polls.lines = lines_;
    polls.polled_row = sweep.polled_row;
    polls.cells = cells_.data() + at(row, 0);
    polls.next_row = next_row_;
    polls.next_line = next_line_;
    polls.lifts = lifts;
    plan_.kernels->poll(polls);
  }
  return lifts[in_block];
}

/// How many slabs of bonded snow the impacts on a cell free.
int SnowStrip::strikes(int row, int line, std::uint64_t load, std::uint32_t word) const {
  const std::size_t here = at(row, line);
  const std::uint32_t hops = cells_[here].hops;
  if (abrasion_of(hops) <= 0) return 0;
  const std::int32_t upwind = row > 0 ? surface(at(row - 1, line)) : upwind_[line];
  const float rise = upwind == no_surface ? 0.0f : static_cast<float>(surface(here) - upwind);
  const float power = strike_power(*plan_.law, hops, load, rise);
  if (power <= 0) return 0;
  int freed = 0;
  for (std::uint32_t slab = 0; slab < slabs_of(load); ++slab) {
    const float drawn = unit_24(word);
    word = next_snow_word(word);
    if (may_free(*plan_.law, drawn, power) && drawn * strength(row, line) < power) ++freed;
  }
  return freed;
}

float SnowStrip::strength(int row, int line) const {
  const std::size_t cell = plan_.frame.cell(column(row, line), row);
  const auto width = static_cast<std::size_t>(plan_.extent.nx);
  return snow_strength(*plan_.law, static_cast<int>(cell % width), static_cast<int>(cell / width),
                       mobile_of(cells_[at(row, line)].snow));
}

/// What is in the air over the last row goes on at the other end of the torus, or has left over the open edge.
void SnowStrip::leave_grid() {
  const int length = plan_.frame.length;
  for (int rows = 0; rows < plan_.ring_rows; ++rows) {
    std::uint64_t& lines = arrived(length + rows);
    for (; lines != 0; lines &= lines - 1) {
      const int line = __builtin_ctzll(lines);
      std::uint64_t& load = ring(length + rows, line);
      if (plan_.boundary == Boundary::torus) {
        carried_.push_back({static_cast<std::uint32_t>(first_ + line), rows, load});
      } else {
        counts_.slabs_out += slabs_of(load);
        counts_.rows_flown -= std::int64_t{slabs_of(load)} * (rows + 1);
      }
      load = 0;
    }
  }
}

void SnowStrip::receive(int line, int row, std::uint64_t load) {
  ring(row, line) += load;
  arrived(row) |= bit(line);
}

// --- open edges ---

/// Lines that enter the grid at this row: what flew in them has left on the other side, and drift comes in.
void SnowStrip::cross_open_edges(int row, const SnowSweep& sweep) {
  if (row == 0) {
    for (int line = 0; line < lines_; ++line) enter(row, line, sweep);
    return;
  }
  if (offset(row) == offset(row - 1)) return;
  const int width = plan_.frame.width;
  const int line = wrap(-offset(row) - first_, width);  // it stands in column 0 now
  if (line >= lines_) return;
  drop_out(row, line);
  enter(row, line, sweep);
}

void SnowStrip::enter(int row, int line, const SnowSweep& sweep) {
  if (plan_.inflow <= 0 || !sweep.polls) return;
  std::uint32_t word = entering_word(sweep, first_ + line);
  const int slabs = entering_slabs(plan_.inflow, plan_.sweeps, word);
  const SnowCell& cell = cells_[at(row, line)];
  for (int slab = 0; slab < slabs; ++slab) {
    word = next_snow_word(word);
    const int rows = entering_rows(cell, word);
    receive(line, row + rows, one_slab + whole_hop);
    counts_.rows_flown += rows;
  }
  counts_.slabs_in += slabs;
}

/// The slabs in the air over a line have left over an open side.
void SnowStrip::drop_out(int row, int line) {
  for (int rows = 0; rows < plan_.ring_rows; ++rows) {
    std::uint64_t& load = ring(row + rows, line);
    counts_.slabs_out += slabs_of(load);
    counts_.rows_flown -= std::int64_t{slabs_of(load)} * (rows + 1);
    load = 0;
    arrived(row + rows) &= ~bit(line);
  }
}

}  // namespace erg
