#include "models/slab/plane_layout.h"

#include <algorithm>

#include "forcing/wind_frame.h"

namespace erg::models {

PlaneLayout plane_layout(const forcing::WindFrame& frame, bool open) {
  const int width = frame.width;
  const int length = frame.length;
  const auto whole_lines = [](int columns) { return (columns + 63) / 64 * 64; };
  PlaneLayout layout;
  layout.width = width;
  layout.length = length;
  const int wanted = width < 256 ? 1 : std::max(2, width / 512);
  layout.block_columns = whole_lines((width + wanted - 1) / wanted);
  // A few columns left over go to the last block: the borders on both sides of a block must not meet in it.
  constexpr int narrowest = 64;
  layout.blocks = std::max(1, (width + layout.block_columns - narrowest) / layout.block_columns);
  const int widest = std::max(layout.block_columns, whole_lines(layout.columns_of(layout.blocks - 1)));
  // Never a power of two, or the rows of a block would crowd into a few sets of the processor's caches.
  layout.pitch = widest + 64;
  if (layout.blocks > 1 && !open) layout.skew = static_cast<std::int64_t>(frame.tangent * 0x1p24);
  layout.block_size = static_cast<std::size_t>(layout.pitch) * static_cast<std::size_t>(length);
  return layout;
}

}  // namespace erg::models
