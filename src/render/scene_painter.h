// The order in which a picture is painted: what lies behind, the land, its cut faces, plants, lines.
#pragma once

#include <filesystem>

#include "render/land_maps.h"
#include "render/renderer.h"
#include "render/terrain_mesh.h"

namespace erg {

/// One painting.
struct PaintRequest {
  const TerrainView& view;
  const Look& look;
  const Camera& camera;
  const LandMaps& maps;
  const RenderEffort& effort;
  int width = 1;
  int height = 1;
};

class ScenePainter {
 public:
  explicit ScenePainter(const std::filesystem::path& shaders);
  /// Paints into the bound frame buffer.
  void paint(const PaintRequest& request);
  /// Triangles of the land in the last painting.
  std::int64_t triangles() const { return mesh_.triangles(); }

 private:
  struct Air;
  static Air make_air(const PaintRequest& request);
  void paint_background(const PaintRequest& request, const Air& air) const;
  void paint_land(const PaintRequest& request, const Air& air);
  void paint_walls(const PaintRequest& request, const Air& air) const;
  void paint_tufts(const PaintRequest& request, const Air& air) const;
  void paint_paths(const PaintRequest& request, const Air& air);

  ShaderProgram sky_program_;
  ShaderProgram land_program_;
  ShaderProgram wall_program_;
  ShaderProgram tuft_program_;
  ShaderProgram line_program_;
  TerrainMesh mesh_;
  GlObject no_vertices_;
  GlObject line_vertices_;
  GlObject line_buffer_;
};

}  // namespace erg
