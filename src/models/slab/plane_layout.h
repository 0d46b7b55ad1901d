// How a plane of the grid is cut into blocks, whose parts slide by themselves. That is a part of the rules: it depends
// on the grid and the wind alone, and every executor that sweeps keeps to it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/cell_rule.h"
#include "forcing/wind_frame.h"

namespace erg::models {

/// Rows of a tile: slides inside tiles come first, then the borders between them.
inline constexpr int tile_rows = 32;

/// How a plane of the grid lies in memory: cut into blocks of columns, each whole and one after another, so that
/// threads which work on different columns touch different memory (and what their prefetchers read ahead is their own).
///
/// The planes of an oblique wind are *skewed*: column u of row v stands in *place* u - shift(v), round the torus, so
/// that lines, which drift sideways with the wind, stay in a block from the first row to the last (but for a few
/// places: most_lead in sweep.h).
struct PlaneLayout {
  int width = 0;
  int length = 0;
  int block_columns = 0;  ///< columns of a block; the last may have fewer
  int blocks = 0;
  int pitch = 0;               ///< lanes from one row of a block to the next
  std::size_t block_size = 0;  ///< lanes of a whole block
  std::int64_t skew = 0;       ///< columns of skew for one row, times 2^24; 0: place and column are the same

  /// Where a block's column of a row lies in memory.
  ERG_CELL_RULE std::size_t at(int block, int column_in_block, int row) const {
    return static_cast<std::size_t>(block) * block_size +
           static_cast<std::size_t>(row) * static_cast<std::size_t>(pitch) + static_cast<std::size_t>(column_in_block);
  }
  ERG_CELL_RULE int columns_of(int block) const {
    return block + 1 < blocks ? block_columns : width - block * block_columns;
  }
  /// The block of a place.
  ERG_CELL_RULE int block_of(int place) const {
    const int block = place / block_columns;
    return block < blocks ? block : blocks - 1;
  }
  /// Columns by which a row is shifted, at most those by which a line has drifted there.
  ERG_CELL_RULE int shift(int row) const { return static_cast<int>((row * skew) >> 24) - (skew != 0 ? 1 : 0); }
  /// The same of a place.
  ERG_CELL_RULE std::size_t at_place(int place, int row) const {
    const int block = block_of(place);
    return at(block, place - block * block_columns, row);
  }
  /// A number of columns or places, round the torus.
  ERG_CELL_RULE int wrapped(int column) const {
    const int rest = column % width;
    return rest < 0 ? rest + width : rest;
  }
};

/// Cuts the frame's planes into blocks of about 512 columns, two at least from 256 columns on. Open edges and planes of
/// one block stay unskewed.
PlaneLayout plane_layout(const forcing::WindFrame& frame, bool open);

}  // namespace erg::models
