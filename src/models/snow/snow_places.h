// Where a strip of lines keeps its cells in memory: the same in all strips of a step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "forcing/wind_frame.h"
#include "models/snow/snow_draws.h"

namespace erg {

/// Places of the cells of a strip: those of a row's line 0, and the step to the next line.
struct SnowLayout {
  std::vector<int> rows;
  int next_line = 1;
  int places = 0;  ///< in all

  std::size_t at(int row, int line) const {
    const int place = rows[static_cast<std::size_t>(row)] + line * next_line;
    return static_cast<std::size_t>(place);
  }
};

/// Cells that are neighbours in the terrain lie side by side in a strip, so that whole vectors of them are taken and
/// given back. Where the wind crosses the terrain's rows these are the lines of one row of the frame. Where it follows
/// them, they are rows of one line; stretches of all lines lie one after another, so that they fill few pages of
/// memory. Oblique lines change over from one row of the terrain to the next, and each of these has a place of its own.
struct SnowPlaces {
  bool along = true;         ///< neighbours are rows, not lines
  SnowLayout cells;          ///< rows of the grid
  SnowLayout heights;        ///< and as many beyond it as a hop may reach
  int next_row = 1;          ///< from a height to that of the same line in the next row, where lines do not drift
  std::vector<int> drifted;  ///< columns that lines have moved since row 0, for each row

  // As kernels read them; empty where lines do not drift or where neighbours are lines.
  std::vector<std::int16_t> near_drifted;
  std::vector<std::int16_t> least_drifted;  ///< the least that lines move in so many rows; at most 1 more

  /// For the lines that are drawn.
  void lay_out(const WindFrame& frame, const SnowDraws& draws);
};

}  // namespace erg
