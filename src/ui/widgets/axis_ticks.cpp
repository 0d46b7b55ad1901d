#include "ui/widgets/axis_ticks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace erg::ui {
namespace {

/// 1, 2 or 5 times a power of ten, not less than `size`.
double round_step(double size) {
  const double power = std::pow(10.0, std::floor(std::log10(size)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (size <= factor * power * (1 + 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string fixed_text(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string figure = text;
  if (figure.find_first_not_of("-0.") == std::string::npos && figure.front() == '-') figure.erase(0, 1);  // "-0.0"
  const std::size_t point = std::min(figure.find('.'), figure.size());
  const std::size_t start = figure.front() == '-' ? 1 : 0;
  if (point - start < 5) return figure;  // 1234 reads well as it is
  for (std::size_t at = point - 3; at > start && at < point; at -= 3) figure.insert(at, " ");
  return figure;
}

}  // namespace

Ticks round_ticks(AxisRange range, int most) {
  const double span = range.high - range.low;
  if (!(span > 0) || !std::isfinite(span)) return {};
  Ticks ticks;
  ticks.step = round_step(span / std::max(1, most - 1));
  const double first = std::ceil(range.low / ticks.step - 1e-9);
  const double last = std::floor(range.high / ticks.step + 1e-9);
  ticks.first = first * ticks.step;
  ticks.count = std::max(0, static_cast<int>(last - first) + 1);
  return ticks;
}

AxisRange round_range(AxisRange range, int most) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high) || range.high < range.low) return {};
  if (range.high == range.low) {
    const double half = range.low == 0 ? 1 : std::abs(range.low) / 2;
    return range.low == 0 ? AxisRange{0, half} : AxisRange{range.low - half, range.high + half};
  }
  const double step = round_step((range.high - range.low) / std::max(1, most - 1));
  return {std::floor(range.low / step + 1e-9) * step, std::ceil(range.high / step - 1e-9) * step};
}

std::string tick_text(double value, double step) {
  const double size = std::max(std::abs(value), std::abs(step));
  if (size >= 1e9 || std::abs(step) < 1e-6) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
  }
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return fixed_text(value, decimals);
}

std::string figure_text(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (magnitude >= 9 || magnitude < -4) {
    char text[32];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, std::clamp(digits - 1, 1, 15));
    return {text, end};
  }
  std::string text = fixed_text(value, std::max(0, digits - 1 - std::max(0, magnitude)));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace erg::ui
