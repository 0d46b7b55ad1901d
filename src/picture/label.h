// Text on pictures.
#pragma once

#include <string_view>

#include "picture/image.h"

namespace erg::picture {

/// The width of a line of text in pixels, or 0 where no font is installed. `size` is the height of a line in pixels.
int label_width(std::string_view text, double size);

/// Draws one line of text with its left end at x and its baseline at y. Without an installed font (DejaVu Sans) nothing
/// is drawn: a picture without labels is better than none.
void draw_label(RgbImage& image, std::string_view text, int x, int y, double size, Colour colour);

}  // namespace erg::picture
