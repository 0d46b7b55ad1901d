#include "core/bezier.h"

namespace erg {
namespace {

/// One coordinate of the curve at its own parameter t: 0 at t = 0, 1 at t = 1, pulled by the two control values.
double bernstein(double t, double first, double second) {
  const double rest = 1 - t;
  return 3 * rest * rest * t * first + 3 * rest * t * t * second + t * t * t;
}

}  // namespace

double BezierCurve::at(double x) const {
  if (!(x > 0)) return 0;
  if (x >= 1) return 1;
  double low = 0;
  double high = 1;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (low + high) / 2;
    (bernstein(middle, first.x, second.x) < x ? low : high) = middle;
  }
  return bernstein((low + high) / 2, first.y, second.y);
}

}  // namespace erg
