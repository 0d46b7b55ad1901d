#include "transport/snow_flights.h"

#include <algorithm>
#include <bit>

namespace erg {

StepReport SnowFlights::fly(SnowFlightPlan plan, InstructionSet instructions, Executor& executor) {
  plan_ = plan;
  plan_.kernels = &snow_kernels(instructions);
  draws_.draw_sweeps(plan_.key, plan_.sweeps);
  draws_.draw_lines(plan_.frame, plan_.key, plan_.longest_mean_hop);
  plan_.drift = draws_.drift;
  plan_.reach = draws_.reach;
  plan_.offsets = draws_.offsets.data();
  plan_.windows =
      static_cast<int>(std::bit_ceil(static_cast<unsigned>((plan_.reach + snow_window - 1) / snow_window + 1)));
  const int width = plan_.frame.width;
  strips_.resize(static_cast<std::size_t>((width + snow_lines - 1) / snow_lines));
  const auto count = static_cast<std::int64_t>(strips_.size());
  executor.for_pieces(count, [&](std::int64_t begin, std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      // One strip's memory serves all strips of a thread where it can: it stays in its processor's cache.
      if (lines_close())
        strips_[k].swap_memory(
            strips_[static_cast<std::size_t>(k > static_cast<std::size_t>(begin) ? k - 1 : end - 1)]);
      const int first = static_cast<int>(k) * snow_lines;
      strips_[k].load(plan_, first, std::min(snow_lines, width - first));
      fly_strip(strips_[k]);
      if (lines_close()) strips_[k].store();
    }
  });
  if (!lines_close()) {
    bring_down(executor);
    executor.for_pieces(count, [&](std::int64_t begin, std::int64_t end) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) strips_[k].store();
    });
  }
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

/// All sub-sweeps of a strip. Lines that close on themselves bring down all that is in the air.
void SnowFlights::fly_strip(SnowStrip& strip) {
  const int first = static_cast<int>(&strip - strips_.data()) * snow_lines;
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
    executor.for_pieces(static_cast<std::int64_t>(strips_.size()), [&](std::int64_t begin, std::int64_t end) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
        strips_[k].sweep(sweep_number(number));
      }
    });
  }
}

/// Gives what left over the torus edge to the lines that go on there; false if there was nothing.
bool SnowFlights::hand_over() {
  bool any = false;
  const auto width = static_cast<std::uint64_t>(plan_.frame.width);
  for (SnowStrip& from : strips_) {
    for (const SnowStrip::Carried& slabs : from.carried()) {
      const auto line = static_cast<int>((slabs.line + static_cast<std::uint64_t>(plan_.drift)) % width);
      strips_[static_cast<std::size_t>(line / snow_lines)].receive(line % snow_lines, slabs.row, slabs.load);
      any = true;
    }
    from.carried().clear();
  }
  return any;
}

}  // namespace erg
