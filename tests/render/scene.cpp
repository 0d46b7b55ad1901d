#include "scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace erg::test {

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
  RgbImage image;
  int channels = 0;
  unsigned char* const pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, 3);
  if (pixels == nullptr) throw std::runtime_error("no picture " + path.string());
  image.pixels.assign(pixels, pixels + 3 * static_cast<std::ptrdiff_t>(image.width) * image.height);
  stbi_image_free(pixels);
  return image;
}

}  // namespace erg::test
