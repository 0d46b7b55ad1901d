// The order in which a picture is painted: what lies behind, the terrain, its cut faces, plants, lines.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "render/shader_program.h"
#include "render/terrain_maps.h"
#include "render/terrain_mesh.h"

namespace erg::render {

/// One painting.
struct PaintRequest {
  const TerrainView& view;
  const Look& look;
  const picture::Camera& camera;
  const TerrainMaps& maps;
  const RenderQuality& quality;
  int width = 1;
  int height = 1;
};

/// Holds the programs that paint; the maps come with each painting.
class ScenePainter {
 public:
  explicit ScenePainter(const std::filesystem::path& shaders);
  /// Paints into the bound frame buffer.
  void paint(const PaintRequest& request);
  /// Triangles of the terrain in the last painting.
  std::int64_t triangles() const { return triangles_; }

 private:
  struct Air;
  static Air make_air(const PaintRequest& request);
  void paint_background(const PaintRequest& request, const Air& air) const;
  void paint_terrain(const PaintRequest& request, const Air& air);
  const ShaderProgram& terrain_program(const PaintRequest& request, bool wires);
  void draw_sheets(const PaintRequest& request, const Air& air, const ShaderProgram& program);
  void paint_walls(const PaintRequest& request, const Air& air) const;
  void paint_tufts(const PaintRequest& request, const Air& air) const;
  void paint_paths(const PaintRequest& request, const Air& air);

  ShaderProgram sky_program_;
  ShaderProgram backdrop_program_;
  std::filesystem::path shaders_;
  std::map<std::vector<std::string>, ShaderProgram> terrain_programs_;  // by the words that they are made with
  ShaderProgram wall_program_;
  ShaderProgram tuft_program_;
  ShaderProgram line_program_;
  TerrainMesh mesh_;
  std::int64_t triangles_ = 0;
  GlObject no_vertices_;
  GlObject tuft_vertices_;
  GlObject line_vertices_;
  GlObject line_buffer_;
};

}  // namespace erg::render
