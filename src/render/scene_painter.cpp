#include "render/scene_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/units.h"

namespace erg::render {

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
  return request.look.show == "snow" || (request.look.show == "material" && request.view.material == Material::snow);
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

// Sets what the terrain's program wants to know of the look.
void hand_over_look(const PaintRequest& request, const ShaderProgram& program) {
  const Look& look = request.look;
  const double toward = radians(request.view.wind.value_or(0) + 180);
  const bool windy = request.view.wind.has_value();
  program.set("wind", windy ? static_cast<float>(std::sin(toward)) : 0.0f,
              windy ? static_cast<float>(std::cos(toward)) : 0.0f);
  program.set("grain", look.grain);
  program.set("shading", static_cast<int>(look.shading));
  program.set("source", value_source(look));
  program.set("bedrock_low", request.maps.bedrock_low() * look.exaggeration);
  const ValueScale& scale = request.maps.scale();
  program.set("range", static_cast<float>(scale.low), static_cast<float>(scale.high));
  std::vector<float> colours;
  for (const picture::Colour& colour : scale.palette.points)
    colours.insert(colours.end(), {colour.red, colour.green, colour.blue});
  program.set_colours("palette", colours.data(), static_cast<int>(scale.palette.points.size()));
  program.set("palette_size", static_cast<int>(scale.palette.points.size()));
  program.set("contour_step", look.contours);
}

// Calls use(east, north) with the shift (m) of each copy of the terrain.
template <typename Use>
void for_copies(int rings, const TerrainBox& box, const Use& use) {
  for (int row = -rings; row <= rings; ++row) {
    for (int column = -rings; column <= rings; ++column) use(column * box.east, row * box.north);
  }
}

}  // namespace

ScenePainter::ScenePainter(const std::filesystem::path& shaders)
    : sky_program_(shaders, "pass.vert", "sky.frag"),
      backdrop_program_(shaders, "pass.vert", "sky.frag", {"BACKDROP"}),
      shaders_(shaders),
      wall_program_(shaders, "wall.vert", "wall.frag"),
      tuft_program_(shaders, "tuft.vert", "tuft.frag"),
      line_program_(shaders, "line.vert", "line.frag"),
      no_vertices_(GlObject::vertex_array()),
      tuft_vertices_(GlObject::vertex_array()),
      line_vertices_(GlObject::vertex_array()),
      line_buffer_(GlObject::buffer()) {}

ScenePainter::Air ScenePainter::make_air(const PaintRequest& request) {
  Air air;
  const TerrainBox box = request.maps.box();
  const double largest = std::max(box.east, box.north);
  const Eigen::Vector3d stands = eye(request.camera);
  // The edge of the copies, seen from the eye, is where the haze must have closed.
  const double rim = (copies_of(request) + 0.5) * largest + (stands - box.middle()).head<2>().norm();
  const double reach = (copies_of(request) + 1) * 2 * largest + (box.high - box.low);
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
  start_plain_drawing();
  gl11().DepthMask(GL_TRUE);
  gl11().ClearColor(0, 0, 0, 0);
  gl11().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl11().Enable(GL_DEPTH_TEST);
  gl11().DepthFunc(GL_LEQUAL);
  paint_terrain(request, air);
  if (copies_of(request) == 0) paint_walls(request, air);
  if (request.look.is_material() && request.look.tufts) paint_tufts(request, air);
  if (!request.view.trajectories.empty()) paint_paths(request, air);
  if (!request.look.transparent) paint_background(request, air);
  gl11().Disable(GL_DEPTH_TEST);
  glUseProgram(0);
}

// Only what is still free: it lies behind everything.
void ScenePainter::paint_background(const PaintRequest& request, const Air& air) const {
  const double half = std::tan(radians(0.5 * request.camera.opening));
  const double aspect = static_cast<double>(request.width) / request.height;
  const Eigen::Matrix3d axes = view_matrix(request.camera).block<3, 3>(0, 0);
  const Eigen::Vector3f right = (half * aspect * axes.row(0).transpose()).cast<float>();
  const Eigen::Vector3f up = (half * axes.row(1).transpose()).cast<float>();
  const Eigen::Vector3f ahead = (-axes.row(2).transpose()).cast<float>();
  const ShaderProgram& program = air.backdrop ? backdrop_program_ : sky_program_;
  program.use();
  air.hand_to(program);
  program.set("picture", static_cast<float>(request.width), static_cast<float>(request.height));
  program.set("right", right.x(), right.y(), right.z());
  program.set("up", up.x(), up.y(), up.z());
  program.set("ahead", ahead.x(), ahead.y(), ahead.z());
  if (air.snowy) {
    program.set("plain", 0.75f, 0.79f, 0.86f);
  } else {
    program.set("plain", 0.58f, 0.39f, 0.21f);
  }
  program.set("plain_height", request.maps.box().low);
  glBindVertexArray(no_vertices_.id());
  gl11().DrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

const ShaderProgram& ScenePainter::terrain_program(const PaintRequest& request, bool wires) {
  const Look& look = request.look;
  std::vector<std::string> words;
  const auto word = [&words](bool wanted, const char* name) {
    if (wanted) words.emplace_back(name);
  };
  word(wires, "WIRES");
  word(look.raw_cells, "RAW_CELLS");
  word(look.is_material(), "MATERIAL");
  word(look.is_material() && request.quality.grains && look.grain > 0, "GRAINS");
  word(look.is_material() && request.maps.has_plants(), "PLANTS");
  word(look.is_material() && request.maps.has_plants() && look.tufts, "TUFTS");
  word(look.contours > 0, "CONTOURS");
  const auto found = terrain_programs_.find(words);
  if (found != terrain_programs_.end()) return found->second;
  return terrain_programs_.emplace(words, ShaderProgram(shaders_, "terrain.vert", "terrain.frag", words)).first->second;
}

void ScenePainter::paint_terrain(const PaintRequest& request, const Air& air) {
  if (!request.look.wireframe) {
    draw_sheets(request, air, terrain_program(request, false));
    return;
  }
  gl11().Enable(GL_POLYGON_OFFSET_FILL);
  gl11().PolygonOffset(1, 1);
  draw_sheets(request, air, terrain_program(request, false));
  gl11().Disable(GL_POLYGON_OFFSET_FILL);
  gl11().PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  draw_sheets(request, air, terrain_program(request, true));
  gl11().PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void ScenePainter::draw_sheets(const PaintRequest& request, const Air& air, const ShaderProgram& program) {
  program.use();
  air.hand_to(program);
  request.maps.bind(program);
  hand_over_look(request, program);
  const Look& look = request.look;
  const TerrainBox box = request.maps.box();
  const int rings = copies_of(request);
  triangles_ = 0;
  for (const auto& sheet : request.maps.sheets()) {
    sheet->bind(program);
    const bool whole = sheet->place().whole;
    // A sheet among others lies a little over its neighbours, so that no gap opens between different details.
    const int overlap = whole ? 0 : 1;
    const Extent blocks{sheet->blocks().nx + overlap, sheet->blocks().ny + overlap};
    program.set("grid", static_cast<float>(blocks.nx), static_cast<float>(blocks.ny));
    // The mesh itself repeats a terrain of one sheet; others are repeated sheet by sheet.
    for_copies(whole ? 0 : rings, box, [&](double east, double north) {
      program.set("shift", static_cast<float>(east), static_cast<float>(north));
      mesh_.plan(
          {.cells = blocks,
           .cell_side = sheet->cell_side(),
           .corner = {sheet->corner()[0] + east, sheet->corner()[1] + north},
           .low = box.low,
           .high = box.high,
           .camera = request.camera,
           .view_projection = air.exact,
           .picture_height = request.height,
           .step_pixels = look.wireframe ? std::max(8.0, request.quality.step_pixels) : request.quality.step_pixels,
           .finest = look.raw_cells || look.wireframe ? TerrainMesh::tile_cells : request.quality.finest,
           .copies = whole ? rings : 0});
      mesh_.draw(program);
      triangles_ += mesh_.triangles();
    });
  }
}

void ScenePainter::paint_walls(const PaintRequest& request, const Air& air) const {
  const TerrainBox box = request.maps.box();
  const Extent cells = request.maps.cells();
  wall_program_.use();
  air.hand_to(wall_program_);
  request.maps.bind(wall_program_);
  wall_program_.set("floor_height", box.low - 0.03 * std::max(box.east, box.north));
  glBindVertexArray(no_vertices_.id());
  for (const auto& sheet : request.maps.sheets()) {
    sheet->bind(wall_program_);
    const SheetPlace& place = sheet->place();
    const double side = box.east / cells.nx;
    const Eigen::AlignedBox2d rim_box(
        Eigen::Vector2d(place.left * side, place.low * side),
        Eigen::Vector2d((place.left + place.cells.nx) * side, (place.low + place.cells.ny) * side));
    const auto face = [&](bool outer, Eigen::AlignedBox2d::CornerType from, Eigen::AlignedBox2d::CornerType to,
                          int blocks) {
      if (!outer) return;
      const int steps = std::max(1, blocks * request.quality.finest / TerrainMesh::tile_cells);  // as the mesh near by
      const Eigen::Vector2f start = rim_box.corner(from).cast<float>(), end = rim_box.corner(to).cast<float>();
      wall_program_.set("steps", steps);
      wall_program_.set("from", start.x(), start.y());
      wall_program_.set("to", end.x(), end.y());
      gl11().DrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (steps + 1));
    };
    using Box = Eigen::AlignedBox2d;
    const Extent blocks = sheet->blocks();
    face(place.low == 0, Box::BottomLeft, Box::BottomRight, blocks.nx);
    face(place.left + place.cells.nx == cells.nx, Box::BottomRight, Box::TopRight, blocks.ny);
    face(place.low + place.cells.ny == cells.ny, Box::TopRight, Box::TopLeft, blocks.nx);
    face(place.left == 0, Box::TopLeft, Box::BottomLeft, blocks.ny);
  }
  glBindVertexArray(0);
}

void ScenePainter::paint_tufts(const PaintRequest& request, const Air& air) const {
  constexpr int blades = 11;
  constexpr int most_a_cell = 6;
  int planted = 0;
  for (const auto& sheet : request.maps.sheets()) planted += sheet->planted_count();
  if (planted == 0) return;
  const int tufts_a_cell = std::clamp(request.quality.most_tufts / planted, 1, most_a_cell);
  // When even one for each cell is too much, only every so many cells have any.
  const int thinning = (planted * tufts_a_cell + request.quality.most_tufts - 1) / request.quality.most_tufts;
  tuft_program_.use();
  air.hand_to(tuft_program_);
  request.maps.bind(tuft_program_);
  tuft_program_.set("tufts_a_cell", tufts_a_cell);
  tuft_program_.set("blades", blades);
  glBindVertexArray(tuft_vertices_.id());
  glEnableVertexAttribArray(0);
  for (const auto& sheet : request.maps.sheets()) {
    const int cells = sheet->planted_count() / thinning;
    if (cells == 0) continue;
    sheet->bind(tuft_program_);
    glBindBuffer(GL_ARRAY_BUFFER, sheet->planted());
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, thinning * 2 * static_cast<GLsizei>(sizeof(float)), nullptr);
    glVertexAttribDivisor(0, static_cast<GLuint>(tufts_a_cell));
    for_copies(std::min(1, copies_of(request)), request.maps.box(), [&](double east, double north) {
      tuft_program_.set("shift", static_cast<float>(east), static_cast<float>(north));
      glDrawArraysInstanced(GL_TRIANGLES, 0, 3 * blades, cells * tufts_a_cell);
    });
  }
  glBindVertexArray(0);
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
  for (const Trajectory& path : request.view.trajectories) {
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(path.size() * sizeof(path[0])), path.data(), GL_STREAM_DRAW);
    gl11().DrawArrays(GL_LINE_STRIP, 0, static_cast<GLsizei>(path.size()));
  }
  glBindVertexArray(0);
}

}  // namespace erg::render
