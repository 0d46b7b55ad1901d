#include "io/formats/legend.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "forcing/bearing.h"
#include "picture/annotations.h"
#include "picture/label.h"

namespace erg::io {

using picture::Colour;
using picture::draw_label;
using picture::label_width;
using picture::RgbImage;

namespace {

constexpr Colour paper{0.965f, 0.955f, 0.935f};
constexpr Colour ink{0.20f, 0.18f, 0.16f};
constexpr double text_size = picture::annotation_text_size;
constexpr int margin = 14;

// Draws arrow and bearing at the right edge; returns the first pixel used.
int draw_wind(RgbImage& image, int baseline, const forcing::Forcing& wind) {
  const std::string text = "wind " + picture::number_text(std::round(wind.mean_bearing())) + "°";
  const int left = image.width - margin - label_width(text, text_size);
  draw_label(image, text, left, baseline, text_size, ink);
  const forcing::Direction toward = forcing::downwind(wind.mean_bearing());
  picture::draw_arrow(image, left - 24, baseline - 6, toward.x, toward.y, 30, ink);
  return left - 42;
}

}  // namespace

void draw_legend(RgbImage& image, double pixel_size, const PictureOptions& options) {
  image.paste(RgbImage(image.width, legend_height, paper), 0, image.height - legend_height);
  const int baseline = image.height - 16;
  const int left = picture::draw_scale_bar(image, margin, baseline, 0.22 * image.width, pixel_size, ink) + 2 * margin;
  const int right = (options.wind ? draw_wind(image, baseline, *options.wind) : image.width) - 2 * margin;
  const int width = label_width(options.caption, text_size);
  if (width <= right - left) draw_label(image, options.caption, (left + right - width) / 2, baseline, text_size, ink);
}

}  // namespace erg::io
