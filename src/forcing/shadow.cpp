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

namespace erg {
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

Grid<std::uint8_t> shadow_map(const Terrain& terrain, double bearing, double fall) {
  Grid<std::uint8_t> dark(terrain.extent());
  if (dark.empty()) return dark;
  const WindFrame frame = wind_frame(terrain.extent(), bearing);
  const bool torus = terrain.boundary() == Boundary::torus;
  const Fixed fall_far = to_fixed(fall / frame.cosine);
  const Fixed fall_near = to_fixed(fall);
  std::vector<Fixed> far(static_cast<std::size_t>(frame.width), no_line);   // S: shadow line of all peaks passed
  std::vector<Fixed> near(static_cast<std::size_t>(frame.width), no_line);  // N: shadow line of the adjacent cell
  const int start = torus ? -warm_up_rows(terrain, frame, fall) : 0;
  for (int row = start; row < frame.length; ++row) {
    const int sideways = drift(frame, row);
    const bool moved = row > start && sideways != drift(frame, row - 1);
    for (int line = 0; line < frame.width; ++line) {
      const int column = wrap(line + sideways, frame.width);
      const auto at = static_cast<std::size_t>(line);
      if (!torus && moved && column == 0) far[at] = near[at] = no_line;  // this line enters over the side here
      const std::size_t cell = frame.cell(column, wrap(row, frame.length));
      const Fixed height = (Fixed{terrain.bedrock()[cell]} + terrain.mobile()[cell]) * fixed_one;
      if (row >= 0) dark[cell] = height < std::max(far[at], near[at]) ? 1 : 0;
      far[at] = std::max(height, far[at]) - fall_far;
      near[at] = height - fall_near;
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

}  // namespace erg
