#include "wind/shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/units.h"
#include "wind/bearing.h"

namespace erg {
namespace {

// Heights on the scan are fixed-point numbers: the shadow line falls by whole counts, so that the answer does not depend
// on how often it was subtracted.
using Fixed = std::int64_t;
constexpr double fixed_one = 0x1.0p24;
constexpr Fixed no_line = std::numeric_limits<Fixed>::min() / 4;

// Rounded up, so that a cell exactly on the shadow line counts as lit.
Fixed to_fixed(double value) { return static_cast<Fixed>(std::ceil(value * fixed_one)); }

// The grid seen from the wind: it blows toward growing rows, and toward growing columns at no more than 45 degrees.
class WindFrame {
 public:
  WindFrame(const Terrain& terrain, double bearing) {
    const Direction toward = downwind(bearing);
    const bool along_x = std::abs(toward.x) >= std::abs(toward.y);
    const int nx = terrain.nx();
    const std::ptrdiff_t step_x = toward.x < 0 ? -1 : 1;
    const std::ptrdiff_t step_y = toward.y < 0 ? -nx : nx;
    if (toward.x < 0) first_ += nx - 1;
    if (toward.y < 0) first_ += static_cast<std::ptrdiff_t>(terrain.ny() - 1) * nx;
    rows = along_x ? nx : terrain.ny();
    columns = along_x ? terrain.ny() : nx;
    row_step_ = along_x ? step_x : step_y;
    column_step_ = along_x ? step_y : step_x;
    const double along = along_x ? std::abs(toward.x) : std::abs(toward.y);
    const double across = along_x ? std::abs(toward.y) : std::abs(toward.x);
    cosine = along;
    tangent = across / along;
  }

  std::size_t cell(int row, int column) const {
    return static_cast<std::size_t>(first_ + row * row_step_ + column * column_step_);
  }
  // How many columns a line has moved sideways when it meets row `row`, which may lie before the grid.
  int drift(int row) const { return static_cast<int>(std::floor(row * tangent + 0.5)); }

  int rows = 0;
  int columns = 0;
  double cosine = 1;
  double tangent = 0;

 private:
  std::ptrdiff_t first_ = 0;
  std::ptrdiff_t row_step_ = 0;
  std::ptrdiff_t column_step_ = 0;
};

// Rows before the grid from which a shadow can still reach into it, on a torus.
int warm_up_rows(const Terrain& terrain, const WindFrame& frame, double fall) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();
  for (std::size_t cell = 0; cell < bedrock.size(); ++cell) {
    low = std::min(low, bedrock[cell] + mobile[cell]);
    high = std::max(high, bedrock[cell] + mobile[cell]);
  }
  // An axis wind meets the same cells again after one round; an oblique one is followed for at most `largest_side` rows.
  const int limit = frame.tangent * frame.rows < 0.5 ? frame.rows : std::max(frame.rows, largest_side);
  const double reach = (static_cast<double>(high) - low) * frame.cosine / std::max(fall, 1e-12) + 3;
  return reach < limit ? static_cast<int>(reach) : limit;
}

}  // namespace

double shadow_fall(double angle, double cell_size, double quantum) {
  return std::tan(radians(angle)) * cell_size / quantum;
}

Grid<std::uint8_t> shadow_map(const Terrain& terrain, double bearing, double fall) {
  Grid<std::uint8_t> dark(terrain.extent());
  if (dark.empty()) return dark;
  const WindFrame frame(terrain, bearing);
  const bool torus = terrain.boundary() == Boundary::torus;
  const Fixed fall_far = to_fixed(fall / frame.cosine);
  const Fixed fall_near = to_fixed(fall);
  std::vector<Fixed> far(static_cast<std::size_t>(frame.columns), no_line);   // S: shadow line of all peaks passed
  std::vector<Fixed> near(static_cast<std::size_t>(frame.columns), no_line);  // N: shadow line of the adjacent cell
  const int start = torus ? -warm_up_rows(terrain, frame, fall) : 0;
  for (int row = start; row < frame.rows; ++row) {
    const int inside = wrap(row, frame.rows);
    const int drift = frame.drift(row);
    const bool moved_sideways = row > start && drift != frame.drift(row - 1);
    for (int line = 0; line < frame.columns; ++line) {
      const int column = wrap(line + drift, frame.columns);
      const auto at = static_cast<std::size_t>(line);
      if (!torus && moved_sideways && column == 0) far[at] = near[at] = no_line;  // this line has just entered
      const std::size_t cell = frame.cell(inside, column);
      const Fixed height = static_cast<Fixed>(terrain.bedrock()[cell] + terrain.mobile()[cell]) << 24;
      if (row >= 0) dark[cell] = height < std::max(far[at], near[at]) ? 1 : 0;
      far[at] = std::max(height, far[at]) - fall_far;
      near[at] = height - fall_near;
    }
  }
  return dark;
}

}  // namespace erg
