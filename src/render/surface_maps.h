// The smooth surface made of cells, and the light that falls on it, computed by the graphics card. What changed in a
// part of the cells is computed anew only where that part reaches.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "render/quality.h"
#include "render/shader_program.h"
#include "render/textures.h"

namespace erg::render {

/// The programs that make maps, and the maps between cells and surface that are needed only while one is made; shared
/// by all sheets of a terrain.
struct SurfaceWorkshop {
  explicit SurfaceWorkshop(const std::filesystem::path& shaders);

  ShaderProgram rows, planes, smooth, raw, shape, light;
  GlObject no_vertices;
  MapTarget row_sums, fits, first_surface;
  /// What was read of the cells, until textures have it; kept, for fresh memory costs more than reading.
  std::vector<float> cells;
};

/// What the surface is made of.
struct SurfaceSource {
  const TiledTexture& cells;
  bool periodic = true;
  double cell_side = 1;  ///< m
  double quantum = 1;    ///< m: height of a slab, or what is left of it in the mean of a block
  bool raw = false;      ///< the cells as they are
  int block = 1;         ///< cells of the terrain, each way, in one of these
};

/// What the light comes from and falls on.
struct LightSource {
  double exaggeration = 1;
  double low = 0;                  ///< m: the lowest point of the terrain, exaggerated
  double high = 0;                 ///< m: the highest
  double sun_tangent = 1;          ///< of the sun's altitude
  std::array<float, 2> to_sun{};   ///< unit vector on the ground
  std::array<float, 2> to_wind{};  ///< unit vector to where the wind blows from; zero: none

  bool operator==(const LightSource&) const = default;
};

/// The smooth surface of one sheet and its light, in textures.
class SurfaceMaps {
 public:
  /// Brings the maps up to date. `changed`: the cells that are new since the last time.
  void update(SurfaceWorkshop& workshop, const SurfaceSource& source, const LightSource& light,
              const RenderQuality& quality, const std::vector<TexelRect>& changed);

  /// Height and thickness of the mobile layer, m.
  GLuint surface() const { return surface_.id(); }
  /// The same through splines, with the slopes to the east and north.
  GLuint shape() const { return shape_.id(); }
  /// What each point sees of sun, sky and wind: as light.frag writes it.
  GLuint light() const { return light_.id(); }
  Extent texels() const { return surface_.size(); }
  /// Texels of the surface computed since the beginning.
  std::int64_t computed_texels() const { return computed_texels_; }

 private:
  struct Smoothing;
  void compute_surface(SurfaceWorkshop& workshop, const SurfaceSource& source, const RenderQuality& quality,
                       const std::vector<TexelRect>& where);
  void smooth_into(SurfaceWorkshop& workshop, const SurfaceSource& source, const MapTarget& target, GLuint cells,
                   const Smoothing& smoothing, const std::vector<TexelRect>& where) const;
  void compute_light(SurfaceWorkshop& workshop, const SurfaceSource& source, const LightSource& light,
                     const RenderQuality& quality, const std::vector<TexelRect>& where);

  MapTarget surface_, shape_, light_;
  int detail_ = 0;  // texels of the surface for the side of a cell
  std::int64_t computed_texels_ = 0;
  std::vector<double> surface_key_;
  LightSource lit_by_;
  std::vector<double> light_key_;
};

}  // namespace erg::render
