// The terrain on the graphics card, as one sheet or several.
//
// Only cells are uploaded, and only those of tiles that changed; the smooth surface and the light are computed from
// them by the graphics card where they changed, and kept as long as nothing they depend on changes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/surface_range.h"
#include "render/camera.h"
#include "render/terrain_sheet.h"

namespace erg::render {

/// What a picture asks of the terrain.
struct TerrainRequest {
  const TerrainView& view;
  const Look& look;
  const RenderQuality& quality;
  const picture::Camera& camera;
  int picture_height = 1;  ///< pixels
};

/// Keeps the sheets of one terrain at a time, as many as its pictures need.
class TerrainMaps {
 public:
  explicit TerrainMaps(const std::filesystem::path& shaders);

  /// Brings everything up to date. Notes that a person should see are added to `notes`.
  void update(const TerrainRequest& request, std::vector<std::string>& notes);

  const std::vector<std::unique_ptr<TerrainSheet>>& sheets() const { return sheets_; }
  Extent cells() const { return extent_; }             ///< of the terrain
  double cell_side() const { return cell_side_; }      ///< m: of the finest that is drawn as one cell
  TerrainBox box() const { return box_; }              ///< m, exaggerated
  double bedrock_low() const { return bedrock_low_; }  ///< m: the lowest bedrock, not exaggerated
  bool has_plants() const;
  const ValueScale& scale() const { return scale_; }  ///< of the values shown

  /// Hands what all sheets share to a program in use.
  void bind(const ShaderProgram& program) const;
  /// The surface's height (m, exaggerated) at a place, for cameras and cursors; the nearest cell's.
  double height_at(double east, double north) const;

  /// Texels uploaded, and texels of the smooth surface computed, since the beginning.
  std::int64_t uploaded_texels() const;
  std::int64_t computed_texels() const;

 private:
  void read_view(const TerrainRequest& request, const std::string& shown);
  LightSource light_of(const TerrainRequest& request) const;

  SurfaceWorkshop workshop_;
  std::vector<std::unique_ptr<TerrainSheet>> sheets_;
  Extent extent_;
  double terrain_cell_ = 1;
  double cell_side_ = 1;
  double quantum_ = 1;
  bool periodic_ = true;
  double exaggeration_ = 1;
  SurfaceRange range_;
  double bedrock_low_ = 0;
  TerrainBox box_;
  std::uint64_t version_ = 0;
  std::string shown_;
  ValueScale scale_;
};

}  // namespace erg::render
