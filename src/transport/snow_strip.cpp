#include "transport/snow_strip.h"

#include <algorithm>
#include <limits>

#include "transport/sub_sweep.h"

namespace erg {
namespace {

constexpr std::uint64_t one_slab = std::uint64_t{1} << 32;
constexpr std::uint32_t whole_hop = 256;    // share of a hop that is flown
constexpr std::int16_t over_wall = 0x7fff;  // higher than any slab flies
constexpr std::int32_t no_surface = std::numeric_limits<std::int32_t>::min();
constexpr std::uint32_t golden = 0x9e3779b9u;

std::uint64_t bit(int line) { return std::uint64_t{1} << line; }

std::uint32_t chance(float share) { return static_cast<std::uint32_t>(std::clamp(share, 0.0f, 1.0f) * 65536); }

/// A further random word.
std::uint32_t next(std::uint32_t word) { return mix32(word + 0x85ebca6bu); }

}  // namespace

// --- terrain in and out ---

int SnowStrip::column(int row, int line) const {
  const int column = plan_.offsets[row + 1] + first_ + line;
  return column < plan_.frame.width ? column : column % plan_.frame.width;
}

/// Calls visit(row, line, cell of the terrain), neighbours in memory one after another. Rows may lie beyond the grid.
template <typename Visit>
void SnowStrip::for_cells(int begin, int end, const Visit& visit) const {
  const WindFrame& frame = plan_.frame;
  constexpr int rows_at_once = 32;
  const bool lines_in_memory = frame.step_v == 1 || frame.step_v == -1;
  for (int first_row = begin; first_row < end; first_row += rows_at_once) {
    const int end_row = std::min(first_row + rows_at_once, end);
    const auto cell = [&](int row, int line) {
      const int v = row >= 0 && row < frame.length ? row : wrap(row, frame.length);
      return frame.cell(column(row, line), v);
    };
    if (lines_in_memory) {
      for (int line = 0; line < lines_; ++line) {
        for (int row = first_row; row < end_row; ++row) visit(row, line, cell(row, line));
      }
    } else {
      for (int row = first_row; row < end_row; ++row) {
        for (int line = 0; line < lines_; ++line) visit(row, line, cell(row, line));
      }
    }
  }
}

void SnowStrip::load(const SnowFlightPlan& plan, int first, int lines) {
  plan_ = plan;
  first_ = first;
  lines_ = lines;
  counts_ = {};
  const SnowLaw& law = *plan.law;
  rest_loose_ = chance(law.rest_loose);
  rest_hard_ = chance(law.rest_hard);
  rest_ground_ = chance(law.rest_ground);
  suspension_ = chance(law.suspension);
  const int length = plan.frame.length;
  const std::size_t cells = at(length, 0);
  snow_.resize(cells);
  chances_.resize(cells);
  hops_.resize(cells);
  runs_.resize(cells);
  over_.resize(at(length + plan.reach + 1, 0));
  ground_.resize(at(length + 1, 0));
  landed_.assign(static_cast<std::size_t>(length), 0);
  ring_.assign(at(plan.ring_rows, 0), 0);
  arrived_.assign(static_cast<std::size_t>(plan.ring_rows), 0);
  const auto ground = [&](std::size_t cell) { return plan.relief ? plan.bedrock[cell] : 0; };
  for_cells(0, length, [&](int row, int line, std::size_t cell) {
    const std::size_t here = at(row, line);
    snow_[here] = snow_word(plan.loose[cell], plan.mobile[cell]);
    chances_[here] = plan.chances[cell];
    hops_[here] = plan.hops[cell];
    over_[here] = plan.over[cell];
    ground_[here] = ground(cell);
  });
  // Beyond an open edge nothing stands in the way.
  std::fill(over_.begin() + static_cast<std::ptrdiff_t>(cells), over_.end(), static_cast<std::int16_t>(-highest_over));
  std::fill(upwind_, upwind_ + snow_lines, no_surface);
  if (plan.boundary == Boundary::torus) {
    for_cells(-1, 0, [&](int, int line, std::size_t cell) { upwind_[line] = ground(cell) + plan.mobile[cell]; });
    load_beyond_edge();
  }
  if (plan.relief) find_walls();
  find_runs();
}

/// What a hop over the torus edge meets.
void SnowStrip::load_beyond_edge() {
  const WindFrame& frame = plan_.frame;
  const int length = frame.length;
  for_cells(length, length + plan_.reach, [&](int row, int line, std::size_t cell) {
    over_[at(row, line)] = plan_.over[cell];
    if (!plan_.relief) return;
    const std::size_t next = frame.cell(column(row + 1, line), wrap(row + 1, length));
    if (before_wall(plan_.bedrock[next], plan_.bedrock[cell] + plan_.mobile[cell])) {
      over_[at(row, line)] = over_wall;
    }
    if (row == length) ground_[at(row, line)] = plan_.bedrock[cell];
  });
}

/// What comes to a cell before bedrock that stands too high over it stays there: hops end at it, and none leave it.
void SnowStrip::find_walls() {
  const int rows = plan_.boundary == Boundary::torus ? plan_.frame.length : plan_.frame.length - 1;
  for (int row = 0; row < rows; ++row) {
    for (int line = 0; line < lines_; ++line) {
      const std::size_t here = at(row, line);
      if (!before_wall(ground_[at(row + 1, line)], ground_[here] + mobile_of(snow_[here]))) continue;
      if (plan_.boundary == Boundary::open && column(row + 1, line) < column(row, line)) continue;
      chances_[here] = 0;
      hops_[here] = 0;
      over_[here] = over_wall;
    }
  }
}

void SnowStrip::find_runs() {
  for (int row = 0; row < plan_.frame.length; ++row) {
    plan_.kernels->free_runs(over_.data() + at(row, 0), plan_.law->clearance_16, plan_.reach,
                             runs_.data() + at(row, 0));
  }
}

void SnowStrip::store() {
  const float now = plan_.law->now;
  for_cells(0, plan_.frame.length, [&](int row, int line, std::size_t cell) {
    const std::uint32_t snow = snow_[at(row, line)];
    plan_.mobile[cell] = mobile_of(snow);
    plan_.loose[cell] = loose_of(snow);
    if (landed_[static_cast<std::size_t>(row)] & bit(line)) plan_.landed[cell] = now;
  });
}

// --- a sub-sweep ---

void SnowStrip::sweep(const SnowSweep& sweep) {
  carried_.clear();
  std::uint64_t lifts[64] = {};
  const int length = plan_.frame.length;
  for (int row = 0; row < length; ++row) {
    const std::uint64_t lifted = sweep.polls ? find_lifts(row, sweep, lifts) : 0;
    if (plan_.boundary == Boundary::open) cross_open_edges(row, sweep);
    std::uint64_t all = lifted | arrived(row);
    if (all == 0) continue;
    const std::uint32_t row_key = mix32(sweep.key + static_cast<std::uint32_t>(row) * golden);
    for (; all != 0; all &= all - 1) {
      const int line = __builtin_ctzll(all);
      visit(row, line, (lifted & bit(line)) != 0, row_key, sweep);
    }
    arrived(row) = 0;
  }
  leave_grid();
}

/// The lines that lift a slab in this row. Those of a block of rows are found together.
std::uint64_t SnowStrip::find_lifts(int row, const SnowSweep& sweep, std::uint64_t (&lifts)[64]) {
  const int in_block = row & (plan_.sweeps - 1);
  if (in_block == 0) {
    std::fill(lifts, lifts + plan_.sweeps, std::uint64_t{0});
    SnowPolls polls;
    polls.rows = std::min(plan_.sweeps, plan_.frame.length - row);
    // One permutation of a block's rows for all sub-sweeps of the step, but chances of their own.
    polls.key = mix32(sweep.step_key + static_cast<std::uint32_t>(row) * golden);
    polls.chance_key = sweep.key;
    polls.first_line = static_cast<std::uint32_t>(first_);
    polls.lines = lines_;
    polls.polled_row = sweep.polled_row;
    polls.snow = snow_.data() + at(row, 0);
    polls.chances = chances_.data() + at(row, 0);
    polls.lifts = lifts;
    plan_.kernels->poll(polls);
  }
  return lifts[in_block];
}

/// A cell in which slabs lift or come down. Its decisions read the snow as this sub-sweep finds it.
void SnowStrip::visit(int row, int line, bool lifts, std::uint32_t row_key, const SnowSweep& sweep) {
  const std::size_t here = at(row, line);
  const std::uint32_t before = snow_[here];
  const bool hard = loose_of(before) == 0;
  std::int32_t mobile = mobile_of(before);
  std::int32_t loose = loose_of(before);
  std::uint32_t word = mix32(row_key + static_cast<std::uint32_t>(first_ + line) * golden);
  if (lifts) {
    --mobile;
    if (!hard) --loose;
    ++counts_.lifts;
    launch(row, line, word);
    word = next(word);
  }
  std::uint64_t& waiting = ring(row, line);
  if (const std::uint64_t load = waiting; load != 0) {
    waiting = 0;
    if (hard && mobile_of(before) > 0) loose += strikes(row, line, load, word);
    const bool stays_always = sweep.last || mean_hop_64(hops_[here]) == 0;
    const std::uint32_t rest = !hard ? rest_loose_ : (mobile_of(before) > 0 ? rest_hard_ : rest_ground_);
    for (auto slabs = load / one_slab; slabs > 0; --slabs) {
      word = next(word);
      if (stays_always || (word & 0xffff) < rest) {
        ++mobile;
        ++loose;
        landed_[static_cast<std::size_t>(row)] |= bit(line);
      } else if ((word >> 16) < suspension_) {
        ++counts_.slabs_out;
      } else {
        launch(row, line, next(word ^ golden));
      }
    }
  }
  snow_[here] = snow_word(std::min(loose, mobile), mobile);
}

/// How many slabs of bonded snow the impacts on a cell free.
int SnowStrip::strikes(int row, int line, std::uint64_t load, std::uint32_t word) {
  const std::size_t here = at(row, line);
  const float strength = abrasion_of(hops_[here]);
  if (strength <= 0) return 0;
  const std::int32_t surface = ground_[here] + mobile_of(snow_[here]);
  std::int32_t upwind = upwind_[line];
  if (row > 0) {
    const std::size_t before = at(row - 1, line);
    upwind = ground_[before] + mobile_of(snow_[before]);
  }
  const float rise = upwind == no_surface ? 0.0f : static_cast<float>(surface - upwind);
  const auto slabs = static_cast<std::uint32_t>(load / one_slab);
  const float flown = static_cast<float>(load % one_slab) / static_cast<float>(slabs * whole_hop);
  const float power = strength * impact_share(*plan_.law, rise) * flown;
  if (power <= 0) return 0;
  int freed = 0;
  for (std::uint32_t slab = 0; slab < slabs; ++slab) {
    word = next(word ^ 0x2545f491u);
    if (struck(row, line, power, word >> 8)) ++freed;
  }
  return freed;
}

bool SnowStrip::struck(int row, int line, float power, std::uint32_t random) const {
  const float drawn = unit_24(random);
  if (!may_free(*plan_.law, drawn, power)) return false;
  const std::size_t cell = plan_.frame.cell(column(row, line), row);
  const auto width = static_cast<std::size_t>(plan_.extent.nx);
  return drawn * snow_strength(*plan_.law, static_cast<int>(cell % width), static_cast<int>(cell / width),
                               mobile_of(snow_[at(row, line)])) <
         power;
}

/// Sends a slab from a cell to the row where it comes down next.
void SnowStrip::launch(int row, int line, std::uint32_t word) {
  const std::size_t here = at(row, line);
  const int rows = snow_hop_rows(hops_[here], word);
  const int run = runs_[here];
  std::uint64_t load = one_slab + whole_hop;
  int flown = rows;
  if (run < rows) {
    flown = run;
    load = one_slab + whole_hop * static_cast<std::uint32_t>(run) / static_cast<std::uint32_t>(rows);
  }
  ring(row + flown, line) += load;
  arrived(row + flown) |= bit(line);
  counts_.rows_flown += flown;
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
        counts_.slabs_out += static_cast<std::int64_t>(load / one_slab);
        counts_.rows_flown -= static_cast<std::int64_t>(load / one_slab) * (rows + 1);
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
  if (plan_.offsets[row + 1] == plan_.offsets[row]) return;
  const int width = plan_.frame.width;
  const int line = wrap(-plan_.offsets[row + 1] - first_, width);  // it stands in column 0 now
  if (line >= lines_) return;
  drop_out(row, line);
  enter(row, line, sweep);
}

void SnowStrip::enter(int row, int line, const SnowSweep& sweep) {
  if (plan_.inflow <= 0 || !sweep.polls) return;
  std::uint32_t word = mix32(sweep.key ^ mix32(static_cast<std::uint32_t>(first_ + line) * golden + 1));
  const auto slabs = static_cast<int>(plan_.inflow / plan_.sweeps + static_cast<double>(unit_24(word >> 8)));
  const std::size_t here = at(row, line);
  for (int slab = 0; slab < slabs; ++slab) {
    // Where in its hop a slab crosses the edge is random.
    word = next(word);
    const std::uint32_t part = mean_hop_64(hops_[here]) * (word >> 16) >> 16;
    const int hop = mean_hop_64(hops_[here]) > 0 ? snow_hop_rows(part, next(word ^ golden)) : 0;
    const int rows = std::min<int>(hop, runs_[here]);
    receive(line, row + rows, one_slab + whole_hop);
    counts_.rows_flown += rows;
  }
  counts_.slabs_in += slabs;
}

/// The slabs in the air over a line have left over an open side.
void SnowStrip::drop_out(int row, int line) {
  for (int rows = 0; rows < plan_.ring_rows; ++rows) {
    std::uint64_t& load = ring(row + rows, line);
    counts_.slabs_out += static_cast<std::int64_t>(load / one_slab);
    counts_.rows_flown -= static_cast<std::int64_t>(load / one_slab) * (rows + 1);
    load = 0;
    arrived(row + rows) &= ~bit(line);
  }
}

}  // namespace erg
