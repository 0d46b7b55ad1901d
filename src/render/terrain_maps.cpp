#include "render/terrain_maps.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "render/sheet_plan.h"

namespace erg::render {
namespace {

constexpr const char* plants_key = "vegetation";

std::array<float, 2> on_ground(double bearing) {
  return {static_cast<float>(std::sin(radians(bearing))), static_cast<float>(std::cos(radians(bearing)))};
}

}  // namespace

TerrainMaps::TerrainMaps(const std::filesystem::path& shaders) : workshop_(shaders) {}

void TerrainMaps::update(const TerrainRequest& request, std::vector<std::string>& notes) {
  const TerrainView& view = request.view;
  const Look& look = request.look;
  const std::string shown = look.show + "/" + look.palette;
  const bool read = view.version == 0 || view.version != version_ || shown != shown_;
  exaggeration_ = look.exaggeration;
  if (read) read_view(request, shown);
  box_.low = view.terrain->metres(range_.low) * exaggeration_;
  box_.high = view.terrain->metres(range_.high) * exaggeration_;
  const std::vector<SheetPlace> plan =
      plan_sheets({*view.terrain, request.quality, request.camera, box_, request.picture_height});
  if (plan.size() < sheets_.size()) sheets_.resize(plan.size());
  while (sheets_.size() < plan.size()) sheets_.push_back(std::make_unique<TerrainSheet>());
  if (read && plan.front().whole && plan.front().window.block > 1) {
    const std::string block = std::to_string(plan.front().window.block);
    notes.push_back("the grid is drawn in means of " + block + " x " + block + " cells");
  }
  const MapsRequest maps{.view = view,
                         .field = look.is_material() ? nullptr : view.find_field(look.show),
                         .plants = view.find_field(plants_key),
                         .raw_cells = look.raw_cells,
                         .light = light_of(request),
                         .quality = request.quality};
  cell_side_ = box_.east;
  for (std::size_t sheet = 0; sheet < plan.size(); ++sheet) {
    const bool moved = !(sheets_[sheet]->place().window == plan[sheet].window);
    sheets_[sheet]->update(workshop_, plan[sheet], maps, read || moved, notes);
    cell_side_ = std::min(cell_side_, sheets_[sheet]->cell_side());
  }
}

void TerrainMaps::read_view(const TerrainRequest& request, const std::string& shown) {
  const Terrain& terrain = *request.view.terrain;
  extent_ = terrain.extent();
  terrain_cell_ = terrain.cell_size();
  quantum_ = terrain.quantum();
  periodic_ = terrain.boundary() == Boundary::torus;
  range_ = surface_range(terrain);
  bedrock_low_ = terrain.metres(lowest_bedrock(terrain));
  box_.east = extent_.nx * terrain_cell_;
  box_.north = extent_.ny * terrain_cell_;
  if (!request.look.is_material()) scale_ = value_scale(request.look, request.view);
  version_ = request.view.version;
  shown_ = shown;
}

LightSource TerrainMaps::light_of(const TerrainRequest& request) const {
  LightSource light;
  light.exaggeration = exaggeration_;
  // In large steps, so that a dune that grows by a slab does not change the light of the whole terrain.
  const double step = 32 * quantum_ * exaggeration_;
  light.low = step * std::floor(box_.low / step);
  light.high = step * std::ceil(box_.high / step);
  light.sun_tangent = std::tan(radians(std::min(request.look.sun_altitude, 89.0)));
  light.to_sun = on_ground(request.look.sun_bearing);
  if (request.view.wind) light.to_wind = on_ground(*request.view.wind);
  return light;
}

void TerrainMaps::bind(const ShaderProgram& program) const {
  program.set("terrain", static_cast<float>(box_.east), static_cast<float>(box_.north));
  program.set("exaggeration", exaggeration_);
}

double TerrainMaps::height_at(double east, double north) const {
  if (extent_.cells() == 0) return 0;
  const auto index = [this](double metres, int count) {
    const int cell = static_cast<int>(std::floor(metres / terrain_cell_));
    return periodic_ ? wrap(cell, count) : std::clamp(cell, 0, count - 1);
  };
  const int column = index(east, extent_.nx);
  const int row = index(north, extent_.ny);
  for (const auto& sheet : sheets_) {
    const SheetPlace& place = sheet->place();
    if (column < place.left || row < place.low) continue;
    if (column >= place.left + place.cells.nx || row >= place.low + place.cells.ny) continue;
    return exaggeration_ * sheet->height_of(column, row);
  }
  return 0;
}

bool TerrainMaps::has_plants() const {
  return std::any_of(sheets_.begin(), sheets_.end(), [](const auto& sheet) { return sheet->planted_count() > 0; });
}

std::int64_t TerrainMaps::uploaded_texels() const {
  std::int64_t sum = 0;
  for (const auto& sheet : sheets_) sum += sheet->uploaded_texels();
  return sum;
}

std::int64_t TerrainMaps::computed_texels() const {
  std::int64_t sum = 0;
  for (const auto& sheet : sheets_) sum += sheet->computed_texels();
  return sum;
}

}  // namespace erg::render
