#include "picture/image.h"

#include <algorithm>
#include <cmath>

namespace erg::picture {
namespace {

std::uint8_t to_byte(double part) { return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255)); }

}  // namespace

RgbImage::RgbImage(int wide, int high, Colour colour) : width(wide), height(high) {
  const std::size_t count = static_cast<std::size_t>(wide) * static_cast<std::size_t>(high);
  pixels.reserve(3 * count);
  for (std::size_t index = 0; index < count; ++index) {
    pixels.insert(pixels.end(), {to_byte(colour.red), to_byte(colour.green), to_byte(colour.blue)});
  }
}

void RgbImage::cover(int x, int y, Colour colour, double opacity) {
  if (x < 0 || x >= width || y < 0 || y >= height) return;
  std::uint8_t* const under = pixel(x, y);
  const auto mix = [opacity](std::uint8_t below, float above) {
    return to_byte(below / 255.0 + (above - below / 255.0) * opacity);
  };
  under[0] = mix(under[0], colour.red);
  under[1] = mix(under[1], colour.green);
  under[2] = mix(under[2], colour.blue);
}

void RgbImage::paste(const RgbImage& other, int left, int top) {
  const int first = std::max(0, -left);
  const int last = std::min(other.width, width - left);
  if (first >= last) return;
  for (int y = std::max(0, -top); y < std::min(other.height, height - top); ++y) {
    const std::uint8_t* const from = other.pixel(first, y);
    std::copy(from, from + 3 * static_cast<std::ptrdiff_t>(last - first), pixel(left + first, top + y));
  }
}

RgbImage over(const RgbaImage& image, Colour background) {
  RgbImage result(image.width, image.height, background);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* const from =
          image.pixels.data() +
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
      const auto part = [from](int channel) { return static_cast<float>(from[channel]) / 255.0f; };
      result.cover(x, y, {part(0), part(1), part(2)}, part(3));
    }
  }
  return result;
}

}  // namespace erg::picture
