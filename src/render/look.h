// How a picture is drawn: material or values, light, smoothing, extras.
#pragma once

#include <string>
#include <vector>

#include "picture/palette.h"
#include "render/terrain_view.h"

namespace erg::render {

/// How the terrain looks.
struct Look {
  /// "material" (sand or snow as the view says, rock, plants), "sand", "snow", "elevation", "slope", or a field's key.
  std::string show = "material";
  std::string palette;       ///< for values; "": the field's own, RdYlGn for elevation, batlow for slope
  double contours = 0;       ///< interval of contour lines, in the unit of what is shown (material: m); 0: none
  bool wireframe = false;    ///< the strips' edges over the terrain
  bool raw_cells = false;    ///< no smoothing: straight lines from cell to cell
  bool shading = true;       ///< values are shaded by sun and sky
  double exaggeration = 1;   ///< of heights
  double sun_bearing = 285;  ///< degrees: where the sun stands
  double sun_altitude = 24;  ///< degrees above the horizon
  double grain = 1;          ///< strength of grains and ripples, 0 to 1
  int copies = 0;            ///< rings of copies around a torus, as far as the horizon
  bool tufts = true;         ///< plants as tufts where the view has a field "vegetation"
  bool legend = true;        ///< legend, wind arrow, scale bar (the latter in orthographic views from above only)
  bool transparent = false;  ///< nothing behind the terrain

  bool operator==(const Look&) const = default;

  /// True when a material is drawn, not values.
  bool is_material() const { return show == "material" || show == "sand" || show == "snow"; }
};

/// The looks that every terrain has, besides its fields.
const std::vector<std::string>& standard_looks();

/// The scale of the values of a picture.
struct ValueScale {
  std::string label;
  std::string unit;
  double low = 0;
  double high = 1;
  picture::Palette palette;
};

/// Checks a look against a view; throws InputError (with the nearest word) for an unknown look or palette, and for
/// numbers out of range.
void check_look(const Look& look, const TerrainView& view);

/// The scale of the values that a look shows: from the least to the greatest value there is. Values that are not
/// numbers do not count; when nothing counts, the field's declared range.
ValueScale value_scale(const Look& look, const TerrainView& view);

}  // namespace erg::render
