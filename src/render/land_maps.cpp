#include "render/land_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/units.h"

namespace erg {
namespace {

// Stands in the texture for a value that is not a number; shaders know it too.
constexpr float missing = -1e38f;
constexpr const char* plants_key = "vegetation";

// How many cells a side become one, so that no side is longer than `largest`.
int block_for(Extent extent, int largest) { return (std::max(extent.nx, extent.ny) + largest - 1) / largest; }

Extent blocks_of(Extent extent, int block) {
  return {(extent.nx + block - 1) / block, (extent.ny + block - 1) / block};
}

// Calls use(cell) for each cell of a block and returns how many there were.
template <typename Use>
int for_block(Extent extent, int column, int row, int block, const Use& use) {
  int count = 0;
  for (int y = row * block; y < std::min(extent.ny, (row + 1) * block); ++y) {
    for (int x = column * block; x < std::min(extent.nx, (column + 1) * block); ++x, ++count) use(x, y);
  }
  return count;
}

std::array<float, 2> on_ground(double bearing) {
  return {static_cast<float>(std::sin(radians(bearing))), static_cast<float>(std::cos(radians(bearing)))};
}

}  // namespace

LandMaps::LandMaps(const std::filesystem::path& shaders)
    : planes_program_(shaders, "pass.vert", "planes.frag"),
      smooth_program_(shaders, "pass.vert", "smooth.frag"),
      raw_program_(shaders, "pass.vert", "raw.frag"),
      light_program_(shaders, "pass.vert", "light.frag"),
      no_vertices_(GlObject::vertex_array()) {}

void LandMaps::update(const TerrainView& view, const Look& look, const RenderLimits& limits,
                      std::vector<std::string>& notes) {
  const Terrain& terrain = *view.terrain;
  const int block = block_for(terrain.extent(), std::min(limits.largest_side, largest_texture()));
  const std::vector<double> view_key{static_cast<double>(view.version), static_cast<double>(block)};
  const std::string shown = look.show + "/" + look.palette;
  const bool same = view.version != 0 && view_key == view_key_ && shown == shown_;
  periodic_ = terrain.boundary() == Boundary::torus;
  bool changed = false;
  if (!same) {
    if (block > 1)
      notes.push_back("the grid is drawn in means of " + std::to_string(block) + " x " + std::to_string(block) +
                      " cells");
    read_terrain(terrain, block);
    changed = cells_.update(blocks_of(terrain.extent(), block), periodic_, cell_values_);
    const Field* field = look.is_material() ? nullptr : view.find_field(look.show);
    has_field_ = field != nullptr && update_values(field_, *field, block, "field", notes);
    const Field* plants = view.find_field(plants_key);
    has_plants_ = plants != nullptr && update_values(plants_, *plants, block, "plants", notes);
    view_key_ = view_key;
    scale_ = value_scale(look, view);
    shown_ = shown;
  }
  land_.low *= look.exaggeration / exaggeration_;
  land_.high *= look.exaggeration / exaggeration_;
  exaggeration_ = look.exaggeration;
  const std::vector<double> surface_key{look.raw_cells ? 1.0 : 0.0, static_cast<double>(limits.largest_map), quantum_,
                                        cell_side_};
  raw_ = look.raw_cells;
  if (changed || surface_key != surface_key_) {
    compute_surface(limits);
    surface_key_ = surface_key;
    light_key_.clear();
  }
  compute_light(look, view);
}

void LandMaps::read_terrain(const Terrain& terrain, int block) {
  const Extent small = blocks_of(terrain.extent(), block);
  cell_values_.resize(2 * small.cells());
  cell_side_ = terrain.cell_size() * block;
  quantum_ = terrain.quantum() / block;
  double low = std::numeric_limits<double>::infinity(), high = -low, bedrock_low = low;
  std::size_t at = 0;
  for (int row = 0; row < small.ny; ++row) {
    for (int column = 0; column < small.nx; ++column) {
      double bedrock = 0, mobile = 0;
      const int count = for_block(terrain.extent(), column, row, block, [&](int x, int y) {
        bedrock += terrain.bedrock()(x, y);
        mobile += terrain.mobile()(x, y);
      });
      bedrock *= terrain.quantum() / count;
      mobile *= terrain.quantum() / count;
      low = std::min(low, bedrock + mobile);
      high = std::max(high, bedrock + mobile);
      bedrock_low = std::min(bedrock_low, bedrock);
      cell_values_[at++] = static_cast<float>(bedrock + mobile);
      cell_values_[at++] = static_cast<float>(mobile);
    }
  }
  bedrock_low_ = bedrock_low;
  land_ = {small.nx * cell_side_, small.ny * cell_side_, low * exaggeration_, high * exaggeration_};
}

bool LandMaps::update_values(TiledTexture& texture, const Field& field, int block, const char* role,
                             std::vector<std::string>& notes) {
  const Extent extent = field.values.extent();
  const Extent small = blocks_of(extent, block);
  if (extent.cells() == 0 || small != cells_.extent()) {
    notes.push_back(std::string(role) + " \"" + field.info.key + "\" is empty or of another size than the grid");
    const std::vector<float> nothing(cells_.extent().cells(), missing);
    texture.update(cells_.extent(), periodic_, nothing);
    return true;
  }
  field_values_.resize(small.cells());
  std::int64_t broken = 0;
  std::size_t at = 0;
  for (int row = 0; row < small.ny; ++row) {
    for (int column = 0; column < small.nx; ++column) {
      double sum = 0;
      const int count = for_block(extent, column, row, block, [&](int x, int y) { sum += field.values(x, y); });
      const bool good = std::isfinite(sum);
      if (!good) ++broken;
      field_values_[at++] = good ? static_cast<float>(sum / count) : missing;
    }
  }
  if (broken > 0) {
    notes.push_back("field \"" + field.info.key + "\" has " + std::to_string(broken) +
                    " values that are no numbers; they are drawn in magenta");
  }
  texture.update(small, periodic_, field_values_);
  return true;
}

void LandMaps::run_pass(const ShaderProgram& program, const MapTarget& target) const {
  program.set("cells", 0);
  program.set("extent", cells_.extent().nx, cells_.extent().ny);
  program.set("periodic", static_cast<int>(periodic_));
  target.bind();
  gl11().Disable(GL_DEPTH_TEST);
  gl11().Disable(GL_BLEND);
  gl11().PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glBindVertexArray(no_vertices_.id());
  gl11().DrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void LandMaps::compute_surface(const RenderLimits& limits) {
  const Extent cells = cells_.extent();
  if (raw_) {
    surface_.prepare(cells, GL_RG32F, periodic_);
    raw_program_.use();
    raw_program_.set_texture("cells", 0, cells_.id());
    run_pass(raw_program_, surface_);
    return;
  }
  const int detail = 2 * std::max(cells.nx, cells.ny) <= std::min(limits.largest_map, largest_texture()) ? 2 : 1;
  // Twice: first the single slabs go, then, on what is left, the bumps of a few cells that they made.
  first_surface_.prepare(cells, GL_RG32F, periodic_);
  smooth_into(first_surface_, 1, cells_.id(),
              {.plane_reach = 3, .reach = 3, .spread = 1.5, .noise = 0.4, .tolerance = 0.8});
  surface_.prepare({cells.nx * detail, cells.ny * detail}, GL_RG32F, periodic_);
  smooth_into(surface_, detail, first_surface_.id(),
              {.plane_reach = 5, .reach = 4, .spread = 2.2, .noise = 0.12, .tolerance = 0.3});
}

void LandMaps::smooth_into(const MapTarget& target, int detail, GLuint cells, const Smoothing& smoothing) {
  planes_.prepare(cells_.extent(), GL_RGBA32F, periodic_);
  planes_program_.use();
  planes_program_.set("reach", smoothing.plane_reach);
  planes_program_.set_texture("cells", 0, cells);
  run_pass(planes_program_, planes_);
  smooth_program_.use();
  smooth_program_.set("detail", detail);
  smooth_program_.set("reach", smoothing.reach);
  smooth_program_.set("spread", smoothing.spread);
  // Where slabs are thin there is little to smooth away; the ground itself is not smoother than a share of a cell.
  smooth_program_.set("noise", std::max(smoothing.noise * quantum_, 0.005 * cell_side_));
  smooth_program_.set("tolerance", std::max(smoothing.tolerance * quantum_, 0.03 * cell_side_));
  smooth_program_.set_texture("planes", 1, planes_.id());
  smooth_program_.set_texture("cells", 0, cells);
  run_pass(smooth_program_, target);
}

void LandMaps::compute_light(const Look& look, const TerrainView& view) {
  const double wind = view.wind.value_or(1000);  // no bearing is that large
  const std::vector<double> key{look.sun_bearing,
                                look.sun_altitude,
                                look.exaggeration,
                                wind,
                                static_cast<double>(surface_.size().nx),
                                static_cast<double>(surface_.size().ny)};
  if (key == light_key_) return;
  light_key_ = key;
  light_.prepare(surface_.size(), GL_RGBA16F, periodic_);
  light_program_.use();
  const double texel = land_.east / surface_.size().nx;
  const std::array<float, 2> to_sun = on_ground(look.sun_bearing);
  const std::array<float, 2> to_wind = view.wind ? on_ground(*view.wind) : std::array<float, 2>{};
  light_program_.set("texel", 1.0f / static_cast<float>(surface_.size().nx),
                     1.0f / static_cast<float>(surface_.size().ny));
  light_program_.set("step_length", texel);
  light_program_.set("exaggeration", look.exaggeration);
  light_program_.set("highest", land_.high);
  light_program_.set("sun_rise", 0.8 * std::tan(radians(std::min(look.sun_altitude, 89.0))));
  light_program_.set("to_sun", to_sun[0], to_sun[1]);
  light_program_.set("to_wind", to_wind[0], to_wind[1]);
  light_program_.set("most_steps", 110.0f);
  light_program_.set_texture("surface", 0, surface_.id());
  run_pass(light_program_, light_);
}

void LandMaps::bind(const ShaderProgram& program) const {
  program.set_texture("plants", 3, has_plants_ ? plants_.id() : 0);
  program.set_texture("field", 2, has_field_ ? field_.id() : 0);
  program.set_texture("light", 1, light_.id());
  program.set_texture("surface", 0, surface_.id());
  program.set("surface_texels", static_cast<float>(surface_.size().nx), static_cast<float>(surface_.size().ny));
  program.set("land", static_cast<float>(land_.east), static_cast<float>(land_.north));
  program.set("grid", static_cast<float>(cells().nx), static_cast<float>(cells().ny));
  program.set("exaggeration", exaggeration_);
  program.set("raw_cells", static_cast<int>(raw_));
  program.set("cell_side", cell_side_);
}

double LandMaps::height_at(double east, double north) const {
  const Extent extent = cells();
  if (extent.cells() == 0) return 0;
  const auto index = [this](double metres, int count) {
    const int cell = static_cast<int>(std::floor(metres / cell_side_));
    return periodic_ ? wrap(cell, count) : std::clamp(cell, 0, count - 1);
  };
  const auto column = static_cast<std::size_t>(index(east, extent.nx));
  const auto row = static_cast<std::size_t>(index(north, extent.ny));
  return exaggeration_ * cell_values_[2 * (row * static_cast<std::size_t>(extent.nx) + column)];
}

std::int64_t LandMaps::uploaded_texels() const {
  return cells_.uploaded_texels() + field_.uploaded_texels() + plants_.uploaded_texels();
}

}  // namespace erg
