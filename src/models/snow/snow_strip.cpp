#include "models/snow/snow_strip.h"

#include <algorithm>

#include "models/slab/sub_sweep.h"

namespace erg {
namespace {

std::uint64_t bit(int line) { return std::uint64_t{1} << line; }

}  // namespace

void SnowStrip::begin(const SnowFlightPlan& plan, int first, int lines) {
  plan_ = plan;
  first_ = first;
  lines_ = lines;
  rows_ = 0;
  rows_ahead_ = 0;
  const SnowPlaces& places = *plan.places;
  const auto cells = static_cast<std::size_t>(places.cells.places + snow_stretch);
  cells_.resize(cells);
  powers_.resize(cells);
  chances_.resize(cells);
  ground_.resize(plan.relief ? cells : 0);
  over_.resize(static_cast<std::size_t>(places.heights.places + places.heights.next_line + snow_stretch));
  const auto windows = static_cast<std::size_t>(plan.windows);
  // Nothing has been left in the air by another strip.
  loads_.resize(windows * snow_lines * snow_window);
  const bool crowded = plan.frame.length + plan.inflow + plan.sweeps >= most_short_slabs;
  excess_.resize(crowded ? loads_.size() : 0);
  falls_.resize(windows * snow_lines);
}

void SnowStrip::load() {
  take_rows(plan_.frame.length);
  draw_polls();
}

void SnowStrip::draw_polls() {
  const int length = plan_.frame.length;
  const auto windows = static_cast<std::size_t>((length + snow_window - 1) / snow_window);
  const auto polls = static_cast<std::size_t>(plan_.sweeps * most_polls(plan_.sweeps));  // of a window
  polls_.resize(windows * polls + snow_lines);
  poll_counts_.resize(windows * static_cast<std::size_t>(plan_.sweeps));
  SnowPollDraw draw;
  draw.sweeps = plan_.sweeps;
  draw.draws = plan_.draws;
  draw.chances = chances_.data();
  draw.polls = polls_.data();
  draw.counts = poll_counts_.data();
  for (int row = 0; row < length; row += snow_window) {
    draw.first_row = row;
    draw.end = std::min(row + snow_window, length);
    plan_.kernels->draw_polls(draw, lines_of());
    draw.polls += polls;
    draw.counts += plan_.sweeps;
  }
}

// --- a sub-sweep ---

void SnowStrip::sweep(const SnowSweep& sweep) {
  const int length = plan_.frame.length;
  const SnowLandings landings = landings_of(sweep);
  const auto number = static_cast<int>(&sweep - plan_.draws);
  SnowAir air = air_of();
  alignas(64) std::uint64_t row_words[snow_window];
  for (int begin = 0; begin < length && (sweep.polls || anything_aloft()); begin += snow_window) {
    const int end = std::min(begin + snow_window, length);
    if (end > rows_) take_rows(end);
    plan_.kernels->draw_rows(sweep.key, begin, row_words);
    const std::uint64_t crossing = plan_.boundary == Boundary::open ? find_crossing(begin, end) : 0;
    late_.clear();
    if (sweep.polls) lift(begin, number, row_words, crossing, air);
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

bool SnowStrip::anything_aloft() const {
  return std::any_of(falls_.begin(), falls_.end(), [](std::uint32_t falls) { return falls != 0; });
}

SnowLines SnowStrip::lines_of() {
  const SnowLayout& layout = plan_.places->cells;
  return {cells_.data(), powers_.data(), layout.rows.data(), layout.next_line, first_, lines_};
}

SnowLandings SnowStrip::landings_of(const SnowSweep& sweep) {
  SnowLandings landings;
  landings.law = plan_.law;
  landings.lines = lines_of();
  landings.ground = plan_.relief ? ground_.data() : nullptr;
  landings.upwind = plan_.upwind + first_;
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

/// Lifts slabs from a window. All may lift before any comes down in it: neither changes what the other reads.
void SnowStrip::lift(int begin, int number, const std::uint64_t* row_words, std::uint64_t crossing, SnowAir& air) {
  const auto window = static_cast<std::size_t>(begin / snow_window);
  const auto most = static_cast<std::size_t>(most_polls(plan_.sweeps));
  const std::size_t list = window * static_cast<std::size_t>(plan_.sweeps) + static_cast<std::size_t>(number);
  const int count = poll_counts_[list];
  SnowPolls polls;
  polls.polls = polls_.data() + list * most;
  polls.first_row = begin;
  polls.row_words = row_words;
  SnowLifts lifts;
  for (int done = 0; done < count; done += snow_lines, polls.polls += snow_lines) {
    polls.count = std::min(snow_lines, count - done);
    plan_.kernels->lift(polls, lines_of(), air, lifts);
    counts_.lifts += lifts.lifted;
    for (int k = 0; plan_.lift_counts != nullptr && k < lifts.count; ++k) {
      if (lifts.load[k] == 0) continue;
      ++(*plan_.lift_counts)[plan_.frame.cell(column(lifts.row[k], lifts.line[k]), lifts.row[k])];
    }
    if (crossing != 0) hold_back(crossing, lifts);
    plan_.kernels->launch(lifts, air);
  }
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
  const int window = (row / snow_window & (plan_.windows - 1)) * snow_lines + line;
  const int place = window * snow_window + row % snow_window;
  const SnowAir air = air_of();
  const std::uint64_t all = air.all_of(place, air.loads[place]) + load;
  if (slabs_of(all) < most_short_slabs) {
    air.loads[place] = slabs_of(all) * short_slab + static_cast<std::uint32_t>(all);
  } else {
    air.loads[place] = most_short_slabs * short_slab;
    air.excess[place] = all - long_load(air.loads[place]);
  }
  air.falls[window] |= 1u << row % snow_window;
}

/// Takes all that is in the air over a line, where the first row that may have any is `first`: calls
/// visit(row, load).
template <typename Visit>
void SnowStrip::take_all(int line, int first, const Visit& visit) {
  const SnowAir air = air_of();
  const int window = first / snow_window;
  for (int number = window; number < window + plan_.windows; ++number) {
    const int there = (number & (plan_.windows - 1)) * snow_lines + line;
    for (std::uint32_t& falls = air.falls[there]; falls != 0; falls &= falls - 1) {
      const int row = __builtin_ctz(falls);
      const int place = there * snow_window + row;
      visit(number * snow_window + row, air.all_of(place, air.loads[place]));
      if (air.excess != nullptr) air.excess[place] = 0;
      air.loads[place] = 0;
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
  for (int k = 0; k < lifts.count; ++k) {
    if (lifts.load[k] == 0 || (crossing & bit(lifts.line[k])) == 0) continue;
    late_.push_back({lifts.line[k], lifts.row[k], lifts.fall[k], long_load(lifts.load[k])});
    lifts.rows_flown -= lifts.fall[k] - lifts.row[k];
    lifts.load[k] = 0;
    lifts.bit[k] = 0;
  }
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
  const StripCell& cell = cells_[at(row, line)];
  for (int slab = 0; slab < slabs; ++slab) {
    word = next_snow_word(word);
    const int rows = entering_rows(cell.way, run_of(cell.way), word);
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
