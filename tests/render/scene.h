// A small terrain for pictures, and ways to compare pictures.
#pragma once

#include <filesystem>
#include <string>

#include "core/random.h"
#include "core/terrain.h"
#include "picture/image.h"
#include "render/gl_context.h"
#include "render/terrain_view.h"

namespace erg::test {

inline constexpr int side = 96;          // cells
inline constexpr int ridge_period = 48;  // cells from crest to crest
inline constexpr int brink = 36;         // cells from the foot of the windward slope to the brink
inline constexpr int ridge_height = 24;  // slabs, so that the slip face falls two slabs a cell
inline constexpr double slab = 1.0 / 3;  // m

/// Two ridges across a west wind: windward slopes of 12.5 degrees with the roughness of whole slabs, slip faces of 33.7
/// degrees. Whole numbers only, so that it is the same everywhere.
inline Terrain ridges(int roughness = 1, Boundary boundary = Boundary::torus) {
  Terrain terrain({side, side}, 1.0, slab, boundary);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int along = x % ridge_period;
      const int smooth = along < brink ? ridge_height * along / brink : 2 * (ridge_period - along);
      const std::uint64_t bits = mix64(static_cast<std::uint64_t>(y) * side + static_cast<std::uint64_t>(x));
      const int rough = along < brink ? static_cast<int>(bits % 3) - 1 : 0;
      terrain.edit_mobile()(x, y) = std::max(0, smooth + roughness * rough);
    }
  }
  return terrain;
}

/// The ridges with bare ground in the south, a rock, and the fields "vegetation" and "age".
inline Terrain landscape() {
  Terrain terrain = ridges();
  const Field vegetation{{"vegetation", "vegetation", "", 0, 1, "vegetation", "share covered"},
                         Grid<float>({side, side})};
  const Field age{{"age", "age of the surface", "steps", 0, 100, "batlow", "steps since it moved"},
                  Grid<float>({side, side})};
  terrain.edit_fields() = {vegetation, age};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (y < 24) terrain.edit_mobile()(x, y) = 0;
      const bool rocky = x >= 8 && x < 26 && y >= 62 && y < 80;
      if (rocky) terrain.edit_bedrock()(x, y) = 36;
      if (rocky) terrain.edit_mobile()(x, y) = 0;
      terrain.edit_fields()[0].values(x, y) = y > 48 && x > 48 ? static_cast<float>(y - 48) / 48 : 0;
      terrain.edit_fields()[1].values(x, y) = static_cast<float>(x + y);
    }
  }
  return terrain;
}

inline render::TerrainView view_of(const Terrain& terrain) {
  render::TerrainView view;
  view.terrain = &terrain;
  view.wind = 270;
  return view;
}

/// The context that draws on the processor, whatever cards there are; without OSMesa, EGL.
inline const char* usual_context() { return render::has_osmesa() ? "osmesa" : "egl"; }

/// How far two pictures are apart, as an eye at some distance sees them: blocks of 4 x 4 pixels are averaged first.
struct Difference {
  double mean = 0;     ///< of 255, over all blocks and channels
  double largest = 0;  ///< of 255, of one block and channel
};
Difference difference(const picture::RgbImage& first, const picture::RgbImage& second);

/// Reads a PNG with 8 bits a channel. Throws std::runtime_error when it is not there.
picture::RgbImage read_picture(const std::filesystem::path& path);

}  // namespace erg::test
