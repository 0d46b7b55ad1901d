// Round numbers along an axis.
#pragma once

#include <string>

namespace erg::ui {

/// The span of an axis.
struct AxisRange {
  double low = 0;
  double high = 1;
};

/// Places on an axis that read well: steps of 1, 2 or 5 times a power of ten.
struct Ticks {
  double first = 0;
  double step = 1;
  int count = 0;
  double at(int tick) const { return (first / step + tick) * step; }
};

/// The ticks within [low, high], at most `most` of them (at least 2). No ticks when the range is empty or not finite.
Ticks round_ticks(AxisRange range, int most);

/// The range widened to whole ticks. A range without extent gets one around it; the low end of a range that starts at
/// zero stays there.
AxisRange round_range(AxisRange range, int most);

/// A tick as a person writes it: as many decimals as the step needs, thousands apart: "0.25", "12 000".
std::string tick_text(double value, double step);

/// A number of about `digits` figures as a person writes it: "3.14", "12 000", "-0.02", "1.5e+09".
std::string figure_text(double value, int digits = 4);

}  // namespace erg::ui
