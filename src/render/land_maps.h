// The land on the graphics card: its cells, the smooth surface made of them, and the light that falls on it.
//
// Only cells are uploaded, and only those of tiles that changed; the smooth surface and the light are computed from
// them by the graphics card, and kept as long as nothing they depend on changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/look.h"
#include "render/shader_program.h"
#include "render/textures.h"

namespace erg {

/// Limits that suit what draws.
struct RenderLimits {
  int largest_side = 4096;  ///< cells a side that are drawn; larger grids are drawn in means of blocks of cells
  int largest_map = 4096;   ///< texels a side of the smooth surface, which has up to 2 texels a cell side
};

class LandMaps {
 public:
  explicit LandMaps(const std::filesystem::path& shaders);

  /// Brings everything up to date with view and look. Notes that a person should see are added to `notes`.
  void update(const TerrainView& view, const Look& look, const RenderLimits& limits, std::vector<std::string>& notes);

  /// Cells that are drawn: those of the terrain, or fewer and larger ones.
  Extent cells() const { return cells_.extent(); }
  double cell_side() const { return cell_side_; }      ///< m
  LandBox land() const { return land_; }               ///< m, exaggerated
  double bedrock_low() const { return bedrock_low_; }  ///< m: the lowest bedrock, not exaggerated
  const ValueScale& scale() const { return scale_; }   ///< of the values shown
  bool has_plants() const { return has_plants_; }

  /// Hands the maps and their sizes to a program in use (the uniforms of surface.glsl and the maps of terrain.frag).
  void bind(const ShaderProgram& program) const;
  /// The surface's height (m, exaggerated) at a place, for cameras and cursors; the nearest cell's.
  double height_at(double east, double north) const;

  std::int64_t uploaded_texels() const;

 private:
  void read_terrain(const Terrain& terrain, int block);
  bool update_values(TiledTexture& texture, const Field& field, int block, const char* role,
                     std::vector<std::string>& notes);
  // One smoothing: the radius of the planes, how far they are asked and count (cells), and the misfit and distance that
  // they may have (slabs).
  struct Smoothing {
    int plane_reach, reach;
    double spread, noise, tolerance;
  };
  void smooth_into(const MapTarget& target, int detail, GLuint cells, const Smoothing& smoothing);
  void compute_surface(const RenderLimits& limits);
  void compute_light(const Look& look, const TerrainView& view);
  void run_pass(const ShaderProgram& program, const MapTarget& target) const;

  ShaderProgram planes_program_;
  ShaderProgram smooth_program_;
  ShaderProgram raw_program_;
  ShaderProgram light_program_;
  GlObject no_vertices_;

  TiledTexture cells_{2};
  TiledTexture field_{1};
  TiledTexture plants_{1};
  MapTarget planes_;
  MapTarget first_surface_;
  MapTarget surface_;
  MapTarget light_;

  std::vector<float> cell_values_;
  std::vector<float> field_values_;
  double cell_side_ = 1;
  double quantum_ = 1;
  bool periodic_ = true;
  bool raw_ = false;
  bool has_field_ = false;
  bool has_plants_ = false;
  double exaggeration_ = 1;
  double bedrock_low_ = 0;
  LandBox land_;
  std::vector<double> light_key_;
  std::vector<double> surface_key_;
  std::vector<double> view_key_;
  std::string shown_;
  ValueScale scale_;
};

}  // namespace erg
