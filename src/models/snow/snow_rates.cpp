// The transport rates of SnowOnProcessor: shadow, smoothed surface and wind over it, and from them what a step's
// flights need to know of each cell.
#include <algorithm>
#include <vector>

#include "kernels/box_mean.h"
#include "models/snow/on_processor.h"

namespace erg::models {

using kernels::BoxMeans;

namespace {

constexpr int lines_at_once = 16;               // that are followed for shadow together
constexpr std::int32_t no_shadow = -(1 << 24);  // lower than any surface, fixed point

}  // namespace

void SnowOnProcessor::find_shadow(double shadow_fall) {
  const SnowShadow shadow =
      snow_shadow(shadow_fall, frame_.tangent, frame_.cosine, !planes_.torus, frame_.length, relief_);
  executor_->parallel_for(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t line = begin; line < end; line += lines_at_once) {
      shade_lines(shadow, static_cast<int>(line), static_cast<int>(std::min<std::int64_t>(end - line, lines_at_once)));
    }
  });
}

/// Follows lines down the wind with the shadow line of all that they have passed, and that of the cell before.
void SnowOnProcessor::shade_lines(const SnowShadow& shadow, int first, int lines) {
  const auto bounded = [](std::int64_t fall) {  // one that is longer than any snow is high shades nothing
    return static_cast<std::int32_t>(std::min<std::int64_t>(fall, -no_shadow));
  };
  const std::int32_t fall_far = bounded(shadow.fall_far);
  const std::int32_t fall_near = bounded(shadow.fall_near);
  std::int32_t far[lines_at_once];
  std::int32_t near[lines_at_once];
  std::fill(std::begin(far), std::end(far), no_shadow);
  std::fill(std::begin(near), std::end(near), no_shadow);
  for (int row = shadow.start; row < frame_.length; ++row) {
    int column = wrap(static_cast<int>(first + shadow.sideways(row)), frame_.width);
    std::size_t cell = frame_.cell(column, row < 0 ? wrap(row, frame_.length) : row);
    for (int line = 0; line < lines; ++line) {
      if (column == 0 && !planes_.torus) far[line] = near[line] = no_shadow;  // it enters over the side, or begins here
      const std::int32_t height = std::int32_t{planes_.height[cell]} << kernels::fixed_point_bits;
      if (row >= 0) planes_.dark[cell] = height < std::max(far[line], near[line]) ? 1 : 0;
      far[line] = std::max(height, far[line]) - fall_far;
      near[line] = height - fall_near;
      if (++column == frame_.width) column = 0, cell -= static_cast<std::size_t>(frame_.width * frame_.step_u);
      cell += static_cast<std::size_t>(frame_.step_u);
    }
  }
}

void SnowOnProcessor::find_rates(SnowRadii radii) {
  longest_mean_hop_ = 0;
  executor_->parallel_for(planes_.ny, [&](std::int64_t begin, std::int64_t end) {
    const std::uint32_t longest = find_rates_of(static_cast<int>(begin), static_cast<int>(end), radii);
    const std::lock_guard lock(mutex_);
    longest_mean_hop_ = std::max(longest_mean_hop_, longest);
  });
}

/// The rates of some rows of the terrain; returns the longest mean hop. The smoothed surface is made row by row beside
/// it, so that it need not go through memory.
std::uint32_t SnowOnProcessor::find_rates_of(int begin, int end, SnowRadii radii) {
  const bool torus = planes_.torus;
  const auto width = static_cast<std::size_t>(planes_.nx);
  const kernels::BoxGrid grid{
      {planes_.nx, planes_.ny}, torus ? Boundary::torus : Boundary::open, planes_.height, &kernels_.boxes};
  const int first = torus ? begin - 1 : std::max(begin - 1, 0);
  const int last = torus ? end : std::min(end, planes_.ny - 1);
  BoxMeans smoothed(grid, radii.smooth, true, first);
  BoxMeans surroundings(grid, radii.around, false, begin);
  std::vector<float> rows[3];  // of the smoothed surface, with a place more on either side
  for (std::vector<float>& row : rows) row.resize(width + 2);
  std::vector<float> around(width);
  const auto level = [&](int y) -> std::vector<float>& { return rows[(y - first) % 3]; };
  int made = first;
  std::uint32_t longest = 0;
  for (int y = begin; y < end; ++y) {
    for (; made <= std::min(y + 1, last); ++made) {
      std::vector<float>& row = level(made);
      smoothed.next(row.data() + 1);
      row[0] = torus ? row[width] : row[1];
      row[width + 1] = torus ? row[1] : row[width];
    }
    surroundings.next(around.data());
    const SnowLevels levels{level(y).data() + 1, level(std::max(y - 1, first)).data() + 1,
                            level(std::min(y + 1, last)).data() + 1, around.data()};
    longest = std::max(longest, kernels_.rates(planes_, y, levels));
  }
  return longest;
}

}  // namespace erg::models
