// The terrain as tiles of triangle strips, finer near the eye. The strips hold no heights: they count steps, and the
// vertex shader fetches the height of each.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/grid.h"
#include "render/camera.h"
#include "render/gl.h"
#include "render/shader_program.h"

namespace erg::render {

/// What decides how finely each tile is drawn.
struct MeshRequest {
  Extent cells;                     ///< of the sheet, without its apron
  double cell_side = 1;             ///< m
  Eigen::Vector2d corner = {0, 0};  ///< m: of its south-west, in the copy of the terrain that is drawn
  double low = 0;                   ///< m: of the terrain
  double high = 1;                  ///< m: of the terrain
  picture::Camera camera;
  Eigen::Matrix4d view_projection;
  int picture_height = 1;  ///< pixels
  double step_pixels = 2;  ///< wanted length of a step in the picture
  int finest = 256;        ///< most steps for the side of a tile, at most 256
  int copies = 0;          ///< rings of copies around the sheet, when it is the whole terrain
};

/// The tiles of one terrain, planned for one picture at a time.
class TerrainMesh {
 public:
  static constexpr int tile_cells = 64;

  TerrainMesh();
  /// Chooses tiles and their detail.
  void plan(const MeshRequest& request);
  /// Draws the planned tiles; `program` is in use.
  void draw(const ShaderProgram& program) const;
  /// Triangles that a drawing has.
  std::int64_t triangles() const { return triangles_; }

 private:
  // A tile to draw: its corner in cells, and by how many of its own steps it is tied to its neighbours.
  struct Instance {
    std::array<float, 2> origin;
    std::array<float, 4> strides;
  };
  struct Strips {
    GlObject indices;
    GLsizei count = 0;
  };
  const Strips& strips(int quads) const;

  GlObject vertices_;
  GlObject instances_;
  std::map<int, std::vector<Instance>> plan_;  // by steps a side
  mutable std::map<int, Strips> strips_;
  std::int64_t triangles_ = 0;
};

}  // namespace erg::render
