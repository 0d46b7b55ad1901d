#include "forcing/shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/surface_range.h"
#include "core/units.h"
#include "forcing/shadow_reach.h"
#include "forcing/wind_frame.h"

namespace erg::forcing {
namespace {

// Heights on the scan are fixed-point numbers with 24 bits after the point, so that a shadow line does not depend on
// how often it was lowered. The fall is rounded up: a cell exactly on the line counts as lit.
using Fixed = std::int64_t;
constexpr Fixed fixed_one = Fixed{1} << 24;
constexpr Fixed no_line = std::numeric_limits<Fixed>::min() / 4;

Fixed to_fixed(double value) { return static_cast<Fixed>(std::ceil(value * static_cast<double>(fixed_one))); }

// How many columns a line has moved sideways when it meets row `v`, which may lie before the grid.
int drift(const WindFrame& frame, int v) { return static_cast<int>(std::floor(v * frame.tangent + 0.5)); }

// Rows before the grid from which a shadow can still reach into it, on a torus.
int warm_up_rows(const Terrain& terrain, const WindFrame& frame, double fall) {
  const SurfaceRange range = surface_range(terrain);
  // An axis wind meets the same cells again after one round; an oblique one is followed for at most `largest_side`
  // rows.
  const int limit = frame.tangent > 0 ? largest_side : frame.length;
  return shadow_reach(static_cast<double>(range.high) - range.low, fall, frame.cosine, limit);
}

}  // namespace

double shadow_fall(double angle, double cell_size, double quantum) {
  return std::tan(radians(angle)) * cell_size / quantum;
}

ShadowFalls shadow_falls(const WindFrame& frame, double fall) {
  const double row = fall / frame.cosine;
  if (frame.tangent <= 0) return {fall, 2 * fall, row};
  return {4 * row, fall, row};
}

Grid<std::uint8_t> shadow_map(const Terrain& terrain, double bearing, double fall) {
  Grid<std::uint8_t> dark(terrain.extent());
  if (dark.empty()) return dark;
  const WindFrame frame = wind_frame(terrain.extent(), bearing);
  const bool torus = terrain.boundary() == Boundary::torus;
  const ShadowFalls falls = shadow_falls(frame, fall);
  const Fixed row_fall = to_fixed(falls.row);
  const Fixed next_fall = to_fixed(falls.next);
  const Fixed second_fall = to_fixed(falls.second);
  const auto lines = static_cast<std::size_t>(frame.width);
  std::vector<Fixed> far(lines, no_line);     // shadow line of all that stands two rows upwind and farther
  std::vector<Fixed> next(lines, no_line);    // height of the next row upwind
  std::vector<Fixed> second(lines, no_line);  // and of the second
  const int start = torus ? -warm_up_rows(terrain, frame, fall) : 0;
  for (int row = start; row < frame.length; ++row) {
    const int sideways = drift(frame, row);
    const bool moved = row > start && sideways != drift(frame, row - 1);
    for (int line = 0; line < frame.width; ++line) {
      const int column = wrap(line + sideways, frame.width);
      const auto at = static_cast<std::size_t>(line);
      // A line that enters over the side has nothing upwind.
      if (!torus && moved && column == 0) far[at] = next[at] = second[at] = no_line;
      const std::size_t cell = frame.cell(column, wrap(row, frame.length));
      const Fixed height = (Fixed{terrain.bedrock()[cell]} + terrain.mobile()[cell]) * fixed_one;
      const Fixed near = std::max(next[at] - next_fall, second[at] - second_fall);
      if (row >= 0) dark[cell] = height < std::max(far[at], near) ? 1 : 0;
      far[at] = std::max(next[at] - row_fall, far[at]) - row_fall;
      second[at] = next[at];
      next[at] = height;
    }
  }
  return dark;
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

}  // namespace erg::forcing
