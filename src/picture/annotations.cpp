#include "picture/annotations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "picture/label.h"

namespace erg::picture {
namespace {

// How much of a pixel a shape covers, from the signed distance of its centre to the edge.
double coverage(double distance_inside) { return std::clamp(distance_inside + 0.5, 0.0, 1.0); }

}  // namespace

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

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

void draw_arrow(RgbImage& image, double x, double y, double east, double north, double length, Colour colour) {
  const double half = 0.5 * length;
  const double head = 0.42 * length;
  const int reach = static_cast<int>(std::ceil(half)) + 1;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const double along = column * east - row * north;
      const double aside = std::abs(column * north + row * east);
      const double in_shaft = std::min({1.4 - aside, along + half, half - head - along});
      const double in_head = std::min(along - (half - head), 0.9 * (0.5 * (half - along) - aside));
      const double share = coverage(std::max(in_shaft, in_head));
      if (share > 0) image.cover(static_cast<int>(x) + column, static_cast<int>(y) + row, colour, share);
    }
  }
}

int draw_scale_bar(RgbImage& image, int left, int baseline, double longest, double pixel_size, Colour colour) {
  const double length = round_length(longest * pixel_size);
  const int pixels = std::max(1, static_cast<int>(std::lround(length / pixel_size)));
  for (int x = 0; x < pixels; ++x) {
    for (int y = 0; y < 3; ++y) image.set(left + x, baseline - 4 - y, colour);
  }
  for (int y = -10; y <= 0; ++y) {
    for (int side = 0; side < 2; ++side) {
      image.set(left + side, baseline + y, colour);
      image.set(left + pixels - 1 - side, baseline + y, colour);
    }
  }
  const std::string text = length_text(length);
  draw_label(image, text, left + pixels + 8, baseline, annotation_text_size, colour);
  return left + pixels + 8 + label_width(text, annotation_text_size);
}

}  // namespace erg::picture
