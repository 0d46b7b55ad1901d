#include "analysis/crests.h"

#include <algorithm>
#include <atomic>
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

/// A point on its way over the torus of the blocks' middles.
class Walker {
 public:
  Walker(const Grid<double>& heights, double x, double y) : heights_(heights) { stand_at(x, y); }

  /// Whether it has not just gone over the edge, beyond the outermost middles.
  bool inside() const { return inside_; }
  /// By bilinear interpolation.
  double height() const {
    const int column = static_cast<int>(x_);
    const int row = static_cast<int>(y_);
    const int beside = column + 1 == heights_.nx() ? 0 : column + 1;
    const double* const low = heights_.row(row).data();
    const double* const high = heights_.row(row + 1 == heights_.ny() ? 0 : row + 1).data();
    const double part = x_ - column;
    const double south = low[column] + (low[beside] - low[column]) * part;
    const double north = high[column] + (high[beside] - high[column]) * part;
    return south + (north - south) * (y_ - row);
  }
  /// On by less than the grid is wide and high.
  void go(double step_x, double step_y) { stand_at(x_ + step_x, y_ + step_y); }

 private:
  void stand_at(double x, double y) {
    inside_ = x >= 0 && y >= 0 && x <= heights_.nx() - 1 && y <= heights_.ny() - 1;
    x_ = folded(x, heights_.nx());
    y_ = folded(y, heights_.ny());
  }
  static double folded(double value, int period) {
    if (value < 0) value += period;
    return value >= period ? value - period : value;  // also where the sum was rounded up to the period
  }

  const Grid<double>& heights_;
  double x_ = 0;
  double y_ = 0;
  bool inside_ = true;
};

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

double crest_spacing(const CoarseSurface& surface, double bearing, const ShareWork& share) {
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
  std::atomic<std::int64_t> gaps = 0;
  std::atomic<std::int64_t> samples_between = 0;
  const auto follow = [&](int line) {
    Walker walker(heights, std::fmod(line * golden, 1.0) * heights.nx(), (line + 0.5) * heights.ny() / lines);
    CrestCount count(levels);
    for (int sample = 0; sample < samples && (surface.periodic || walker.inside()); ++sample) {
      count.look(sample, walker.height());
      walker.go(step_x, step_y);
    }
    gaps += count.gaps();
    samples_between += count.samples_between();
  };
  share(lines, [&](std::int64_t begin, std::int64_t end) {
    for (auto line = static_cast<int>(begin); line < end; ++line) follow(line);
  });
  return gaps > 0 ? stride * static_cast<double>(samples_between) / static_cast<double>(gaps) : 0;
}

}  // namespace erg::analysis
