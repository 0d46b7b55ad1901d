#include "models/snow/snow_places.h"

#include <algorithm>

#include "models/snow/snow_sweep.h"

namespace erg {
namespace {

/// Rows of a line lie side by side; each row of the terrain has `side` places.
void follow(const std::vector<int>& drifted, int rows, int side, SnowLayout& layout) {
  layout.rows.resize(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const auto here = static_cast<std::size_t>(row);
    layout.rows[here] = row + drifted[here] * side;
  }
  layout.next_line = side;
  layout.places = layout.rows.back() + snow_lines * side;
}

/// The same for lines that do not drift, in stretches.
void follow_in_stretches(int rows, SnowLayout& layout) {
  constexpr int side = snow_stretch + 8;  // or lines would compete for one place in a cache
  layout.rows.resize(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    layout.rows[static_cast<std::size_t>(row)] = row / snow_stretch * side * snow_lines + row % snow_stretch;
  }
  layout.next_line = side;
  layout.places = layout.rows.back() + snow_lines * side;
}

/// The lines of a row lie side by side.
void cross(int rows, SnowLayout& layout) {
  layout.rows.resize(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) layout.rows[static_cast<std::size_t>(row)] = row * snow_lines;
  layout.next_line = 1;
  layout.places = rows * snow_lines;
}

}  // namespace

void SnowPlaces::lay_out(const WindFrame& frame, const SnowDraws& draws) {
  const int length = frame.length;
  const int rows = (length + snow_stretch - 1) / snow_stretch * snow_stretch;  // kernels look at whole stretches
  const int rows_ahead = rows + draws.reach + snow_stretch;
  along = frame.step_v == 1 || frame.step_v == -1;
  drifted.assign(static_cast<std::size_t>(rows_ahead), 0);
  for (int row = 1; row < rows_ahead; ++row) {
    const auto here = static_cast<std::size_t>(row);
    const bool moves = row <= length + draws.reach && draws.offsets[here + 1] != draws.offsets[here];
    drifted[here] = drifted[here - 1] + (moves ? 1 : 0);
  }
  near_drifted.clear();
  least_drifted.clear();
  next_row = along ? 1 : snow_lines;
  if (!along) {
    cross(rows, cells);
    cross(rows_ahead, heights);
  } else if (drifted.back() == 0) {
    follow_in_stretches(rows, cells);
    follow(drifted, rows_ahead, (rows_ahead + 127) / 128 * 128 + 36, heights);
  } else {
    // A row of the terrain meets the lines of a strip one after another: in no more rows than these.
    const std::int64_t meeting = snow_lines * std::int64_t{length} / draws.drift + 2;
    const int side = static_cast<int>(std::min<std::int64_t>(meeting, rows_ahead));
    follow(drifted, rows, side, cells);
    follow(drifted, rows_ahead, side, heights);
    near_drifted.assign(drifted.begin(), drifted.end());
    for (int row = 0; row <= draws.reach; ++row) {
      least_drifted.push_back(static_cast<std::int16_t>(row * draws.drift / length));
    }
  }
}

}  // namespace erg
