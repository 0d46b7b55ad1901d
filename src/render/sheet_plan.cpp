#include "render/sheet_plan.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace erg::render {
namespace {

constexpr int most_across = 8;    // sheets a side
constexpr int widest_apron = 64;  // blocks: as far as shadows are seen to come from
constexpr int least_apron = 20;   // blocks: as far as smoothing looks

SheetPlace whole_terrain(Extent extent, int largest) { return {0, 0, extent, whole_window(extent, largest), true}; }

// Pixels that a cell of the sheet has in the picture where it is nearest.
double pixels_a_cell(const SheetPlanRequest& request, const SheetPlace& place) {
  const double side = request.terrain.cell_size();
  const Eigen::Vector3d low(place.left * side, place.low * side, request.box.low);
  const Eigen::Vector3d high(low.x() + place.cells.nx * side, low.y() + place.cells.ny * side, request.box.high);
  double away = request.camera.distance;
  if (!request.camera.orthographic) {
    away = std::sqrt(Eigen::AlignedBox3d(low, high).squaredExteriorDistance(eye(request.camera)));
  }
  const double pixel =
      2 * std::max(away, side) * std::tan(radians(0.5 * request.camera.opening)) / request.picture_height;
  return side / pixel;
}

BlockWindow with_apron(const SheetPlace& place, int block, int apron) {
  const auto blocks = [&](int cells) { return (cells + block - 1) / block + 2 * apron; };
  return {
      place.left - apron * block, place.low - apron * block, {blocks(place.cells.nx), blocks(place.cells.ny)}, block};
}

// Sides of equal sheets along a side of the grid.
int sheet_side(int cells, int most) {
  const int wanted = std::max((cells + most_across - 1) / most_across, std::min(1024, most));
  const int side = std::min(wanted, most);
  const int sheets = (cells + side - 1) / side;
  return (cells + sheets - 1) / sheets;
}

std::vector<SheetPlace> cut(Extent extent, int most) {
  std::vector<SheetPlace> sheets;
  const int wide = sheet_side(extent.nx, most), high = sheet_side(extent.ny, most);
  for (int low = 0; low < extent.ny; low += high) {
    for (int left = 0; left < extent.nx; left += wide) {
      sheets.push_back({left, low, {std::min(wide, extent.nx - left), std::min(high, extent.ny - low)}, {}, false});
    }
  }
  return sheets;
}

}  // namespace

std::vector<SheetPlace> plan_sheets(const SheetPlanRequest& request) {
  const Extent extent = request.terrain.extent();
  const int largest = std::min(request.quality.largest_side, largest_texture());
  if (!request.quality.tiled || std::max(extent.nx, extent.ny) <= largest) return {whole_terrain(extent, largest)};
  const int apron = std::clamp(largest / 8, least_apron, widest_apron);
  std::vector<SheetPlace> sheets = cut(extent, largest - 2 * apron);
  const double most_blocks = static_cast<double>(largest) * largest;
  for (double block_pixels = 1;; block_pixels *= 1.5) {
    double blocks = 0;
    for (SheetPlace& sheet : sheets) {
      int block = 1;
      while (2 * block * pixels_a_cell(request, sheet) <= block_pixels) block *= 2;
      sheet.window = with_apron(sheet, block, apron);
      blocks += static_cast<double>(sheet.cells.cells()) / (static_cast<double>(block) * block);
    }
    const bool coarsest = std::all_of(sheets.begin(), sheets.end(), [](const SheetPlace& sheet) {
      return sheet.window.block >= std::max(sheet.cells.nx, sheet.cells.ny);
    });
    if (blocks <= most_blocks || coarsest) return sheets;
  }
}

}  // namespace erg::render
