// Colour palettes, declared once: pictures, the OpenGL renderer and the window all draw from this table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace erg::picture {

/// A colour in sRGB, each part in [0, 1].
struct Colour {
  float red = 0;
  float green = 0;
  float blue = 0;
  bool operator==(const Colour&) const = default;
};

/// The colour a fraction t of the way from `first` to `second`; t outside [0, 1] is clamped.
Colour blend(Colour first, Colour second, double t);

/// A named palette: equally spaced control points from the lowest value to the highest, joined by straight lines in
/// sRGB.
struct Palette {
  std::string name;
  std::string meaning;  ///< what it is good for, and where it comes from
  std::vector<Colour> points;

  /// The colour at t, 0 (lowest) to 1 (highest); t outside is clamped, not-a-number counts as 0.
  Colour at(double t) const;
};

/// The names of all palettes, in the order people should meet them.
const std::vector<std::string>& palette_names();

/// The palette of this name; throws InputError with the nearest name.
const Palette& find_palette(std::string_view name);

}  // namespace erg::picture
