// The flights of SnowOnProcessor in sub-sweeps, on all threads.
//
// Each sub-sweep polls a random 1/K of the cells and follows the lines down the wind once: slabs lift, come down, free
// bonded snow, stay or fly on. What flies over the torus edge goes on in the next sub-sweep, or, where an oblique line
// goes on as another one there, after the last; then passes without polls bring all of it down. So nothing in one line
// waits for another: a thread takes a strip of lines through all sub-sweeps.
#include <algorithm>
#include <bit>
#include <utility>

#include "models/snow/on_processor.h"

namespace erg::models {

void SnowOnProcessor::fly_in_sweeps() {
  planes_.sweeps = executor_->sub_sweeps();
  random_.draw_sweeps(key_, planes_.sweeps);
  random_.draw_lines(frame_, key_, longest_mean_hop_);
  planes_.draws = random_.sweeps.data();
  planes_.reach = random_.reach;
  planes_.offsets = random_.offsets.data();
  planes_.closes = random_.lines_close(frame_, planes_.torus ? Boundary::torus : Boundary::open);
  planes_.drift = static_cast<int>(random_.drift % frame_.width);
  if (planes_.relief) find_walls();
  lay_out_ahead();
  for_rows([this](int y) { kernels_.runs(planes_, y); });
  make_strips();
  for_strips([this](SnowStrip& strip) {  // lines that close on themselves bring down all that is in the air
    kernels_.poll(planes_, strip);
    for (int number = 0; number < planes_.sweeps || strip.anything_aloft(); ++number) {
      kernels_.fly(planes_, static_cast<int>(random_.sweep_number(static_cast<std::size_t>(number))), strip);
    }
  });
  if (!planes_.closes) bring_down();
  for_rows([this](int y) { kernels_.scatter(planes_, y); });
  std::int64_t rows_flown = 0;
  for (const SnowStrip& strip : strips_) {
    report_.lifts += strip.lifts;
    report_.slabs_in += strip.slabs_in;
    report_.slabs_out += strip.slabs_out;
    rows_flown += strip.rows_flown;
  }
  report_.travel = static_cast<double>(rows_flown);
}

/// What comes to a cell before bedrock that stands too high over it stays there: hops end at it, and none leave it.
void SnowOnProcessor::find_walls() {
  const SnowPlanes& planes = planes_;
  executor_->parallel_for(frame_.width, [&planes](std::int64_t begin, std::int64_t end) {
    for (int line = static_cast<int>(begin); line < end; ++line) {
      for (int row = 0; row + (planes.torus ? 0 : 1) < planes.length; ++row) {
        const std::int32_t here = planes.place_of_line(line, row);
        const std::int32_t on = planes.place_of_line(line, row + 1);
        const std::int32_t next = row + 1 < planes.length ? on : on - planes.length * planes.step_v;
        const std::int32_t surface = planes.bedrock[planes.cell_at(here)] + planes.mobile[planes.cell_at(here)];
        if (planes.bedrock[planes.cell_at(next)] - surface <= planes.law->wall) continue;
        const bool leaves =
            planes.offsets[row + 1] + line == planes.width - 1 && planes.offsets[row + 2] != planes.offsets[row + 1];
        if (!planes.torus && leaves) continue;
        planes.cells[here].way = 0;
        planes.chances[here] = 0;
        planes.powers[here] = 0;
        planes.over[here] = over_wall;
      }
    }
  });
}

/// Lays heights out so that what lies ahead of all cells of a row is found in a row: rows go on beyond their ends as
/// the torus does; beyond an open edge nothing stands in the way. Which lines move by a place more than others in as
/// many rows hangs on the row alone.
void SnowOnProcessor::lay_out_ahead() {
  constexpr int beyond = 128;  // that kernels may read over the end of a row
  SnowPlanes& planes = planes_;
  const int reach = planes.reach;
  const bool goes_on = planes.torus || !planes.along_x;
  planes.ahead_pitch = planes.nx + 2 * reach;
  ahead_.resize(static_cast<std::size_t>(planes.ahead_pitch) * static_cast<std::size_t>(planes.ny) + beyond);
  planes.ahead = ahead_.data() + reach;
  for_rows([&](int y) {
    const std::int16_t* const over = planes.over + planes.place(0, y);
    std::int16_t* const row = ahead_.data() + reach + static_cast<std::ptrdiff_t>(y) * planes.ahead_pitch;
    std::copy(over, over + planes.nx, row);
    for (int k = 0; k < reach; ++k) {
      row[planes.nx + k] = goes_on ? row[k] : static_cast<std::int16_t>(-highest_over);
      row[-1 - k] = goes_on ? row[planes.nx - 1 - k] : static_cast<std::int16_t>(-highest_over);
    }
  });
  if (!planes.along_x || random_.drift == 0) return;
  const auto count = static_cast<std::size_t>(reach + 1);
  least_moved_.resize(count);
  moved_.assign(count * static_cast<std::size_t>(planes.pitch) + beyond, 0);
  for (int rows = 1; rows <= reach; ++rows) {
    const int least = static_cast<int>(rows * random_.drift / frame_.length) % frame_.width;
    least_moved_[static_cast<std::size_t>(rows)] = least;
    for (int row = 0; row < frame_.length; ++row) {
      const int moved = wrap(planes.offsets[row + rows + 1] - planes.offsets[row + 1] - least, frame_.width);
      moved_[planes.place(planes.step_v > 0 ? row : frame_.length - 1 - row, rows)] = static_cast<std::int16_t>(-moved);
    }
  }
  planes.least_moved = least_moved_.data();
  planes.moved = moved_.data();
}

/// Shares the lines out in strips, with nothing in the air.
void SnowOnProcessor::make_strips() {
  // A block's slabs lift together, those of its last row as early as those of its first.
  const std::size_t rows = std::bit_ceil(static_cast<std::size_t>(planes_.reach + planes_.sweeps));
  const std::size_t loads = rows * static_cast<std::size_t>(frame_.width);
  aloft_.assign(loads, 0);
  handed_over_.assign(planes_.closes ? 0 : loads, 0);
  planes_.handed_over = handed_over_.data();
  const int turns =
      (frame_.width + snow_strip_lines * executor_->threads() - 1) / (snow_strip_lines * executor_->threads());
  const int shares = turns * executor_->threads();
  const int lines = ((frame_.width + shares - 1) / shares + 15) / 16 * 16;
  const auto count = static_cast<std::size_t>((frame_.width + lines - 1) / lines);
  const auto polls = static_cast<std::size_t>(frame_.length + planes_.sweeps);
  lists_.assign(count * (rows + polls) * snow_strip_list, 0);
  counts_.assign(count * (rows + polls), 0);
  strips_.assign(count, {});
  for (std::size_t k = 0; k < count; ++k) {
    SnowStrip& strip = strips_[k];
    strip.first = static_cast<int>(k) * lines;
    strip.lines = std::min(lines, frame_.width - strip.first);
    strip.loads = aloft_.data() + strip.first;
    strip.width = frame_.width;
    strip.ring_mask = static_cast<std::uint32_t>(rows - 1);
    strip.lists = lists_.data() + k * (rows + polls) * snow_strip_list;
    strip.counts = counts_.data() + k * (rows + polls);
    strip.polls = strip.lists + rows * snow_strip_list;
    strip.poll_counts = strip.counts + rows;
  }
}

/// Calls work(strip) for each strip, on all threads.
void SnowOnProcessor::for_strips(const std::function<void(SnowStrip& strip)>& work) {
  executor_->parallel_for(static_cast<std::int64_t>(strips_.size()), [&](std::int64_t begin, std::int64_t end) {
    std::for_each(strips_.begin() + begin, strips_.begin() + end, work);
  });
}

/// Where lines go on as others: pass after pass until nothing is in the air.
void SnowOnProcessor::bring_down() {
  const auto hands_over = [](const SnowStrip& strip) { return strip.hands_over; };
  for (auto number = static_cast<std::size_t>(planes_.sweeps); std::ranges::any_of(strips_, hands_over); ++number) {
    std::swap(aloft_, handed_over_);  // the first is empty by now
    planes_.handed_over = handed_over_.data();
    for_strips([&](SnowStrip& strip) {
      strip.ring_first = 0;
      strip.hands_over = false;
      strip.loads = aloft_.data() + strip.first;
      for (int row = 0; row <= static_cast<int>(strip.ring_mask); ++row) {
        for (int line = 0; line < strip.lines; ++line) {
          if (strip.load(row, line) != 0) strip.put(row, line, std::exchange(strip.load(row, line), 0));
        }
      }
      kernels_.fly(planes_, static_cast<int>(random_.sweep_number(number)), strip);
    });
  }
}

}  // namespace erg::models
