#include "scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/formats/png_reader.h"

namespace erg::test {

using picture::RgbImage;

Difference difference(const RgbImage& first, const RgbImage& second) {
  if (first.width != second.width || first.height != second.height) return {255, 255};
  constexpr int block = 4;
  Difference result;
  int count = 0;
  for (int top = 0; top + block <= first.height; top += block) {
    for (int left = 0; left + block <= first.width; left += block) {
      for (int channel = 0; channel < 3; ++channel, ++count) {
        double sum = 0;
        for (int y = top; y < top + block; ++y) {
          for (int x = left; x < left + block; ++x) sum += first.pixel(x, y)[channel] - second.pixel(x, y)[channel];
        }
        const double apart = std::abs(sum) / (block * block);
        result.mean += apart;
        result.largest = std::max(result.largest, apart);
      }
    }
  }
  result.mean /= std::max(1, count);
  return result;
}

RgbImage read_picture(const std::filesystem::path& path) {
  io::PngReader png(path);
  if (png.channels() != 3) throw std::runtime_error("no picture in colours: " + path.string());
  RgbImage image;
  image.width = png.width();
  image.height = png.height();
  png.read_rows([&](int, std::span<const std::uint16_t> samples) {
    for (const std::uint16_t sample : samples) image.pixels.push_back(static_cast<unsigned char>(sample >> 8));
  });
  return image;
}

}  // namespace erg::test
