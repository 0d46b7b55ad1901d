#include "render/terrain_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/units.h"

namespace erg::render {
namespace {

constexpr int coarsest = 2;  // steps for the side of a tile
constexpr GLuint restart = 0xffffffff;

// The lattice of all tiles, copies of the terrain included. Tiles that would reach over an edge of the terrain are cut
// there.
struct Lattice {
  Lattice(const MeshRequest& request)
      : across((request.cells.nx + TerrainMesh::tile_cells - 1) / TerrainMesh::tile_cells),
        up((request.cells.ny + TerrainMesh::tile_cells - 1) / TerrainMesh::tile_cells),
        copies(request.copies),
        steps({across * (2 * copies + 1), up * (2 * copies + 1)}) {}

  int across, up, copies;
  Grid<int> steps;  // a side, for each tile; 0: out of sight

  // South-west corner in cells.
  std::array<float, 2> origin(const MeshRequest& request, int column, int row) const {
    const auto corner = [&](int index, int tiles, int cells) {
      return static_cast<float>((index / tiles - copies) * cells + index % tiles * TerrainMesh::tile_cells);
    };
    return {corner(column, across, request.cells.nx), corner(row, up, request.cells.ny)};
  }
};

// The box around a tile, m.
Eigen::AlignedBox3d tile_box(const MeshRequest& request, const std::array<float, 2>& origin) {
  const double side = request.cell_side;
  const Eigen::Vector2d low = request.corner + side * Eigen::Vector2d(origin[0], origin[1]);
  const double tile = TerrainMesh::tile_cells * side;
  return {Eigen::Vector3d(low.x(), low.y(), request.low),
          Eigen::Vector3d(low.x() + tile, low.y() + tile, request.high)};
}

// Out of sight when all corners lie beyond the same side of the picture.
bool in_sight(const Eigen::AlignedBox3d& box, const Eigen::Matrix4d& view_projection) {
  std::array<int, 5> beyond{};
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    const Eigen::Vector4d clip = view_projection * point.homogeneous();
    beyond[0] += clip.x() < -clip.w();
    beyond[1] += clip.x() > clip.w();
    beyond[2] += clip.y() < -clip.w();
    beyond[3] += clip.y() > clip.w();
    beyond[4] += clip.z() < -clip.w();
  }
  return std::none_of(beyond.begin(), beyond.end(), [](int count) { return count == 8; });
}

// Steps a side so that a step is about as long in the picture as wanted.
int steps_for(const MeshRequest& request, const Eigen::AlignedBox3d& box) {
  double away = request.camera.distance;
  if (!request.camera.orthographic) away = std::max(1e-6, std::sqrt(box.squaredExteriorDistance(eye(request.camera))));
  const double pixels_a_metre = request.picture_height / (2 * away * std::tan(radians(0.5 * request.camera.opening)));
  const double side = std::max(box.sizes().x(), box.sizes().y()) * pixels_a_metre;
  int steps = coarsest;
  while (steps < request.finest && side / steps > request.step_pixels) steps *= 2;
  return steps;
}

Lattice choose_steps(const MeshRequest& request) {
  Lattice lattice(request);
  for (int row = 0; row < lattice.steps.ny(); ++row) {
    for (int column = 0; column < lattice.steps.nx(); ++column) {
      const Eigen::AlignedBox3d box = tile_box(request, lattice.origin(request, column, row));
      lattice.steps(column, row) = in_sight(box, request.view_projection) ? steps_for(request, box) : 0;
    }
  }
  return lattice;
}

}  // namespace

TerrainMesh::TerrainMesh() : vertices_(GlObject::vertex_array()), instances_(GlObject::buffer()) {}

void TerrainMesh::plan(const MeshRequest& request) {
  plan_.clear();
  triangles_ = 0;
  const Lattice lattice = choose_steps(request);
  for (int row = 0; row < lattice.steps.ny(); ++row) {
    for (int column = 0; column < lattice.steps.nx(); ++column) {
      const int own = lattice.steps(column, row);
      if (own == 0) continue;
      const auto stride = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= lattice.steps.nx() || y >= lattice.steps.ny()) return 1.0f;
        const int theirs = lattice.steps(x, y);
        return theirs > 0 && theirs < own ? static_cast<float>(own / theirs) : 1.0f;
      };
      plan_[own].push_back(
          {lattice.origin(request, column, row),
           {stride(column - 1, row), stride(column + 1, row), stride(column, row - 1), stride(column, row + 1)}});
      triangles_ += 2 * static_cast<std::int64_t>(own) * own;
    }
  }
}

const TerrainMesh::Strips& TerrainMesh::strips(int quads) const {
  Strips& made = strips_[quads];
  if (made.count > 0) return made;
  std::vector<GLuint> indices;
  const auto side = static_cast<GLuint>(quads + 1);
  for (GLuint row = 0; row + 1 < side; ++row) {
    for (GLuint column = 0; column < side; ++column) {
      indices.push_back((row + 1) * side + column);
      indices.push_back(row * side + column);
    }
    indices.push_back(restart);
  }
  made.indices = GlObject::buffer();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)), indices.data(),
               GL_STATIC_DRAW);
  made.count = static_cast<GLsizei>(indices.size());
  return made;
}

void TerrainMesh::draw(const ShaderProgram& program) const {
  glBindVertexArray(vertices_.id());
  gl11().Enable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(restart);
  program.set("tile_cells", static_cast<float>(tile_cells));
  for (const auto& [quads, tiles] : plan_) {
    const Strips& pattern = strips(quads);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, pattern.indices.id());
    glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(tiles.size() * sizeof(Instance)), tiles.data(),
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Instance), nullptr);
    glVertexAttribDivisor(0, 1);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                          reinterpret_cast<const void*>(offsetof(Instance, strides)));
    glVertexAttribDivisor(1, 1);
    program.set("quads", quads);
    glDrawElementsInstanced(GL_TRIANGLE_STRIP, pattern.count, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(tiles.size()));
  }
  gl11().Disable(GL_PRIMITIVE_RESTART);
  glBindVertexArray(0);
}

}  // namespace erg::render
