#include "analysis/migration.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace erg::analysis {
namespace {

struct Peak {
  int x = 0;
  int y = 0;
};

// The largest value; of equal ones (to rounding) the one with the shortest shift.
Peak find_peak(const Grid<double>& correlation, double cells_x, double cells_y) {
  const double highest = *std::max_element(correlation.cells().begin(), correlation.cells().end());
  Peak best;
  double shortest = -1;
  for (int y = 0; y < correlation.ny(); ++y) {
    for (int x = 0; x < correlation.nx(); ++x) {
      if (correlation(x, y) < highest * (1 - 1e-9)) continue;
      const double distance =
          std::hypot(signed_frequency(x, correlation.nx()) * cells_x, signed_frequency(y, correlation.ny()) * cells_y);
      if (shortest >= 0 && distance >= shortest) continue;
      shortest = distance;
      best = {x, y};
    }
  }
  return best;
}

// The top of the quadratic surface through the 3 x 3 values round the peak, as a shift in blocks. Along a ridge
// (endless crests) the top is not defined: only the part of the shift across it is returned.
Eigen::Vector2d refined_shift(const Grid<double>& correlation, Peak peak) {
  const auto at = [&](int dx, int dy) { return correlation.wrapped(peak.x + dx, peak.y + dy); };
  // Differences across one axis, averaged 1:2:1 along the other: then waves of any direction give an exact ridge.
  const auto column = [&](int dx) { return 0.25 * (at(dx, -1) + 2 * at(dx, 0) + at(dx, 1)); };
  const auto row = [&](int dy) { return 0.25 * (at(-1, dy) + 2 * at(0, dy) + at(1, dy)); };
  const Eigen::Vector2d slope(0.5 * (column(1) - column(-1)), 0.5 * (row(1) - row(-1)));
  Eigen::Matrix2d curvature;
  curvature(0, 0) = column(1) - 2 * column(0) + column(-1);
  curvature(1, 1) = row(1) - 2 * row(0) + row(-1);
  curvature(0, 1) = curvature(1, 0) = 0.25 * (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(curvature);
  const double sharpest = axes.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::Vector2d whole(signed_frequency(peak.x, correlation.nx()), signed_frequency(peak.y, correlation.ny()));
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  for (int axis = 0; axis < 2; ++axis) {
    const double bend = axes.eigenvalues()(axis);
    if (bend >= -1e-6 * sharpest) continue;
    const Eigen::Vector2d direction = axes.eigenvectors().col(axis);
    shift += direction * (direction.dot(whole) + std::clamp(-direction.dot(slope) / bend, -1.0, 1.0));
  }
  return shift;
}

bool is_flat(const Spectrum2D& spectrum) {
  double power = 0;
  for (const auto& value : spectrum.values.cells()) power += std::norm(value);
  const auto cells = static_cast<double>(spectrum.values.size());
  return power <= 1e-20 * cells * cells;
}

std::optional<Shift> shift_between(const Spectrum2D& earlier, const Spectrum2D& later, double cells_x, double cells_y,
                                   const ShareWork& share) {
  if (earlier.nx != later.nx || earlier.values.extent() != later.values.extent() || is_flat(earlier) || is_flat(later))
    return std::nullopt;
  Spectrum2D cross = later;
  for (std::size_t cell = 0; cell < cross.values.size(); ++cell) cross.values[cell] *= std::conj(earlier.values[cell]);
  const Grid<double> correlation = transform_back(std::move(cross), share);
  const Peak peak = find_peak(correlation, cells_x, cells_y);
  const Eigen::Vector2d shift = refined_shift(correlation, peak);
  return Shift{shift.x() * cells_x, shift.y() * cells_y};
}

}  // namespace

std::optional<Shift> pattern_shift(const CoarseSurface& earlier, const CoarseSurface& later) {
  return shift_between(transform(earlier), transform(later), later.cells_x, later.cells_y, do_alone);
}

void MigrationTracker::observe(std::int64_t step, const CoarseSurface& surface, const ShareWork& share) {
  Spectrum2D spectrum = transform(surface, share);
  if (last_.nx != spectrum.nx || last_.values.extent() != spectrum.values.extent()) restart();
  if (!last_.values.empty() && step > last_step_) {
    if (const auto shift = shift_between(last_, spectrum, surface.cells_x, surface.cells_y, share)) {
      travelled_.x += shift->x;
      travelled_.y += shift->y;
      steps_ += step - last_step_;
    }
  }
  last_ = std::move(spectrum);
  last_step_ = step;
}

void MigrationTracker::start_anew() {
  steps_ = 0;
  travelled_ = {};
}

std::optional<Shift> MigrationTracker::velocity() const {
  if (steps_ == 0) return std::nullopt;
  const auto steps = static_cast<double>(steps_);
  return Shift{travelled_.x / steps, travelled_.y / steps};
}

}  // namespace erg::analysis
