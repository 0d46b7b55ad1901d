// The weather of SnowMachine: shadow, smoothed surface and wind over it, and from them what a step's flights need to
// know of each cell.
#include <algorithm>
#include <memory>
#include <vector>

#include "models/snow/box_mean.h"
#include "models/snow/snow_machine.h"

namespace erg {
namespace {

constexpr int rows_at_once = 64;                // that are followed for shadow together
constexpr std::int32_t no_shadow = -(1 << 24);  // lower than any surface, fixed point

/// Cells that lie side by side in the terrain go through the rows of a tile, from line to line as these drift.
void take_crosswise(const std::uint16_t* __restrict from, std::ptrdiff_t step, int count, const int* __restrict drifted,
                    std::uint16_t* __restrict tile) {
  for (int i = 0; i < count; ++i) tile[i * snow_lines + drifted[0] - drifted[i]] = from[i * step];
}
void give_crosswise(const std::uint8_t* __restrict tile, const int* __restrict drifted, int count,
                    std::uint8_t* __restrict to, std::ptrdiff_t step) {
  for (int i = 0; i < count; ++i) to[i * step] = tile[i * snow_lines + drifted[0] - drifted[i]];
}

}  // namespace

/// Rows of lines side by side.
struct SnowMachine::ShadowTile {
  int first_u = 0;            ///< column of the first line in the first row
  int drifted[rows_at_once];  ///< columns since then
  std::uint16_t height[rows_at_once][snow_lines];
  std::uint8_t dark[rows_at_once][snow_lines];
};

void SnowMachine::measure_weather(double shadow_fall) {
  const std::size_t cells = extent_.cells();
  dark_.resize(cells);
  find_shadow(shadow_fall);
  chances_.resize(cells);
  hops_.resize(cells);
  over_.resize(cells);
  longest_mean_hop_ = 0;
  executor_->parallel_for(extent_.ny, [&](std::int64_t begin, std::int64_t end) {
    const std::uint32_t longest = make_weather(static_cast<int>(begin), static_cast<int>(end));
    const std::lock_guard lock(mutex_);
    longest_mean_hop_ = std::max(longest_mean_hop_, longest);
  });
}

/// What the weather of a row is made from, but for the smoothed surface.
SnowWeatherRow SnowMachine::weather_row(int y) const {
  const SnowSlopes slopes = snow_slopes(*law_, frame_.tangent, frame_.cosine);
  const double along = slopes.along * (frame_.step_v > 0 ? 1 : -1);
  const double across = slopes.across * (frame_.step_u > 0 ? 1 : -1);
  const std::size_t here = static_cast<std::size_t>(y) * static_cast<std::size_t>(extent_.nx);
  SnowWeatherRow row;
  row.count = extent_.nx;
  row.slope_by_x = static_cast<float>(along_x() ? along : across);
  row.slope_by_y = static_cast<float>(along_x() ? across : along);
  row.rows = static_cast<float>(frame_.cosine);
  row.landed = layers_->landed.data() + here;
  row.age = layers_->age.data() + here;
  row.surface = height_.data() + here;
  row.dark = dark_.data() + here;
  return row;
}

/// The weather of some rows of the terrain; returns the longest mean hop. The smoothed surface is made row by row
/// beside it, so that it need not go through memory.
std::uint32_t SnowMachine::make_weather(int begin, int end) {
  const bool torus = boundary_ == Boundary::torus;
  const int nx = extent_.nx;
  const auto width = static_cast<std::size_t>(nx);
  const BoxGrid grid{extent_, boundary_, height_.data(), static_cast<std::uint16_t>(high_ - low_),
                     &snow_kernels(instructions_)};
  const int first = torus ? begin - 1 : std::max(begin - 1, 0);
  const int last = torus ? end : std::min(end, extent_.ny - 1);
  const std::unique_ptr<BoxMeans> levels = box_means(grid, radii_.smooth, true, first);
  const std::unique_ptr<BoxMeans> surroundings = box_means(grid, radii_.around, false, begin);
  std::vector<float> rows[3];  // of the smoothed surface, with a place more on either side
  for (std::vector<float>& row : rows) row.resize(width + 2);
  std::vector<float> around(width);
  const auto level = [&](int y) -> std::vector<float>& { return rows[(y - first) % 3]; };
  int made = first;
  std::uint32_t longest = 0;
  for (int y = begin; y < end; ++y) {
    for (; made <= std::min(y + 1, last); ++made) {
      std::vector<float>& row = level(made);
      levels->next(row.data() + 1);
      row[0] = torus ? row[width] : row[1];
      row[width + 1] = torus ? row[1] : row[width];
    }
    surroundings->next(around.data());
    SnowWeatherRow row = weather_row(y);
    row.level = level(y).data() + 1;
    row.south = level(std::max(y - 1, first)).data() + 1;
    row.north = level(std::min(y + 1, last)).data() + 1;
    row.around = around.data();
    const std::size_t here = static_cast<std::size_t>(y) * width;
    row.chances = chances_.data() + here;
    row.hops = hops_.data() + here;
    row.over = over_.data() + here;
    longest = std::max(longest, grid.kernels->weather(*law_, row));
  }
  return longest;
}

void SnowMachine::find_shadow(double shadow_fall) {
  executor_->parallel_for(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t line = begin; line < end; line += snow_lines) {
      shade_lines(static_cast<int>(line), static_cast<int>(std::min<std::int64_t>(end - line, snow_lines)),
                  shadow_fall);
    }
  });
}

/// Follows lines down the wind with the shadow line of all that they have passed, and that of the cell before. Some
/// rows at a time are taken from the terrain with their lines side by side.
void SnowMachine::shade_lines(int first, int lines, double shadow_fall) {
  const bool open = boundary_ == Boundary::open;
  const SnowKernels& kernels = snow_kernels(instructions_);
  const SnowShadow shadow = snow_shadow(shadow_fall, frame_.tangent, frame_.cosine, open, frame_.length, high_ - low_);
  const auto bounded = [](std::int64_t fall) {  // one that is longer than any snow is high shades nothing
    return static_cast<std::int32_t>(std::min<std::int64_t>(fall, -no_shadow));
  };
  std::int32_t far[snow_lines];
  std::int32_t near[snow_lines];
  std::fill(std::begin(far), std::end(far), no_shadow);
  std::fill(std::begin(near), std::end(near), no_shadow);
  ShadowTile tile;
  int end = 0;
  for (int begin = shadow.start; begin < frame_.length; begin = end) {
    end = std::min({begin + rows_at_once, begin < 0 ? 0 : frame_.length, frame_.length});
    tile.first_u = wrap(static_cast<int>(first + shadow.sideways(begin)), frame_.width);
    for (int row = begin; row < end; ++row)
      tile.drifted[row - begin] = static_cast<int>(shadow.sideways(row) - shadow.sideways(begin));
    for_tile(begin, end, lines, tile, [&](int k, int line, std::size_t cell, std::ptrdiff_t step, int count) {
      const std::uint16_t* from = height_.data() + cell;
      if (along_x()) {
        take_crosswise(from, step, count, tile.drifted + k, tile.height[k] + line);
      } else {
        for (int i = 0; i < count; ++i) tile.height[k][line + i] = from[i * step];
      }
    });
    for (int k = 0; k < end - begin; ++k) {
      const int column = (tile.first_u + tile.drifted[k]) % frame_.width;
      if (const int entering = column == 0 ? 0 : frame_.width - column; open && entering < lines) {
        far[entering] = near[entering] = no_shadow;  // it enters over the side, or begins here
      }
      kernels.shade(
          {lines, bounded(shadow.fall_far), bounded(shadow.fall_near), tile.height[k], far, near, tile.dark[k]});
    }
    if (begin < 0) continue;
    for_tile(begin, end, lines, tile, [&](int k, int line, std::size_t cell, std::ptrdiff_t step, int count) {
      std::uint8_t* to = dark_.data() + cell;
      if (along_x()) {
        give_crosswise(tile.dark[k] + line, tile.drifted + k, count, to, step);
      } else {
        for (int i = 0; i < count; ++i) to[i * step] = tile.dark[k][line + i];
      }
    });
  }
}

/// Calls visit(row of the tile, line there, cell of the terrain, step, count) for each piece of cells that lie in the
/// terrain one beside another: lines of a row, or what lines that drift have of a row of the terrain.
template <typename Visit>
void SnowMachine::for_tile(int begin, int end, int lines, const ShadowTile& tile, const Visit& visit) const {
  const auto piece = [&](int k, int line, std::ptrdiff_t step, int count) {
    const int u = (tile.first_u + tile.drifted[k] + line) % frame_.width;
    if (count > 0) visit(k, line, frame_.cell(u, wrap(begin + k, frame_.length)), step, count);
  };
  const int rows = end - begin;
  if (!along_x()) {
    for (int k = 0; k < rows; ++k) {
      const int before_edge = std::min(lines, frame_.width - (tile.first_u + tile.drifted[k]) % frame_.width);
      piece(k, 0, frame_.step_u, before_edge);
      piece(k, before_edge, frame_.step_u, lines - before_edge);
    }
    return;
  }
  int from = 0;
  int to = 0;
  for (int first_line = 0; first_line < lines + tile.drifted[rows - 1]; ++first_line) {
    while (to < rows && first_line >= tile.drifted[to]) ++to;
    while (first_line - tile.drifted[from] >= lines) ++from;
    for (int k = from; k < to;) {  // in pieces between torus edges
      const int next = std::min(to, k + frame_.length - wrap(begin + k, frame_.length));
      piece(k, first_line - tile.drifted[k], frame_.step_v, next - k);
      k = next;
    }
  }
}

}  // namespace erg
