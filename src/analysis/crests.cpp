#include "analysis/crests.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace erg::analysis {
namespace {

constexpr int most_lines = 512;
constexpr int longest_line = 8192;  // samples

struct Levels {
  double low;
  double high;
};

Levels crossing_levels(const Grid<double>& heights) {
  double sum = 0;
  double squares = 0;
  const auto cells = static_cast<double>(heights.size());
  for (const double height : heights.cells()) sum += height;
  for (const double height : heights.cells()) squares += (height - sum / cells) * (height - sum / cells);
  const double margin = 0.25 * std::sqrt(squares / cells);
  return {sum / cells - margin, sum / cells + margin};
}

/// Between the blocks' middles, by bilinear interpolation on the torus.
double height_at(const Grid<double>& heights, double x, double y) {
  const double west = std::floor(x);
  const double south = std::floor(y);
  const int column = static_cast<int>(west);
  const int row = static_cast<int>(south);
  const auto between = [&](int at) {
    const double left = heights.wrapped(column, at);
    return left + (heights.wrapped(column + 1, at) - left) * (x - west);
  };
  return between(row) + (between(row + 1) - between(row)) * (y - south);
}

/// Counts along one line, sample by sample.
class CrestCount {
 public:
  explicit CrestCount(Levels levels) : levels_(levels) {}

  void look(int sample, double height) {
    if (height < levels_.low) below_ = true;
    if (!below_ || height <= levels_.high) return;
    below_ = false;
    if (crests_++ == 0) first_ = sample;
    last_ = sample;
  }
  int gaps() const { return std::max(0, crests_ - 1); }
  int samples_between() const { return last_ - first_; }

 private:
  Levels levels_;
  bool below_ = false;
  int crests_ = 0;
  int first_ = 0;
  int last_ = 0;
};

}  // namespace

double crest_spacing(const CoarseSurface& surface, double bearing) {
  const Grid<double>& heights = surface.heights;
  if (heights.empty()) return 0;
  const Levels levels = crossing_levels(heights);
  if (!(levels.low < levels.high)) return 0;
  const double stride = std::min(surface.cells_x, surface.cells_y);  // cells
  const double step_x = -std::sin(radians(bearing)) * stride / surface.cells_x;
  const double step_y = -std::cos(radians(bearing)) * stride / surface.cells_y;
  const int lines = std::min(heights.nx() + heights.ny(), most_lines);
  const int samples = std::min(2 * (heights.nx() + heights.ny()), longest_line);
  constexpr double golden = 0.6180339887498949;  // its multiples fill the width evenly
  std::int64_t gaps = 0;
  std::int64_t samples_between = 0;
  for (int line = 0; line < lines; ++line) {
    double x = std::fmod(line * golden, 1.0) * heights.nx();
    double y = (line + 0.5) * heights.ny() / lines;
    CrestCount count(levels);
    for (int sample = 0; sample < samples; ++sample, x += step_x, y += step_y) {
      if (!surface.periodic && (x < 0 || y < 0 || x > heights.nx() - 1 || y > heights.ny() - 1)) break;
      count.look(sample, height_at(heights, x, y));
    }
    gaps += count.gaps();
    samples_between += count.samples_between();
  }
  return gaps > 0 ? stride * static_cast<double>(samples_between) / static_cast<double>(gaps) : 0;
}

}  // namespace erg::analysis
