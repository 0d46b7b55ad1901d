// How a strip takes its lines' snow from the terrain and gives it back.
#include <algorithm>

#include "transport/snow_strip.h"

namespace erg {

/// Neighbours in the terrain from a place on, and where their cells stand in the strip (or on the way there).
SnowStretch SnowStrip::stretch(int row, int line, int count, SnowCell* cells, std::int16_t* heights) const {
  const std::size_t cell = plan_.frame.cell(column(row, line), row);
  return {.law = plan_.law,
          .count = count,
          .step = static_cast<int>(next_row_ == 1 ? plan_.frame.step_v : plan_.frame.step_u),
          .mobile = plan_.mobile + cell,
          .loose = plan_.loose + cell,
          .landed = plan_.landed + cell,
          .chances = plan_.chances + cell,
          .hops = plan_.hops + cell,
          .over = plan_.over + cell,
          .cells = cells,
          .heights = heights};
}

/// Gives all cells of the grid to a kernel that takes snow, or gives it back.
void SnowStrip::exchange(bool takes) {
  const auto kernel = takes ? plan_.kernels->take_snow : plan_.kernels->give_snow;
  const WindFrame& frame = plan_.frame;
  const auto straight = [&](int row, int line, int count) {
    const std::size_t here = at(row, line);
    if (count > 0) kernel(stretch(row, line, count, cells_.data() + here, over_.data() + here));
  };
  if (next_row_ != 1) {
    for (int row = 0; row < frame.length; ++row) {
      const int before_edge = std::clamp(frame.width - offset(row) - first_, 0, lines_);
      straight(row, 0, before_edge);
      straight(row, before_edge, lines_ - before_edge);
    }
  } else if (plan_.drift == 0) {
    for (int line = 0; line < lines_; ++line) straight(0, line, frame.length);
  } else {
    exchange_oblique(takes);
  }
}

/// Oblique lines cross the terrain's rows. Each of these passes through the lines of the strip, one after another.
void SnowStrip::exchange_oblique(bool takes) {
  const int length = plan_.frame.length;
  std::vector<int> drifted(static_cast<std::size_t>(length));  // columns since the first row
  for (int row = 1; row < length; ++row) {
    const auto here = static_cast<std::size_t>(row);
    drifted[here] = drifted[here - 1] + (offset(row) != offset(row - 1) ? 1 : 0);
  }
  std::vector<SnowCell> cells(static_cast<std::size_t>(length));
  std::vector<std::int16_t> heights(static_cast<std::size_t>(length));
  int from = 0;
  int to = 0;
  for (int first_line = 0; first_line < lines_ + drifted.back(); ++first_line) {
    const auto line = [&](int row) { return first_line - drifted[static_cast<std::size_t>(row)]; };
    while (to < length && line(to) >= 0) ++to;
    while (line(from) >= lines_) ++from;
    const SnowStretch all = stretch(from, line(from), to - from, cells.data(), heights.data());
    if (takes) plan_.kernels->take_snow(all);
    for (int row = from; row < to; ++row) {
      const std::size_t here = at(row, line(row));
      const auto there = static_cast<std::size_t>(row - from);
      if (takes) {
        cells_[here] = cells[there];
        over_[here] = heights[there];
      } else {
        cells[there] = cells_[here];
      }
    }
    if (!takes) plan_.kernels->give_snow(all);
  }
}

void SnowStrip::store() { exchange(false); }

}  // namespace erg
