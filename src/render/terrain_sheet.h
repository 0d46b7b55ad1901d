// A sheet of the terrain on the graphics card: its cells, the smooth surface made of them, and the light that falls on
// it. A terrain that fits a texture is one sheet; a larger one is cut into several, each with an apron of what lies
// around it.
#pragma once

#include <vector>

#include "render/block_window.h"
#include "render/look.h"
#include "render/surface_maps.h"

namespace erg::render {

/// Where a sheet lies, in cells of the terrain.
struct SheetPlace {
  int left = 0;        ///< column of its south-west cell
  int low = 0;         ///< row of its south-west cell
  Extent cells;        ///< its own cells
  BlockWindow window;  ///< what its maps hold: the same in blocks, with the apron around
  bool whole = true;   ///< it is all there is
};

/// What a picture asks of the maps, besides the terrain.
struct MapsRequest {
  const TerrainView& view;
  const Field* field = nullptr;   ///< whose values are shown
  const Field* plants = nullptr;  ///< share of the ground that they cover
  bool raw_cells = false;
  LightSource light;
  const RenderQuality& quality;
};

/// Holds textures of the OpenGL context that is current.
class TerrainSheet {
 public:
  /// Brings the maps up to date. `read`: cells and fields may have changed. Notes that a person should see are added.
  void update(SurfaceWorkshop& workshop, const SheetPlace& place, const MapsRequest& request, bool read,
              std::vector<std::string>& notes);

  /// Hands the maps and their place to a program in use: the uniforms of sheet.glsl and surface.glsl, and the maps.
  void bind(const ShaderProgram& program) const;

  const SheetPlace& place() const { return place_; }
  double cell_side() const { return cell_side_; }  ///< m: of what is drawn as one cell
  Extent blocks() const;                           ///< columns and rows of it, without the apron
  std::array<double, 2> corner() const;            ///< m: south-west
  /// The blocks with plants, column and row: a buffer of two floats each.
  GLuint planted() const { return planted_.id(); }
  int planted_count() const { return has_plants_ ? planted_count_ : 0; }
  /// Height of the block that holds a cell of the terrain, m.
  double height_of(int column, int row) const;
  std::int64_t uploaded_texels() const;
  std::int64_t computed_texels() const { return maps_.computed_texels(); }

 private:
  void update_values(TiledTexture& texture, const Field& field, bool periodic, const char* role,
                     std::vector<std::string>& notes);
  void list_planted();

  SheetPlace place_;
  double cell_side_ = 1;
  bool raw_ = false;
  bool has_field_ = false;
  bool has_plants_ = false;
  TiledTexture cells_{2};
  TiledTexture field_{1};
  TiledTexture plants_{1};
  SurfaceMaps maps_;
  GlObject planted_;
  int planted_count_ = 0;
};

}  // namespace erg::render
