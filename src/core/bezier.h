// A curve in the unit square, as people bend it in a window: time on x, value on y.
#pragma once

namespace erg {

/// A point of a curve: x across, y up, in the units of the curve.
struct CurvePoint {
  double x = 0;
  double y = 0;
  bool operator==(const CurvePoint&) const = default;
};

/// A cubic Bezier from (0, 0) to (1, 1) with two control points in the unit square. Since both have x in [0, 1], x
/// grows along the curve and y is a function of x. The default is the straight line.
struct BezierCurve {
  CurvePoint first{1.0 / 3, 1.0 / 3};
  CurvePoint second{2.0 / 3, 2.0 / 3};

  /// y at x, both in [0, 1]; x outside is clamped. Solved for the curve's own parameter by bisection to 2^-50.
  double at(double x) const;
  bool operator==(const BezierCurve&) const = default;
};

}  // namespace erg
