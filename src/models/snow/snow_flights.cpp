#include "models/snow/snow_flights.h"

#include <algorithm>
#include <bit>

#include "compute/work_queue.h"

namespace erg {

StepReport SnowFlights::fly(SnowFlightPlan plan, InstructionSet instructions, Executor& executor) {
  plan_ = plan;
  plan_.kernels = &snow_kernels(instructions);
  draws_.draw_sweeps(plan_.key, plan_.sweeps);
  draws_.draw_lines(plan_.frame, plan_.key, plan_.longest_mean_hop);
  places_.lay_out(plan_.frame, draws_);
  find_upwind();
  plan_.draws = draws_.sweeps.data();
  plan_.reach = draws_.reach;
  plan_.offsets = draws_.offsets.data();
  plan_.upwind = upwind_.data();
  plan_.places = &places_;
  plan_.windows =
      static_cast<int>(std::bit_ceil(static_cast<unsigned>((plan_.reach + snow_window - 1) / snow_window + 1)));
  if (plan_.relief) find_walls(executor);
  strips_.resize(static_cast<std::size_t>(executor.threads()));
  for (SnowStrip& strip : strips_) strip.forget_counts();
  for_strips(executor, [this](SnowStrip& strip, int first) {
    begin(strip, first);
    strip.load();
    fly_strip(strip, first);
    strip.store();
  });
  if (!lines_close()) bring_down(executor);
  StepReport report;
  std::int64_t rows_flown = 0;
  for (const SnowStrip& strip : strips_) {
    report.lifts += strip.counts().lifts;
    report.slabs_in += strip.counts().slabs_in;
    report.slabs_out += strip.counts().slabs_out;
    rows_flown += strip.counts().rows_flown;
  }
  report.travel = static_cast<double>(rows_flown);
  return report;
}

/// What lines meet first stands beside what they met last: as that was before the flights, for it may lie in a strip
/// that is done earlier.
void SnowFlights::find_upwind() {
  const WindFrame& frame = plan_.frame;
  upwind_.assign(static_cast<std::size_t>(frame.width), no_surface);
  if (plan_.boundary == Boundary::open) return;
  for (int line = 0; line < frame.width; ++line) {
    const int column = (draws_.offsets[0] + line) % frame.width;
    const std::size_t cell = frame.cell(column, frame.length - 1);
    upwind_[static_cast<std::size_t>(line)] = plan_.bedrock[cell] + plan_.mobile[cell];
  }
}

/// What comes to a cell before bedrock that stands too high over it stays there: hops end at it, and none leave it.
void SnowFlights::find_walls(Executor& executor) {
  const WindFrame& frame = plan_.frame;
  const bool open = plan_.boundary == Boundary::open;
  const int* const offsets = draws_.offsets.data() + 1;
  const auto column = [&](int row, int line) { return (offsets[row] + line) % frame.width; };
  executor.parallel_for(frame.width, [&](std::int64_t begin, std::int64_t end) {
    for (int line = static_cast<int>(begin); line < end; ++line) {
      for (int row = 0; row + (open ? 1 : 0) < frame.length; ++row) {
        const std::size_t here = frame.cell(column(row, line), row);
        const std::size_t next = frame.cell(column(row + 1, line), row + 1 < frame.length ? row + 1 : 0);
        if (plan_.bedrock[next] - (plan_.bedrock[here] + plan_.mobile[here]) <= plan_.law->wall) continue;
        if (open && column(row + 1, line) < column(row, line)) continue;
        plan_.chances[here] = 0;
        plan_.hops[here] = 0;
        plan_.over[here] = over_wall;
      }
    }
  });
}

/// Calls work(strip, number of its first line) for each strip of lines, on all threads.
void SnowFlights::for_strips(Executor& executor, const std::function<void(SnowStrip& strip, int first)>& work) {
  const int members = executor.threads();
  WorkQueue strips((plan_.frame.width + snow_lines - 1) / snow_lines, members);
  executor.parallel_for(members, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t member = begin; member < end; ++member) {
      strips.take_chunks(static_cast<int>(member), [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t k = first; k < last; ++k) {
          work(strips_[static_cast<std::size_t>(member)], static_cast<int>(k) * snow_lines);
        }
      });
    }
  });
}

void SnowFlights::begin(SnowStrip& strip, int first) const {
  strip.begin(plan_, first, std::min(snow_lines, plan_.frame.width - first));
}

/// All sub-sweeps of a strip. Lines that close on themselves bring down all that is in the air.
void SnowFlights::fly_strip(SnowStrip& strip, int first) {
  std::vector<SnowStrip::Carried> carried;
  for (std::size_t number = 0; sweep_number(number).polls || (lines_close() && !strip.carried().empty()); ++number) {
    if (lines_close()) {
      carried.clear();
      carried.swap(strip.carried());
      for (const SnowStrip::Carried& slabs : carried) {
        strip.receive(static_cast<int>(slabs.line) - first, slabs.row, slabs.load);
      }
    }
    strip.sweep(sweep_number(number));
  }
}

/// Where lines go on in other strips: pass after pass until nothing is in the air.
void SnowFlights::bring_down(Executor& executor) {
  for (auto number = static_cast<std::size_t>(plan_.sweeps); hand_over(); ++number) {
    for_strips(executor, [&](SnowStrip& strip, int first) {
      std::vector<SnowStrip::Carried>& slabs = handed_over_[static_cast<std::size_t>(first / snow_lines)];
      if (slabs.empty()) return;
      begin(strip, first);
      for (const SnowStrip::Carried& some : slabs) {
        strip.receive(static_cast<int>(some.line) - first, some.row, some.load);
      }
      slabs.clear();
      strip.sweep(sweep_number(number));
      strip.store();
    });
  }
}

/// Gives what left over the torus edge to the lines that go on there; false if there was nothing.
bool SnowFlights::hand_over() {
  bool any = false;
  const auto width = static_cast<std::uint64_t>(plan_.frame.width);
  handed_over_.resize(static_cast<std::size_t>((plan_.frame.width + snow_lines - 1) / snow_lines));
  for (SnowStrip& from : strips_) {
    for (SnowStrip::Carried slabs : from.carried()) {
      slabs.line = static_cast<std::uint32_t>((slabs.line + static_cast<std::uint64_t>(draws_.drift)) % width);
      handed_over_[slabs.line / snow_lines].push_back(slabs);
      any = true;
    }
    from.carried().clear();
  }
  return any;
}

}  // namespace erg
