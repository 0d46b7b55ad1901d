#include "analysis/sand_patches.h"

#include <utility>

namespace erg::analysis {
namespace {

/// Follows one patch after the other.
class PatchSearch {
 public:
  PatchSearch(const Terrain& terrain, std::int32_t least)
      : thickness_(terrain.mobile()),
        torus_(terrain.boundary() == Boundary::torus),
        least_(least),
        seen_(terrain.extent()),
        places_(terrain.extent()) {}

  bool starts_patch(int x, int y) const { return thickness_(x, y) >= least_ && !seen_(x, y); }

  /// The patch around (x, y); `endless` and `cut` speak of it afterwards.
  std::vector<PatchCell> follow(int x, int y) {
    endless_ = cut_ = false;
    std::vector<PatchCell> patch;
    visit({x, y}, patch);
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const PatchCell at = patch[next];
      for (const PatchCell beside : {PatchCell{at.x + 1, at.y}, {at.x - 1, at.y}, {at.x, at.y + 1}, {at.x, at.y - 1}}) {
        visit(beside, patch);
      }
    }
    return patch;
  }
  bool endless() const { return endless_; }
  bool cut() const { return cut_; }

 private:
  void visit(PatchCell place, std::vector<PatchCell>& patch) {
    const int x = wrap(place.x, thickness_.nx());
    const int y = wrap(place.y, thickness_.ny());
    if (!torus_ && place != PatchCell{x, y}) {
      cut_ = true;
      return;
    }
    if (thickness_(x, y) < least_) return;
    if (seen_(x, y)) {
      endless_ = endless_ || places_(x, y) != place;
      return;
    }
    seen_(x, y) = 1;
    places_(x, y) = place;
    patch.push_back(place);
  }

  const Grid<std::int32_t>& thickness_;
  bool torus_;
  std::int32_t least_;
  Grid<std::uint8_t> seen_;
  Grid<PatchCell> places_;
  bool endless_ = false;
  bool cut_ = false;
};

}  // namespace

SandPatches find_patches(const Terrain& terrain, std::int32_t least, std::int64_t smallest) {
  check_whole(terrain);
  PatchSearch search(terrain, least);
  SandPatches patches;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      if (!search.starts_patch(x, y)) continue;
      std::vector<PatchCell> cells = search.follow(x, y);
      if (static_cast<std::int64_t>(cells.size()) < smallest) continue;
      if (search.endless()) {
        ++patches.endless;
      } else if (search.cut()) {
        ++patches.cut;
      } else {
        patches.whole.push_back(std::move(cells));
      }
    }
  }
  return patches;
}

}  // namespace erg::analysis
