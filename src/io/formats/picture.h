// The top view of a terrain as a picture, lit by the sun, with a scale bar and the wind. Computed without OpenGL.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/terrain.h"
#include "forcing/wind_schedule.h"
#include "io/formats/png.h"

namespace erg::io {

/// What a top view shows, and how.
struct PictureOptions {
  int pixels = 1024;  ///< length of the longer side of the map, about: small grids are enlarged by whole factors
  std::string palette = "sand";          ///< colours of the mobile layer by height, see palette_names()
  std::string field;                     ///< key of a declared field to lay over the sand in its own palette; "": none
  double sun_bearing = 300;              ///< degrees: where the sun stands
  double sun_altitude = 30;              ///< degrees above the horizon
  std::optional<forcing::Forcing> wind;  ///< draws the wind arrow
  bool legend = true;                    ///< a strip below with scale bar, wind and `caption`
  std::string caption;                   ///< "Momiji et al. 2000, step 1500"
};

/// Draws the terrain: north up. Slabs are smoothed away (they are a unit of account, not steps of the ground), crests
/// are kept. Throws InputError for an unknown palette or field.
picture::RgbImage draw_picture(const Terrain& terrain, const PictureOptions& options);

}  // namespace erg::io
