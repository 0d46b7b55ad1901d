#include "analysis/bedforms.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace erg::analysis {
namespace {

/// Means over squares of three cells.
Grid<double> smoothed(const Terrain& terrain) {
  Grid<double> result(terrain.extent());
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      double sum = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          sum += terrain.height(wrap(x + dx, terrain.nx()), wrap(y + dy, terrain.ny()));
        }
      }
      result(x, y) = sum / 9;
    }
  }
  return result;
}

/// Share of the cells whose snow has all bonded.
double bare_crust(const Terrain& terrain) {
  const Field* bonded = find_field(terrain.fields(), "bonded");
  if (bonded == nullptr) return 0;
  std::int64_t bare = 0;
  for (std::size_t cell = 0; cell < terrain.extent().cells(); ++cell) {
    const auto hard = static_cast<std::int32_t>(bonded->values[cell]);
    if (hard > 0 && hard == terrain.mobile()[cell]) ++bare;
  }
  return static_cast<double>(bare) / static_cast<double>(terrain.extent().cells());
}

}  // namespace

BedformShape measure_bedforms(const Terrain& terrain, double bearing) {
  check_whole(terrain);
  const Grid<double> height = smoothed(terrain);
  const double east = -std::sin(radians(bearing));
  const double north = -std::cos(radians(bearing));
  double along2 = 0, across2 = 0, along3 = 0, sum = 0, sum2 = 0;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      const double slope_x = height.wrapped(x + 2, y) - height.wrapped(x - 2, y);
      const double slope_y = height.wrapped(x, y + 2) - height.wrapped(x, y - 2);
      const double along = slope_x * east + slope_y * north;
      const double across = slope_y * east - slope_x * north;
      along2 += along * along;
      across2 += across * across;
      along3 += along * along * along;
      sum += height(x, y);
      sum2 += height(x, y) * height(x, y);
    }
  }
  const auto cells = static_cast<double>(terrain.extent().cells());
  const double mean = sum / cells;
  BedformShape shape;
  if (along2 + across2 > 0) shape.across = across2 / (along2 + across2);
  if (along2 > 0) shape.skew = along3 / cells / std::pow(along2 / cells, 1.5);
  shape.relief = terrain.quantum() * std::sqrt(std::max(0.0, sum2 / cells - mean * mean));
  shape.crust = bare_crust(terrain);
  return shape;
}

std::string bedform_name(const BedformShape& shape) {
  if (shape.relief < least_relief) return "flat";
  if (shape.across < waves_across) return "waves";
  if (shape.across < streaks_across) return "rough";
  const bool carved = shape.crust >= least_sastrugi_crust && shape.skew >= least_sastrugi_skew;
  return carved && shape.relief >= least_sastrugi_relief ? "sastrugi" : "streaks";
}

}  // namespace erg::analysis
