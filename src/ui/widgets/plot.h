// Plots over ImGui's draw list: axes with round ticks, lines, bars, the value under the mouse.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/widgets/axis_ticks.h"

namespace erg::ui {

/// A stretch of the x axis that is set apart: a season of the wind.
struct PlotBand {
  double from = 0;
  double to = 0;
  std::string label;
  bool active = false;  ///< drawn in the accent
};

/// How a plot is framed.
struct PlotFrame {
  std::string x_label = {};  ///< what runs across, with its unit
  std::string y_label = {};  ///< what runs up, with its unit
  std::optional<AxisRange> x = {};
  std::optional<AxisRange> y = {};  ///< none: the range of the values, made round
  bool from_zero = false;           ///< the y axis starts at zero
  std::optional<double> cursor = {};
  std::vector<PlotBand> bands = {};
  float height = 0;  ///< pixels, whole; 0: as high as serves the width
};

/// One line. x grows; y that is not a number leaves a gap.
struct PlotLine {
  std::string label;
  std::span<const double> x;
  std::span<const double> y;
  ImU32 colour = 0;
};

/// A framed area with its scales: what plots and curve editors are drawn into.
struct PlotArea {
  ImVec2 upper_left;  ///< pixels
  ImVec2 lower_right;
  AxisRange x;
  AxisRange y;
  bool hovered = false;

  /// The pixel of a value pair.
  ImVec2 at(double px, double py) const;
  /// The value of x at a pixel's column.
  double x_at(float pixel) const;
};

/// Colours of lines that are told apart easily, on dark and on light.
ImU32 line_colour(int line);

/// Reserves the room of a plot and draws its frame, ticks and labels. x and y must be set in the frame.
PlotArea draw_axes(const char* id, const PlotFrame& frame);

/// Draws a line into an area, at most two points for each column of pixels.
void draw_line(const PlotArea& area, const PlotLine& line);

/// Lines over x with a legend; the x under the mouse, if any, whose values are shown.
std::optional<double> draw_plot(const char* id, std::span<const PlotLine> lines, const PlotFrame& frame);

/// Bars of equal width from `range.low` to `range.high`.
void draw_histogram(const char* id, std::span<const double> counts, AxisRange range, const PlotFrame& frame);

}  // namespace erg::ui
