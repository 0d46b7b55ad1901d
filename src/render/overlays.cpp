#include "render/overlays.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/number_text.h"
#include "core/units.h"
#include "picture/annotations.h"
#include "picture/label.h"

namespace erg::render {

using picture::Colour;
using picture::draw_label;
using picture::label_width;
using picture::number_text;
using picture::RgbImage;
using picture::round_length;

namespace {

constexpr int margin = 18;
constexpr int bar_width = 16;
constexpr int least_side = 200;  // pixels: below, nothing is written
constexpr double text_size = picture::annotation_text_size;
constexpr Colour paper{0.98f, 0.97f, 0.95f};
constexpr Colour ink{0.13f, 0.12f, 0.11f};

// A number with as many digits as the span between the ends needs.
std::string short_number(double value, double span) {
  char text[40];
  const int digits = span > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(span))), 0, 6) : 2;
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

// A pale plate under writing, so that it reads on any ground.
void draw_plate(RgbImage& image, int left, int top, int wide, int high) {
  constexpr double opacity = 0.72;
  for (int y = top; y < top + high; ++y) {
    for (int x = left; x < left + wide; ++x) image.cover(x, y, paper, opacity);
  }
}

void draw_legend_bar(RgbImage& image, const ValueScale& scale) {
  const int high = std::min(280, image.height / 2);
  const double span = scale.high - scale.low;
  constexpr int marks = 4;
  const std::string title = with_unit(scale.label, scale.unit.empty() ? "" : "(" + unit_text(scale.unit) + ")");
  int wide = label_width(title, text_size);
  for (const double end : {scale.low, scale.high}) {
    wide = std::max(wide, bar_width + 14 + label_width(short_number(end, span), text_size));
  }
  const int left = image.width - margin - wide;
  const int top = margin + 26;
  draw_plate(image, left - 10, margin - 8, wide + 20, high + 50);
  draw_label(image, title, left, margin + 10, text_size, ink);
  for (int y = 0; y < high; ++y) {
    const Colour colour = scale.palette.at(1 - (y + 0.5) / high);
    for (int x = 0; x < bar_width; ++x) image.set(left + x, top + y, colour);
  }
  for (int mark = 0; mark <= marks; ++mark) {
    const double share = static_cast<double>(mark) / marks;
    const int y = top + static_cast<int>(std::lround((1 - share) * (high - 1)));
    for (int x = 0; x < 5; ++x) image.set(left + bar_width + x, y, ink);
    draw_label(image, short_number(scale.low + share * span, span), left + bar_width + 10, y + 6, text_size, ink);
  }
}

int draw_wind(RgbImage& image, int left, const Overlay& overlay) {
  const std::string text = "wind " + number_text(std::round(*overlay.wind)) + "°";
  const int baseline = image.height - margin;
  // The arrow lies on the terrain: it turns with the camera.
  const double toward = radians(*overlay.wind + 180 - (overlay.camera_bearing + 180));
  draw_plate(image, left - 8, baseline - 25, label_width(text, text_size) + 56, 36);
  picture::draw_arrow(image, left + 16, baseline - 6, std::sin(toward), std::cos(toward), 30, ink);
  draw_label(image, text, left + 40, baseline, text_size, ink);
  return left + label_width(text, text_size) + 70;
}

int draw_scale(RgbImage& image, int left, double pixel_size) {
  const double longest = 0.2 * image.width;
  const std::string text = picture::length_text(round_length(longest * pixel_size));
  const double bar = round_length(longest * pixel_size) / pixel_size;
  draw_plate(image, left - 8, image.height - margin - 25, static_cast<int>(bar) + label_width(text, text_size) + 24,
             36);
  return picture::draw_scale_bar(image, left, image.height - margin, longest, pixel_size, ink) + 24;
}

}  // namespace

void draw_overlay(RgbImage& image, const Overlay& overlay) {
  if (image.width < least_side || image.height < least_side) return;
  if (overlay.scale) draw_legend_bar(image, *overlay.scale);
  int left = margin + 8;
  if (overlay.pixel_size) left = draw_scale(image, left, *overlay.pixel_size);
  if (overlay.wind) left = draw_wind(image, left, overlay);
  if (overlay.contours > 0) {
    const std::string text = "lines every " + with_unit(number_text(overlay.contours), overlay.contour_unit);
    draw_plate(image, left - 8, image.height - margin - 25, label_width(text, text_size) + 16, 36);
    draw_label(image, text, left, image.height - margin, text_size, ink);
  }
}

}  // namespace erg::render
