#include "analysis/dune_patches.h"

#include <cmath>

#include "core/units.h"

namespace erg {
namespace {

/// A cell of the endless plane that the torus tiles.
struct Place {
  int x = 0;
  int y = 0;
  bool operator==(const Place&) const = default;
};

/// Follows one patch after the other over the torus.
class Patches {
 public:
  Patches(const Terrain& terrain, int least)
      : thickness_(terrain.mobile()), least_(least), seen_(terrain.extent()), places_(terrain.extent()) {}

  bool starts_patch(int x, int y) const { return thickness_(x, y) >= least_ && !seen_(x, y); }

  /// The patch around (x, y), without jumps at the torus' edge; empty where it meets itself around the torus.
  std::vector<Place> follow(int x, int y) {
    std::vector<Place> patch;
    bool endless = false;
    visit({x, y}, patch, endless);
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const Place at = patch[next];
      for (const Place beside : {Place{at.x + 1, at.y}, {at.x - 1, at.y}, {at.x, at.y + 1}, {at.x, at.y - 1}}) {
        visit(beside, patch, endless);
      }
    }
    if (endless) patch.clear();
    return patch;
  }

 private:
  void visit(Place place, std::vector<Place>& patch, bool& endless) {
    const int x = wrap(place.x, thickness_.nx());
    const int y = wrap(place.y, thickness_.ny());
    if (thickness_(x, y) < least_) return;
    if (seen_(x, y)) {
      endless = endless || places_(x, y) != place;
      return;
    }
    seen_(x, y) = 1;
    places_(x, y) = place;
    patch.push_back(place);
  }

  const Grid<std::int32_t>& thickness_;
  int least_;
  Grid<std::uint8_t> seen_;
  Grid<Place> places_;
};

DunePatch measure_patch(const std::vector<Place>& cells, double bearing) {
  const double east = -std::sin(radians(bearing));
  const double north = -std::cos(radians(bearing));
  const auto count = static_cast<double>(cells.size());
  double middle_x = 0, middle_y = 0;
  for (const Place& cell : cells) {
    middle_x += cell.x / count;
    middle_y += cell.y / count;
  }
  double along2 = 0, across2 = 0, bent = 0;
  for (const Place& cell : cells) {
    const double along = (cell.x - middle_x) * east + (cell.y - middle_y) * north;
    const double across = (cell.y - middle_y) * east - (cell.x - middle_x) * north;
    along2 += along * along / count;
    across2 += across * across / count;
    bent += along * across * across / count;
  }
  DunePatch patch;
  patch.cells = static_cast<std::int64_t>(cells.size());
  // The axis of an evenly filled ellipse is four standard deviations long.
  patch.length = 4 * std::sqrt(along2);
  patch.width = 4 * std::sqrt(across2);
  if (along2 > 0 && across2 > 0) patch.arms = bent / (std::sqrt(along2) * across2);
  return patch;
}

}  // namespace

std::vector<DunePatch> find_dunes(const Terrain& terrain, double bearing, int least, std::int64_t smallest) {
  check_whole(terrain);
  Patches patches(terrain, least);
  std::vector<DunePatch> dunes;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      if (!patches.starts_patch(x, y)) continue;
      const std::vector<Place> cells = patches.follow(x, y);
      if (cells.empty() || static_cast<std::int64_t>(cells.size()) < smallest) continue;
      dunes.push_back(measure_patch(cells, bearing));
    }
  }
  return dunes;
}

DuneMeans mean_of_dunes(const std::vector<DunePatch>& dunes) {
  DuneMeans means;
  double cells = 0;
  for (const DunePatch& dune : dunes) {
    const auto weight = static_cast<double>(dune.cells);
    cells += weight;
    means.arms += weight * dune.arms;
    if (dune.width > 0) means.length_over_width += weight * dune.length / dune.width;
  }
  if (cells <= 0) return means;
  means.dunes = static_cast<double>(dunes.size());
  means.length_over_width /= cells;
  means.arms /= cells;
  return means;
}

}  // namespace erg
