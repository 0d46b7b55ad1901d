#include "transport/snow_strip.h"

#include <algorithm>

#include "transport/sub_sweep.h"

namespace erg {
namespace {

std::uint64_t bit(int line) { return std::uint64_t{1} << line; }

}  // namespace

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
  for (int first = begin; first < end; first += rows_at_once) {
    const int rows = std::min(rows_at_once, end - first);
    for (int line = 0; line < lines; ++line) {
      const std::size_t here = at(first, line);
      for (int k = 0; k < rows; ++k) visit(here + static_cast<std::size_t>(k), cell_of(first + k, line));
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
  const std::size_t cells = lines_in_memory ? at(0, snow_lines) : at(rows, 0);
  cells_.resize(cells);
  over_.resize(cells);
  ground_.resize(plan_.relief ? cells : 0);
}

void SnowStrip::swap_memory(SnowStrip& other) {
  cells_.swap(other.cells_);
  over_.swap(other.over_);
  ground_.swap(other.ground_);
  loads_.swap(other.loads_);
  falls_.swap(other.falls_);
}

void SnowStrip::load(const SnowFlightPlan& plan, int first, int lines) {
  plan_ = plan;
  first_ = first;
  lines_ = lines;
  counts_ = {};
  carried_.clear();
  lay_out();
  next_load_ = plan.windows * snow_window + 8;
  loads_.assign(static_cast<std::size_t>(next_load_) * snow_lines, 0);
  falls_.assign(static_cast<std::size_t>(plan.windows) * snow_lines, 0);
  exchange(true);
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

// --- a sub-sweep ---

void SnowStrip::sweep(const SnowSweep& sweep) {
  const int length = plan_.frame.length;
  const SnowLandings landings = landings_of(sweep);
  SnowAir air = air_of();
  alignas(64) std::uint64_t row_words[snow_window];
  for (int begin = 0; begin < length; begin += snow_window) {
    const int end = std::min(begin + snow_window, length);
    plan_.kernels->draw_rows(sweep.key, begin, row_words);
    const std::uint64_t crossing = plan_.boundary == Boundary::open ? find_crossing(begin, end) : 0;
    late_.clear();
    for (int row = begin; sweep.polls && row < end; row += plan_.sweeps) {
      lift(row, std::min(row + plan_.sweeps, end), sweep, row_words + (row - begin), crossing, air);
    }
    if (begin == 0 && plan_.boundary == Boundary::open) {
      for (int line = 0; line < lines_; ++line) enter(0, line, sweep);
    }
    plan_.kernels->land(landings, row_words, begin, end, ~crossing, air);
    if (crossing != 0) cross_open_side(landings, row_words, begin, end, sweep, air);
  }
  counts_.rows_flown += air.rows_flown;
  counts_.slabs_out += air.carried_off;
  leave_grid();
}

SnowLandings SnowStrip::landings_of(const SnowSweep& sweep) {
  SnowLandings landings;
  landings.law = plan_.law;
  landings.lines = lines_of();
  landings.ground = plan_.relief ? ground_.data() : nullptr;
  landings.upwind = upwind_;
  landings.rests = snow_rests(*plan_.law);
  landings.last = sweep.last;
  landings.offsets = plan_.offsets + 1;
  landings.width = plan_.frame.width;
  landings.origin = plan_.frame.origin;
  landings.step_u = plan_.frame.step_u;
  landings.step_v = plan_.frame.step_v;
  landings.nx = plan_.extent.nx;
  return landings;
}

/// Lifts slabs from a block of rows. A block's slabs may lift before any comes down in it: neither changes what the
/// other reads.
void SnowStrip::lift(int begin, int end, const SnowSweep& sweep, const std::uint64_t* row_words, std::uint64_t crossing,
                     SnowAir& air) {
  SnowPolls polls;
  polls.first_row = begin;
  polls.rows = end - begin;
  polls.key = snow_poll_key(sweep, begin);
  polls.chance_key = sweep.key;
  polls.polled_row = sweep.polled_row;
  polls.row_words = row_words;
  SnowLifts lifts;
  plan_.kernels->lift(polls, lines_of(), air, lifts);
  counts_.lifts += lifts.count;
  for (int k = 0; plan_.lift_counts != nullptr && k < lifts.count; ++k) {
    ++(*plan_.lift_counts)[plan_.frame.cell(column(lifts.row[k], lifts.line[k]), lifts.row[k])];
  }
  if (crossing != 0) hold_back(crossing, lifts);
  plan_.kernels->launch(lifts, air);
}

/// What is in the air over the last row goes on at the other end of the torus, or has left over the open edge.
void SnowStrip::leave_grid() {
  const int length = plan_.frame.length;
  for (int line = 0; line < lines_; ++line) {
    if (plan_.boundary == Boundary::open) {
      drop_out(length, line);
      continue;
    }
    take_all(line, length, [&](int row, std::uint64_t load) {
      carried_.push_back({static_cast<std::uint32_t>(first_ + line), row - length, load});
    });
  }
}

void SnowStrip::receive(int line, int row, std::uint64_t load) {
  const int place = row & (plan_.windows * snow_window - 1);
  loads_[static_cast<std::size_t>(line * next_load_ + place)] += load;
  falls_[static_cast<std::size_t>(place / snow_window * snow_lines + line)] |= bit(row % snow_window);
}

/// Takes all that is in the air over a line, where the first row that may have any is `first`: calls
/// visit(row, load).
template <typename Visit>
void SnowStrip::take_all(int line, int first, const Visit& visit) {
  const int window = first / snow_window;
  for (int number = window; number < window + plan_.windows; ++number) {
    const int place = number & (plan_.windows - 1);
    std::uint64_t& falls = falls_[static_cast<std::size_t>(place * snow_lines + line)];
    for (; falls != 0; falls &= falls - 1) {
      const int row = __builtin_ctzll(falls);
      std::uint64_t& load = loads_[static_cast<std::size_t>(line * next_load_ + place * snow_window + row)];
      visit(number * snow_window + row, load);
      load = 0;
    }
  }
}

// --- open edges ---

/// The line that stands in column 0 from this row on, numbered from the strip's first; beyond the strip where none
/// does.
int SnowStrip::entering_line(int row) const {
  return offset(row) == offset(row - 1) ? snow_lines : wrap(-offset(row) - first_, plan_.frame.width);
}

/// The lines that cross an open side in these rows, as bits.
std::uint64_t SnowStrip::find_crossing(int begin, int end) const {
  std::uint64_t crossing = 0;
  for (int row = std::max(begin, 1); row < end; ++row) {
    if (const int line = entering_line(row); line < lines_) crossing |= bit(line);
  }
  return crossing;
}

/// Slabs of such lines lift later, for what is in the air when they cross is lost.
void SnowStrip::hold_back(std::uint64_t crossing, SnowLifts& lifts) {
  int count = 0;
  for (int k = 0; k < lifts.count; ++k) {
    if ((crossing & bit(lifts.line[k])) != 0) {
      late_.push_back({lifts.line[k], lifts.row[k], lifts.fall[k], lifts.load[k]});
      lifts.rows_flown -= lifts.fall[k] - lifts.row[k];
      continue;
    }
    lifts.place[count] = lifts.place[k];
    lifts.window[count] = lifts.window[k];
    lifts.load[count] = lifts.load[k];
    lifts.bit[count] = lifts.bit[k];
    ++count;
  }
  lifts.count = count;
}

/// Lines that cross an open side: what flew in them has left there, and drift comes in on the other side.
void SnowStrip::cross_open_side(const SnowLandings& landings, const std::uint64_t* row_words, int begin, int end,
                                const SnowSweep& sweep, SnowAir& air) {
  for (int line = 0; line < lines_; ++line) {
    if (begin > 0 && entering_line(begin) == line) {
      drop_out(begin, line);
      enter(begin, line, sweep);
    }
    for (int first = begin; first < end && (find_crossing(begin, end) & bit(line)) != 0;) {
      int next = first + 1;
      while (next < end && entering_line(next) != line) ++next;
      for (const LateLift& slab : late_) {
        if (slab.line != line || slab.row < first || slab.row >= next) continue;
        receive(line, slab.fall, slab.load);
        air.rows_flown += slab.fall - slab.row;
      }
      plan_.kernels->land(landings, row_words, begin, next, bit(line), air);
      if (next < end) {
        drop_out(next, line);
        enter(next, line, sweep);
      }
      first = next;
    }
  }
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
  take_all(line, row, [&](int there, std::uint64_t load) {
    const std::int64_t slabs = slabs_of(load);
    counts_.slabs_out += slabs;
    counts_.rows_flown -= slabs * (there - row + 1);
  });
}

}  // namespace erg
