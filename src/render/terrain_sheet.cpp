#include "render/terrain_sheet.h"

#include <algorithm>

namespace erg::render {

void TerrainSheet::update(SurfaceWorkshop& workshop, const SheetPlace& place, const MapsRequest& request, bool read,
                          std::vector<std::string>& notes) {
  const Terrain& terrain = *request.view.terrain;
  const bool torus = terrain.boundary() == Boundary::torus;
  const bool periodic = place.whole && torus;
  place_ = place;
  raw_ = request.raw_cells;
  cell_side_ = terrain.cell_size() * place.window.block;
  std::vector<TexelRect> changed;
  if (read) {
    read_terrain(terrain, place.window, workshop.cells);
    changed = cells_.update(place.window.blocks, periodic, workshop.cells);
    has_field_ = request.field != nullptr;
    if (has_field_) update_values(field_, *request.field, torus, "field", notes);
    has_plants_ = request.plants != nullptr;
    if (has_plants_) update_values(plants_, *request.plants, torus, "plants", notes);
    if (has_plants_) list_planted();
  }
  const SurfaceSource source{.cells = cells_,
                             .periodic = periodic,
                             .cell_side = cell_side_,
                             .quantum = terrain.quantum() / place.window.block,
                             .raw = raw_,
                             .block = place.window.block};
  maps_.update(workshop, source, request.light, request.quality, changed);
}

void TerrainSheet::update_values(TiledTexture& texture, const Field& field, bool periodic, const char* role,
                                 std::vector<std::string>& notes) {
  std::vector<float> values;
  const Extent extent = field.values.extent();
  const BlockWindow& window = place_.window;
  const bool fits =
      extent.cells() > 0 && extent.nx >= place_.left + place_.cells.nx && extent.ny >= place_.low + place_.cells.ny;
  if (!fits) {
    notes.push_back(std::string(role) + " \"" + field.info.key + "\" is empty or of another size than the grid");
    values.assign(window.blocks.cells(), missing_value);
  } else {
    const std::int64_t broken = read_values(field.values, periodic, window, values);
    if (broken > 0) {
      notes.push_back("field \"" + field.info.key + "\" has " + std::to_string(broken) +
                      " values that are no numbers; they are drawn in magenta");
    }
  }
  texture.update(window.blocks, place_.whole && periodic, values);
}

void TerrainSheet::list_planted() {
  std::vector<float> places;
  const Extent own = blocks();
  const int apron_x = (place_.left - place_.window.left) / place_.window.block;
  const int apron_y = (place_.low - place_.window.low) / place_.window.block;
  for (int row = 0; row < own.ny; ++row) {
    for (int column = 0; column < own.nx; ++column) {
      if (plants_.value(column + apron_x, row + apron_y) <= 0) continue;
      places.push_back(static_cast<float>(column));
      places.push_back(static_cast<float>(row));
    }
  }
  planted_count_ = static_cast<int>(places.size() / 2);
  if (!planted_) planted_ = GlObject::buffer();
  glBindBuffer(GL_ARRAY_BUFFER, planted_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(float)), places.data(), GL_STATIC_DRAW);
}

Extent TerrainSheet::blocks() const {
  const int block = place_.window.block;
  return {(place_.cells.nx + block - 1) / block, (place_.cells.ny + block - 1) / block};
}

std::array<double, 2> TerrainSheet::corner() const {
  const double side = cell_side_ / place_.window.block;
  return {place_.left * side, place_.low * side};
}

void TerrainSheet::bind(const ShaderProgram& program) const {
  program.set_texture("shape", 4, maps_.shape());
  program.set_texture("plants", 3, has_plants_ ? plants_.id() : 0);
  program.set_texture("field", 2, has_field_ ? field_.id() : 0);
  program.set_texture("light", 1, maps_.light());
  program.set_texture("surface", 0, maps_.surface());
  const BlockWindow& window = place_.window;
  const double side = cell_side_ / window.block;
  program.set("surface_texels", static_cast<float>(maps_.texels().nx), static_cast<float>(maps_.texels().ny));
  program.set("sheet_low", static_cast<float>(window.left * side), static_cast<float>(window.low * side));
  program.set("sheet_size", static_cast<float>(window.blocks.nx * cell_side_),
              static_cast<float>(window.blocks.ny * cell_side_));
  program.set("corner", static_cast<float>(corner()[0]), static_cast<float>(corner()[1]));
  program.set("raw_cells", static_cast<int>(raw_));
  program.set("cell_side", cell_side_);
}

double TerrainSheet::height_of(int column, int row) const {
  const BlockWindow& window = place_.window;
  return cells_.value((column - window.left) / window.block, (row - window.low) / window.block);
}

std::int64_t TerrainSheet::uploaded_texels() const {
  return cells_.uploaded_texels() + field_.uploaded_texels() + plants_.uploaded_texels();
}

}  // namespace erg::render
