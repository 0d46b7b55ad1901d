#include "kernels/shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/surface_range.h"
#include "core/units.h"
#include "forcing/wind_frame.h"
#include "kernels/line_walk.h"
#include "kernels/shadow_reach.h"

namespace erg::kernels {
namespace {

// Heights on the scan are fixed-point numbers with 24 bits after the point, so that a shadow line does not depend on
// how often it was lowered. The fall is rounded up: a cell exactly on the line counts as lit.
using Fixed = std::int64_t;
constexpr Fixed fixed_one = Fixed{1} << 24;
constexpr Fixed no_line = std::numeric_limits<Fixed>::min() / 4;

Fixed to_fixed(double value) { return static_cast<Fixed>(std::ceil(value * static_cast<double>(fixed_one))); }

// Rows before the grid from which a shadow can still reach into it, on a torus.
int warm_up_rows(const Terrain& terrain, const forcing::WindFrame& frame, double fall) {
  const SurfaceRange range = surface_range(terrain);
  const int longest = rows_around(frame.length, frame.tangent);
  return shadow_reach(static_cast<double>(range.high) - range.low, fall, frame.cosine, longest);
}

/// Calls visit(u, v) for every cell of the frame, square by square: rows of one lie along columns of the other, and
/// neither should be fetched anew for each cell.
template <typename Visit>
void for_squares(const forcing::WindFrame& frame, const Visit& visit) {
  constexpr int side = 16;
  for (int row = 0; row < frame.length; row += side) {
    for (int column = 0; column < frame.width; column += side) {
      for (int v = row; v < std::min(row + side, frame.length); ++v) {
        for (int u = column; u < std::min(column + side, frame.width); ++u) visit(u, v);
      }
    }
  }
}

Grid<std::int32_t> surface_in(const Terrain& terrain, const forcing::WindFrame& frame) {
  Grid<std::int32_t> surface({frame.width, frame.length});
  for_squares(frame, [&](int u, int v) {
    const std::size_t cell = frame.cell(u, v);
    surface(u, v) = terrain.bedrock()[cell] + terrain.mobile()[cell];
  });
  return surface;
}

}  // namespace

double shadow_fall(double angle, double cell_size, double quantum) {
  return std::tan(radians(angle)) * cell_size / quantum;
}

ShadowFalls shadow_falls(const forcing::WindFrame& frame, double fall) {
  const double row = fall / frame.cosine;
  if (frame.tangent <= 0) return {fall, 2 * fall, row};
  return {4 * row, fall, row};
}

Grid<std::uint8_t> shadow_map(const Terrain& terrain, double bearing, double fall) {
  if (terrain.extent().cells() == 0) return Grid<std::uint8_t>(terrain.extent());
  const forcing::WindFrame frame = forcing::wind_frame(terrain.extent(), bearing);
  const bool torus = terrain.boundary() == Boundary::torus;
  const ShadowFalls falls = shadow_falls(frame, fall);
  const Fixed row_fall = to_fixed(falls.row);
  const Fixed next_fall = to_fixed(falls.next);
  const Fixed second_fall = to_fixed(falls.second);
  const Grid<std::int32_t> surface = surface_in(terrain, frame);
  Grid<std::uint8_t> dark(surface.extent());
  const auto lines = static_cast<std::size_t>(frame.width);
  // Each line at the place of its column in the row.
  std::vector<Fixed> far(lines, no_line);     // shadow line of all that stands two rows upwind and farther
  std::vector<Fixed> next(lines, no_line);    // height of the next row upwind
  std::vector<Fixed> second(lines, no_line);  // and of the second
  const int start = torus ? -warm_up_rows(terrain, frame, fall) : 0;
  for (int row = start; row < frame.length; ++row) {
    if (row > start && line_offset(row, frame.tangent) != line_offset(row - 1, frame.tangent)) {
      for (std::vector<Fixed>* const heights : {&far, &next, &second}) {
        std::rotate(heights->begin(), heights->end() - 1, heights->end());
        // A line that enters over the side has nothing upwind.
        if (!torus) heights->front() = no_line;
      }
    }
    const int here = wrap(row, frame.length);
    const std::int32_t* const heights = surface.row(here).data();
    std::uint8_t* const shaded = dark.row(here).data();
    for (std::size_t column = 0; column < lines; ++column) {
      const Fixed height = Fixed{heights[column]} * fixed_one;
      const Fixed near = std::max(next[column] - next_fall, second[column] - second_fall);
      shaded[column] = height < std::max(far[column], near) ? 1 : 0;
      far[column] = std::max(next[column] - row_fall, far[column]) - row_fall;
      second[column] = next[column];
      next[column] = height;
    }
  }
  Grid<std::uint8_t> turned(terrain.extent());
  for_squares(frame, [&](int u, int v) { turned[frame.cell(u, v)] = dark(u, v); });
  return turned;
}

Field shadow_field(const Terrain& terrain, double bearing, double fall) {
  const Grid<std::uint8_t> dark = shadow_map(terrain, bearing, fall);
  Field field{{.key = "shadow",
               .label = "wind shadow",
               .unit = "",
               .minimum = 0,
               .maximum = 1,
               .palette = "grey",
               .meaning = "1 where the ground lies in the shadow of the last wind."},
              Grid<float>(dark.extent())};
  std::ranges::copy(dark.cells(), field.values.cells().begin());
  return field;
}

}  // namespace erg::kernels
