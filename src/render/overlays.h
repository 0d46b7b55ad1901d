// What is written over a picture: legend, wind, scale.
#pragma once

#include <optional>

#include "picture/image.h"
#include "render/camera.h"
#include "render/look.h"

namespace erg::render {

/// What there is to write.
struct Overlay {
  std::optional<ValueScale> scale;  ///< the legend's
  double contours = 0;              ///< interval of contour lines; 0: none
  std::string contour_unit;
  std::optional<double> wind;        ///< degrees
  std::optional<double> pixel_size;  ///< m, where the picture has one scale: in orthographic views from above
  double camera_bearing = 180;       ///< degrees
};

/// Draws it over the picture's edges. Parts that do not fit are left out.
void draw_overlay(picture::RgbImage& image, const Overlay& overlay);

}  // namespace erg::render
