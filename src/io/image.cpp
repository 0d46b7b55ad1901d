#include "io/image.h"

#include <algorithm>
#include <cmath>

#include "io/atomic_file.h"
#include "io/png_file.h"

namespace erg {
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

void write_png(const std::filesystem::path& path, const RgbImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 8, 3, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const GreyImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 16, 1, image.pixels.data()}, entries, path));
}

}  // namespace erg
