// How a strip takes its lines' snow from the terrain and gives it back.
#include <algorithm>

#include "models/snow/snow_strip.h"

namespace erg {

/// Calls visit(row, line, count) for the cells of some rows, as many at a time as lie side by side in the terrain and
/// in the strip: lines of a row, or rows that follow each other in one row of the terrain. Rows may lie beyond the
/// grid.
template <typename Visit>
void SnowStrip::for_stretches(int begin, int end, const Visit& visit) const {
  if (!plan_.places->along) {
    for (int row = begin; row < end; ++row) {
      const int before_edge = std::clamp(plan_.frame.width - offset(row) - first_, 0, lines_);
      if (before_edge > 0) visit(row, 0, before_edge);
      if (before_edge < lines_) visit(row, before_edge, lines_ - before_edge);
    }
    return;
  }
  const int* const drifted = plan_.places->drifted.data();
  const int length = plan_.frame.length;
  int from = begin;
  int to = begin;
  for (int there = drifted[begin]; there < lines_ + drifted[end - 1]; ++there) {
    while (to < end && drifted[to] <= there) ++to;
    while (there - drifted[from] >= lines_) ++from;
    for (int row = from; row < to;) {
      const int edge = (row / length + 1) * length;
      const int count = std::min({to - row, edge - row, snow_stretch});
      visit(row, there - drifted[row], count);
      row += count;
    }
  }
}

int SnowStrip::column(int row, int line) const {
  const int column = offset(row) + first_ + line;
  return column < plan_.frame.width ? column : column - plan_.frame.width;
}

SnowAhead SnowStrip::ahead_of(int row, int line) const {
  const SnowPlaces& places = *plan_.places;
  SnowAhead ahead;
  ahead.heights = over_.data() + places.heights.at(row, line);
  ahead.next_row = places.next_row;
  ahead.reach = plan_.reach;
  if (!places.least_drifted.empty()) {
    ahead.drifted = places.near_drifted.data() + row;
    ahead.least_drifted = places.least_drifted.data();
    ahead.next_line = places.heights.next_line;
  }
  return ahead;
}

SnowStretch SnowStrip::stretch(int row, int line, int count) {
  const std::size_t cell = plan_.frame.cell(column(row, line), row);
  const std::size_t here = at(row, line);
  return {.law = plan_.law,
          .count = count,
          .step = static_cast<int>(plan_.places->along ? plan_.frame.step_v : plan_.frame.step_u),
          .mobile = plan_.mobile + cell,
          .loose = plan_.loose + cell,
          .landed = plan_.landed + cell,
          .chances = plan_.chances + cell,
          .hops = plan_.hops + cell,
          .ahead = ahead_of(row, line),
          .cells = cells_.data() + here,
          .powers = powers_.data() + here,
          .polled_chances = chances_.data() + here};
}

/// Heights up to before row `end`. Beyond an open edge nothing stands in the way.
void SnowStrip::take_heights(int end) {
  const int length = plan_.frame.length;
  const bool open = plan_.boundary == Boundary::open;
  const auto step = plan_.places->along ? plan_.frame.step_v : plan_.frame.step_u;
  if (end > rows_ahead_) {
    for_stretches(rows_ahead_, end, [&](int row, int line, int count) {
      std::int16_t* const heights = over_.data() + plan_.places->heights.at(row, line);
      if (open && row >= length) {
        std::fill(heights, heights + count, static_cast<std::int16_t>(-highest_over));
        return;
      }
      const std::int16_t* const from = plan_.over + plan_.frame.cell(column(row, line), row % length);
      if (step == 1) {
        std::copy(from, from + count, heights);
      } else {
        for (int i = 0; i < count; ++i) heights[i] = from[-i];
      }
    });
  }
  rows_ahead_ = std::max(rows_ahead_, end);
}

void SnowStrip::take_ground(int begin, int end) {
  const auto step = plan_.places->along ? plan_.frame.step_v : plan_.frame.step_u;
  for_stretches(begin, end, [&](int row, int line, int count) {
    const std::int32_t* const from = plan_.bedrock + plan_.frame.cell(column(row, line), row);
    std::int32_t* const ground = ground_.data() + at(row, line);
    for (int i = 0; i < count; ++i) ground[i] = from[i * step];
  });
}

/// Pieces of the terrain's rows that oblique lines cross are too short for the processor to see what comes next: asks
/// for that of a row further on.
void SnowStrip::ask_ahead(int row, int line, int count, bool takes) const {
  constexpr int rows_on = 3;
  const std::ptrdiff_t step = plan_.frame.step_v;
  const std::size_t cell =
      plan_.frame.cell(column(row, line), row) + static_cast<std::size_t>(rows_on * (plan_.frame.step_u + step));
  constexpr int at_once = static_cast<int>(cache_line / sizeof(std::int32_t));
  for (int i = 0; i < count + at_once; i += at_once) {
    const std::size_t there = cell + static_cast<std::size_t>(i * step);
    __builtin_prefetch(plan_.mobile + there);
    __builtin_prefetch(plan_.loose + there);
    if (takes) {
      __builtin_prefetch(plan_.chances + there);
      __builtin_prefetch(plan_.hops + there);
    } else {
      __builtin_prefetch(plan_.landed + there);
    }
  }
}

/// Takes the rows from the terrain that are not yet taken, up to before row `end`.
void SnowStrip::take_rows(int end) {
  take_heights(end + plan_.reach);
  if (plan_.relief) take_ground(rows_, end);
  for_stretches(rows_, end, [&](int row, int line, int count) { plan_.kernels->take_snow(stretch(row, line, count)); });
  rows_ = end;
}

void SnowStrip::store() {
  if (rows_ == 0) return;
  for_stretches(0, rows_, [&](int row, int line, int count) { plan_.kernels->give_snow(stretch(row, line, count)); });
}

}  // namespace erg
