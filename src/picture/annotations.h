// Annotations of pictures: scale bars, arrows, and the words beside them.
#pragma once

#include <string>

#include "picture/image.h"

namespace erg::picture {

inline constexpr double annotation_text_size = 17;  ///< pixels: the height of a line beside an arrow or a bar

/// "2.5", "1e-06": at most six digits.
std::string number_text(double value);

/// A round length (1, 2 or 5 times a power of ten, in m) of at most `longest` m.
double round_length(double longest);

/// "50 m", "2 km", "20 cm", "5 mm".
std::string length_text(double metres);

/// Draws a triangle-headed arrow through (x, y), pointing along the unit vector (east, north), `length` pixels long.
void draw_arrow(RgbImage& image, double x, double y, double east, double north, double length, Colour colour);

/// Draws a bar of a round length, of at most `longest` pixels, from `left` on and that length in words behind it.
/// `pixel_size` in m. The first free pixel column after both.
int draw_scale_bar(RgbImage& image, int left, int baseline, double longest, double pixel_size, Colour colour);

}  // namespace erg::picture
