// A part of the grid as it is drawn: cells of the terrain, or means of blocks of them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.h"
#include "core/terrain.h"

namespace erg::render {

/// Stands in textures for a value that is not a number; the shaders know it too.
inline constexpr float missing_value = -1e38f;

/// Which cells. The window may reach over the edges: a torus goes on there, otherwise the outermost cells do.
struct BlockWindow {
  int left = 0;   ///< column of its south-west cell
  int low = 0;    ///< row of its south-west cell
  Extent blocks;  ///< what is drawn, columns and rows
  int block = 1;  ///< cells a side of a block

  bool operator==(const BlockWindow&) const = default;
};

/// The window over a whole grid in blocks so large that no side has more than `largest` of them.
BlockWindow whole_window(Extent extent, int largest);

/// Surface and thickness of the mobile layer (m) of each block, row by row from the south, interleaved.
void read_terrain(const Terrain& terrain, const BlockWindow& window, std::vector<float>& values);

/// A field's value for each block, `missing_value` where a cell has none. Returns how many blocks have none.
std::int64_t read_values(const Grid<float>& field, bool periodic, const BlockWindow& window,
                         std::vector<float>& values);

}  // namespace erg::render
