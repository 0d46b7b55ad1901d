// The strip under a picture: scale bar, caption, wind arrow.
#pragma once

#include "io/formats/picture.h"

namespace erg::io {

inline constexpr int legend_height = 44;     ///< pixels
inline constexpr int smallest_legend = 360;  ///< pixels: width below which a picture is widened for its legend

/// Draws the strip over the lowest `legend_height` rows. `pixel_size` in m.
void draw_legend(picture::RgbImage& image, double pixel_size, const PictureOptions& options);

}  // namespace erg::io
