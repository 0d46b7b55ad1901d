#include "render/scene_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/units.h"

namespace erg {

// What all of a painting share: matrices, sun, haze.
struct ScenePainter::Air {
  Eigen::Matrix4f view_projection;
  Eigen::Matrix4d exact;
  std::array<float, 3> to_sun;
  std::array<float, 3> eye;
  double haze_depth = 0;
  bool snowy = false;
  bool backdrop = true;

  void hand_to(const ShaderProgram& program) const {
    program.set_matrix("view_projection", view_projection.data());
    program.set("to_sun", to_sun[0], to_sun[1], to_sun[2]);
    program.set("eye", eye[0], eye[1], eye[2]);
    program.set("haze_depth", haze_depth);
    program.set("snowy", static_cast<int>(snowy));
  }
};

namespace {

bool is_snowy(const PaintRequest& request) {
  return request.look.show == "snow" || (request.look.show == "material" && request.view.cover == Cover::snow);
}

// Rings of copies: as many as asked for, but no more tiles than can be chosen from at once.
int copies_of(const PaintRequest& request) {
  if (request.view.terrain->boundary() != Boundary::torus) return 0;
  constexpr double most_tiles = 30000;
  const Extent cells = request.maps.cells();
  const double tiles = std::ceil(static_cast<double>(cells.nx) / TerrainMesh::tile_cells) *
                       std::ceil(static_cast<double>(cells.ny) / TerrainMesh::tile_cells);
  const int most = std::max(1, static_cast<int>((std::sqrt(most_tiles / tiles) - 1) / 2));
  return std::min(request.look.copies, most);
}

int value_source(const Look& look) {
  return look.is_material() || look.show == "elevation" ? 0 : look.show == "slope" ? 1 : 2;
}

}  // namespace

ScenePainter::ScenePainter(const std::filesystem::path& shaders)
    : sky_program_(shaders, "pass.vert", "sky.frag"),
      land_program_(shaders, "terrain.vert", "terrain.frag"),
      wall_program_(shaders, "wall.vert", "wall.frag"),
      tuft_program_(shaders, "tuft.vert", "tuft.frag"),
      line_program_(shaders, "line.vert", "line.frag"),
      no_vertices_(GlObject::vertex_array()),
      line_vertices_(GlObject::vertex_array()),
      line_buffer_(GlObject::buffer()) {}

ScenePainter::Air ScenePainter::make_air(const PaintRequest& request) {
  Air air;
  const LandBox land = request.maps.land();
  const double largest = std::max(land.east, land.north);
  const Eigen::Vector3d stands = eye(request.camera);
  // The edge of the copies, seen from the eye, is where the haze must have closed.
  const double rim = (copies_of(request) + 0.5) * largest + (stands - land.middle()).head<2>().norm();
  const double reach = (copies_of(request) + 1) * 2 * largest + (land.high - land.low);
  air.exact = projection_matrix(request.camera, static_cast<double>(request.width) / request.height, reach) *
              view_matrix(request.camera);
  air.view_projection = air.exact.cast<float>();
  const double turn = radians(request.look.sun_bearing);
  const double rise = radians(request.look.sun_altitude);
  air.to_sun = {static_cast<float>(std::sin(turn) * std::cos(rise)),
                static_cast<float>(std::cos(turn) * std::cos(rise)), static_cast<float>(std::sin(rise))};
  air.eye = {static_cast<float>(stands.x()), static_cast<float>(stands.y()), static_cast<float>(stands.z())};
  air.backdrop = copies_of(request) == 0 || request.camera.orthographic;
  air.haze_depth = air.backdrop ? 0 : rim / 1.5;
  air.snowy = is_snowy(request);
  return air;
}

void ScenePainter::paint(const PaintRequest& request) {
  const Air air = make_air(request);
  mesh_.plan(
      {.cells = request.maps.cells(),
       .land = request.maps.land(),
       .camera = request.camera,
       .view_projection = air.exact,
       .picture_height = request.height,
       .step_pixels = request.look.wireframe ? std::max(8.0, request.effort.step_pixels) : request.effort.step_pixels,
       .finest = request.look.raw_cells || request.look.wireframe ? TerrainMesh::tile_cells : request.effort.finest,
       .copies = copies_of(request)});
  gl11().Disable(GL_BLEND);
  gl11().Disable(GL_CULL_FACE);
  gl11().Disable(GL_SCISSOR_TEST);
  gl11().DepthMask(GL_TRUE);
  gl11().ClearColor(0, 0, 0, 0);
  gl11().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!request.look.transparent) paint_background(request, air);
  gl11().Enable(GL_DEPTH_TEST);
  gl11().DepthFunc(GL_LEQUAL);
  paint_land(request, air);
  if (copies_of(request) == 0) paint_walls(request, air);
  if (request.look.is_material() && request.look.tufts && request.maps.has_plants()) paint_tufts(request, air);
  if (!request.view.paths.empty()) paint_paths(request, air);
  gl11().Disable(GL_DEPTH_TEST);
  glUseProgram(0);
}

void ScenePainter::paint_background(const PaintRequest& request, const Air& air) const {
  const double half = std::tan(radians(0.5 * request.camera.opening));
  const double aspect = static_cast<double>(request.width) / request.height;
  const Eigen::Matrix3d axes = view_matrix(request.camera).block<3, 3>(0, 0);
  const Eigen::Vector3f right = (half * aspect * axes.row(0).transpose()).cast<float>();
  const Eigen::Vector3f up = (half * axes.row(1).transpose()).cast<float>();
  const Eigen::Vector3f ahead = (-axes.row(2).transpose()).cast<float>();
  sky_program_.use();
  air.hand_to(sky_program_);
  sky_program_.set("picture", static_cast<float>(request.width), static_cast<float>(request.height));
  sky_program_.set("right", right.x(), right.y(), right.z());
  sky_program_.set("up", up.x(), up.y(), up.z());
  sky_program_.set("ahead", ahead.x(), ahead.y(), ahead.z());
  sky_program_.set("backdrop", static_cast<int>(air.backdrop));
  if (air.snowy) {
    sky_program_.set("plain", 0.75f, 0.79f, 0.86f);
  } else {
    sky_program_.set("plain", 0.58f, 0.39f, 0.21f);
  }
  sky_program_.set("plain_height", request.maps.land().low);
  gl11().Disable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.id());
  gl11().DrawArrays(GL_TRIANGLES, 0, 3);
}

void ScenePainter::paint_land(const PaintRequest& request, const Air& air) {
  const Look& look = request.look;
  const ShaderProgram& program = land_program_;
  program.use();
  air.hand_to(program);
  request.maps.bind(program);
  const double toward = radians(request.view.wind.value_or(0) + 180);
  const bool windy = request.view.wind.has_value();
  program.set("wind", windy ? static_cast<float>(std::sin(toward)) : 0.0f,
              windy ? static_cast<float>(std::cos(toward)) : 0.0f);
  program.set("grain", request.effort.grains ? look.grain : 0.0);
  program.set("material", static_cast<int>(look.is_material()));
  program.set("shading", static_cast<int>(look.shading));
  program.set("source", value_source(look));
  program.set("has_plants", static_cast<int>(request.maps.has_plants()));
  program.set("bedrock_low", request.maps.bedrock_low() * look.exaggeration);
  const ValueScale& scale = request.maps.scale();
  program.set("range", static_cast<float>(scale.low), static_cast<float>(scale.high));
  std::vector<float> colours;
  for (const Colour& colour : scale.palette.points)
    colours.insert(colours.end(), {colour.red, colour.green, colour.blue});
  program.set_colours("palette", colours.data(), static_cast<int>(scale.palette.points.size()));
  program.set("palette_size", static_cast<int>(scale.palette.points.size()));
  program.set("contour_step", look.contours);
  program.set("wires", 0);
  if (look.wireframe) {
    gl11().Enable(GL_POLYGON_OFFSET_FILL);
    gl11().PolygonOffset(1, 1);
  }
  mesh_.draw(program);
  gl11().Disable(GL_POLYGON_OFFSET_FILL);
  if (!look.wireframe) return;
  program.set("wires", 1);
  gl11().PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  mesh_.draw(program);
  gl11().PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void ScenePainter::paint_walls(const PaintRequest& request, const Air& air) const {
  const LandBox land = request.maps.land();
  const int steps = 2 * std::max(request.maps.cells().nx, request.maps.cells().ny);
  wall_program_.use();
  air.hand_to(wall_program_);
  request.maps.bind(wall_program_);
  wall_program_.set("steps", steps);
  wall_program_.set("floor_height", land.low - 0.03 * std::max(land.east, land.north));
  glBindVertexArray(no_vertices_.id());
  gl11().DrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (4 * steps + 1));
}

void ScenePainter::paint_tufts(const PaintRequest& request, const Air& air) const {
  constexpr int most_tufts = 1 << 20;
  constexpr int blades = 5;
  const auto cells = static_cast<int>(request.maps.cells().cells());
  const int tufts_a_cell = std::clamp(most_tufts / std::max(1, cells), 1, 6);
  tuft_program_.use();
  air.hand_to(tuft_program_);
  request.maps.bind(tuft_program_);
  tuft_program_.set("tufts_a_cell", tufts_a_cell);
  glBindVertexArray(no_vertices_.id());
  const int near_copies = std::min(1, copies_of(request));
  for (int row = -near_copies; row <= near_copies; ++row) {
    for (int column = -near_copies; column <= near_copies; ++column) {
      tuft_program_.set("shift", static_cast<float>(column * request.maps.land().east),
                        static_cast<float>(row * request.maps.land().north));
      glDrawArraysInstanced(GL_TRIANGLES, 0, 3 * blades, cells * tufts_a_cell);
    }
  }
}

void ScenePainter::paint_paths(const PaintRequest& request, const Air& air) {
  line_program_.use();
  air.hand_to(line_program_);
  line_program_.set("exaggeration", request.look.exaggeration);
  line_program_.set("lift", 0.05 * request.maps.cell_side());
  line_program_.set("line_colour", 0.72f, 0.16f, 0.10f);
  glBindVertexArray(line_vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, line_buffer_.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  for (const GrainPath& path : request.view.paths) {
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(path.size() * sizeof(path[0])), path.data(), GL_STREAM_DRAW);
    gl11().DrawArrays(GL_LINE_STRIP, 0, static_cast<GLsizei>(path.size()));
  }
  glBindVertexArray(0);
}

}  // namespace erg
