// Curves that are drawn, not listed: a Bezier in a box, or a line of points, bent with the mouse or typed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bezier.h"
#include "ui/widgets/plot.h"

namespace erg::ui {

/// How a curve editor is framed: the ends of the axes in the curve's own units.
struct CurveFrame {
  std::string x_label;
  std::string y_label;
  AxisRange x;
  AxisRange y;  ///< y at the curve's 0 and at its 1; the first may be the greater one
  float height = 0;
  std::optional<double> cursor;  ///< on x
};

/// Edits the two control points of a curve: drag them (with Shift they snap to tenths of the box), type their numbers,
/// or RESET to the straight line. True when the curve changed.
bool edit_curve(const char* id, BezierCurve& curve, const CurveFrame& frame);

/// Edits a line of points with x growing, in the units of the axes: drag (Shift snaps to tenths of the box), double
/// click to add a point, right click to remove one; at least two remain. `standard` is what RESET gives back. True when
/// it changed.
bool edit_points(const char* id, std::vector<CurvePoint>& points, const std::vector<CurvePoint>& standard,
                 const CurveFrame& frame);

}  // namespace erg::ui
