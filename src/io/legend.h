// The strip under a picture: scale bar, caption, wind arrow.
#pragma once

#include "io/picture.h"

namespace erg {

inline constexpr int legend_height = 44;     ///< pixels
inline constexpr int smallest_legend = 360;  ///< pixels: width below which a picture is widened for its legend

/// A round length (1, 2 or 5 times a power of ten, in m) of at most `longest` m.
double round_length(double longest);

/// "50 m", "2 km", "20 cm", "5 mm".
std::string length_text(double metres);

/// Draws the strip over the lowest `legend_height` rows. `pixel_size` in m.
void draw_legend(RgbImage& image, double pixel_size, const PictureOptions& options);

}  // namespace erg
