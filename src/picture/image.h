// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "picture/palette.h"

namespace erg::picture {

/// A colour picture, 8 bits a channel, row 0 at the top (unlike grids).
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< red, green, blue, row by row

  RgbImage() = default;
  RgbImage(int width, int height, Colour colour = {});

  /// The three bytes of a pixel, which must be inside.
  std::uint8_t* pixel(int x, int y) { return pixels.data() + offset(x, y); }
  const std::uint8_t* pixel(int x, int y) const { return pixels.data() + offset(x, y); }
  /// Sets one pixel; outside the picture nothing happens.
  void set(int x, int y, Colour colour) { cover(x, y, colour, 1.0); }
  /// Blends a colour over one pixel, opacity in [0, 1]; outside the picture nothing happens.
  void cover(int x, int y, Colour colour, double opacity);
  /// Copies another picture in, its upper left corner at (left, top); parts outside are cut off.
  void paste(const RgbImage& other, int left, int top);

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

/// A colour picture with opacity, 8 bits a channel, row 0 at the top; colours are not multiplied by the opacity.
struct RgbaImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< red, green, blue, opacity, row by row
};

/// The picture over a background.
RgbImage over(const RgbaImage& image, Colour background);

}  // namespace erg::picture
