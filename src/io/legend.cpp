#include "io/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/label.h"
#include "wind/bearing.h"

namespace erg {
namespace {

constexpr Colour paper{0.965f, 0.955f, 0.935f};
constexpr Colour ink{0.20f, 0.18f, 0.16f};
constexpr double text_size = 17;
constexpr int margin = 14;

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// How much of a pixel a shape covers, from the signed distance of its centre to the edge.
double coverage(double distance_inside) { return std::clamp(distance_inside + 0.5, 0.0, 1.0); }

// A triangle-headed arrow through (x, y), pointing along `toward` (y north), `length` pixels long.
void draw_arrow(RgbImage& image, double x, double y, Direction toward, double length) {
  const double half = 0.5 * length;
  const double head = 0.42 * length;
  const int reach = static_cast<int>(std::ceil(half)) + 1;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const double along = column * toward.x - row * toward.y;
      const double aside = std::abs(column * toward.y + row * toward.x);
      const double in_shaft = std::min({1.4 - aside, along + half, half - head - along});
      const double in_head = std::min(along - (half - head), 0.9 * (0.5 * (half - along) - aside));
      const double share = coverage(std::max(in_shaft, in_head));
      if (share > 0) image.cover(static_cast<int>(x) + column, static_cast<int>(y) + row, ink, share);
    }
  }
}

// Draws the bar and its length; returns the pixels used.
int draw_scale_bar(RgbImage& image, int baseline, double pixel_size) {
  const double length = round_length(0.22 * image.width * pixel_size);
  const int pixels = std::max(1, static_cast<int>(std::lround(length / pixel_size)));
  for (int x = 0; x < pixels; ++x) {
    for (int y = 0; y < 3; ++y) image.set(margin + x, baseline - 4 - y, ink);
  }
  for (int y = -10; y <= 0; ++y) {
    for (int side = 0; side < 2; ++side) {
      image.set(margin + side, baseline + y, ink);
      image.set(margin + pixels - 1 - side, baseline + y, ink);
    }
  }
  const std::string text = length_text(length);
  draw_label(image, text, margin + pixels + 8, baseline, text_size, ink);
  return margin + pixels + 8 + label_width(text, text_size);
}

// Draws arrow and bearing at the right edge; returns the first pixel used.
int draw_wind(RgbImage& image, int baseline, const WindNow& wind) {
  const std::string text = "wind " + number_text(std::round(wind.bearing)) + " deg";
  const int left = image.width - margin - label_width(text, text_size);
  draw_label(image, text, left, baseline, text_size, ink);
  draw_arrow(image, left - 24, baseline - 6, downwind(wind.bearing), 30);
  return left - 42;
}

}  // namespace

double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest) + 1e-9));
  const double share = longest / power;
  return power * (share >= 5 - 1e-9 ? 5 : share >= 2 - 1e-9 ? 2 : 1);
}

std::string length_text(double metres) {
  if (metres >= 999.5) return number_text(metres / 1000) + " km";
  if (metres >= 0.9995) return number_text(metres) + " m";
  if (metres >= 0.009995) return number_text(metres * 100) + " cm";
  return number_text(metres * 1000) + " mm";
}

void draw_legend(RgbImage& image, double pixel_size, const PictureOptions& options) {
  image.paste(RgbImage(image.width, legend_height, paper), 0, image.height - legend_height);
  const int baseline = image.height - 16;
  const int left = draw_scale_bar(image, baseline, pixel_size) + 2 * margin;
  const int right = (options.wind ? draw_wind(image, baseline, *options.wind) : image.width) - 2 * margin;
  const int width = label_width(options.caption, text_size);
  if (width <= right - left) draw_label(image, options.caption, (left + right - width) / 2, baseline, text_size, ink);
}

}  // namespace erg
