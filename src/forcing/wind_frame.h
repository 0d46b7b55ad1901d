// The frame in which everything that follows the wind works: the grid turned and mirrored so that the wind blows along
// +v at 0 <= theta <= 45 degrees from the axis. Every rule is written once, for this case; a turned wind on a turned
// scene is the same run.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/grid.h"

namespace erg::forcing {

/// u runs across the wind, v along it. Cell (u, v) of the frame is cell `origin + u * step_u + v * step_v` of the
/// terrain.
struct WindFrame {
  int width = 0;   ///< cells across (u)
  int length = 0;  ///< cells along (v)
  std::ptrdiff_t origin = 0;
  std::ptrdiff_t step_u = 1;
  std::ptrdiff_t step_v = 1;
  double tangent = 0;  ///< tan(theta) in [0, 1]: cells across for one cell along
  double cosine = 1;   ///< cos(theta): a row of the frame is 1 / cosine cells long along the wind

  /// The cell of the grid, in row-major order.
  std::size_t cell(int u, int v) const { return static_cast<std::size_t>(origin + u * step_u + v * step_v); }
  /// Same orientation of the axes; the angle between them and the wind may differ.
  bool same_axes(const WindFrame& other) const {
    return width == other.width && length == other.length && origin == other.origin && step_u == other.step_u &&
           step_v == other.step_v;
  }
};

/// The frame for a wind that blows from `bearing` (degrees).
WindFrame wind_frame(Extent extent, double bearing);

}  // namespace erg::forcing
