#include "analysis/dune_outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/sand_patches.h"
#include "core/units.h"

namespace erg::analysis {
namespace {

/// The axes of a wind: along it (downwind) and across it (to the left of who looks downwind).
struct WindAxes {
  double east;
  double north;

  explicit WindAxes(double bearing) : east(-std::sin(radians(bearing))), north(-std::cos(radians(bearing))) {}
  double along(double x, double y) const { return x * east + y * north; }
  double across(double x, double y) const { return y * east - x * north; }
};

double folded(double place, double period) {
  const double rest = std::fmod(place, period);
  return rest < 0 ? rest + period : rest;
}

/// Where the outline ends, along and across the wind, in cells from middle to middle of the outermost cells.
struct Reach {
  double along_from = std::numeric_limits<double>::max();
  double along_to = std::numeric_limits<double>::lowest();
  double across_from = std::numeric_limits<double>::max();
  double across_to = std::numeric_limits<double>::lowest();
};

Reach reach_of(const std::vector<PatchCell>& cells, const WindAxes& wind) {
  Reach reach;
  for (const PatchCell& cell : cells) {
    const double along = wind.along(cell.x, cell.y);
    const double across = wind.across(cell.x, cell.y);
    reach.along_from = std::min(reach.along_from, along);
    reach.along_to = std::max(reach.along_to, along);
    reach.across_from = std::min(reach.across_from, across);
    reach.across_to = std::max(reach.across_to, across);
  }
  return reach;
}

/// How far downwind the outline reaches on each line a cell wide along the wind, from right to left, in cells.
std::vector<double> downwind_edge(const std::vector<PatchCell>& cells, const WindAxes& wind, const Reach& reach) {
  const auto line_of = [&](double across) { return static_cast<std::size_t>(across - reach.across_from + 0.5); };
  std::vector<double> edge(line_of(reach.across_to) + 1, reach.along_from);
  for (const PatchCell& cell : cells) {
    double& line = edge[line_of(wind.across(cell.x, cell.y))];
    line = std::max(line, wind.along(cell.x, cell.y));
  }
  return edge;
}

/// The edge of a line and its two neighbours, the middle one of the three: a notch of a single line is no bay.
double without_notch(const std::vector<double>& edge, std::size_t line) {
  if (line == 0 || line + 1 == edge.size()) return edge[line];
  const auto [low, high] = std::minmax(edge[line - 1], edge[line + 1]);
  return std::clamp(edge[line], low, high);
}

/// The horns on either side of the deepest bay, in cells.
std::optional<Horns> horns_of(const std::vector<double>& edge) {
  std::vector<double> tip_left(edge.size());  // the farthest point on this line or to its left
  double tip = std::numeric_limits<double>::lowest();
  for (std::size_t line = edge.size(); line-- > 0;) tip_left[line] = tip = std::max(tip, edge[line]);
  Horns deepest;
  double tip_right = std::numeric_limits<double>::lowest();
  for (std::size_t line = 0; line < edge.size(); ++line) {
    tip_right = std::max(tip_right, edge[line]);
    const double bay = without_notch(edge, line);
    const Horns here{tip_left[line] - bay, tip_right - bay};
    if (std::min(here.left, here.right) > std::min(deepest.left, deepest.right)) deepest = here;
  }
  if (std::min(deepest.left, deepest.right) < least_horn) return std::nullopt;
  return deepest;
}

std::optional<double> slip_face_of(const std::vector<PatchCell>& cells, const Terrain& terrain, const WindAxes& wind) {
  const auto height = [&](int x, int y) {
    return static_cast<double>(terrain.height(wrap(x, terrain.nx()), wrap(y, terrain.ny())));
  };
  const double to_slope = terrain.quantum() / (6 * terrain.cell_size());
  const double least = std::tan(radians(least_slip_slope));
  std::vector<double> slopes;
  for (const PatchCell& cell : cells) {
    double east = 0;
    double north = 0;
    for (int beside = -1; beside <= 1; ++beside) {
      east += height(cell.x + 1, cell.y + beside) - height(cell.x - 1, cell.y + beside);
      north += height(cell.x + beside, cell.y + 1) - height(cell.x + beside, cell.y - 1);
    }
    if (-wind.along(east, north) * to_slope > least) slopes.push_back(std::hypot(east, north) * to_slope);
  }
  if (slopes.size() < static_cast<std::size_t>(least_slip_cells)) return std::nullopt;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  return degrees(std::atan(*middle));
}

double arms_of(const std::vector<PatchCell>& cells, const WindAxes& wind) {
  const auto count = static_cast<double>(cells.size());
  double middle_x = 0, middle_y = 0;
  for (const PatchCell& cell : cells) {
    middle_x += cell.x / count;
    middle_y += cell.y / count;
  }
  double along2 = 0, across2 = 0, bent = 0;
  for (const PatchCell& cell : cells) {
    const double along = wind.along(cell.x - middle_x, cell.y - middle_y);
    const double across = wind.across(cell.x - middle_x, cell.y - middle_y);
    along2 += along * along / count;
    across2 += across * across / count;
    bent += along * across * across / count;
  }
  return along2 > 0 && across2 > 0 ? bent / (std::sqrt(along2) * across2) : 0;
}

/// Place, height and volume.
void measure_sand(const std::vector<PatchCell>& cells, const Terrain& terrain, std::int32_t base, Dune& dune) {
  double sand = 0, moment_x = 0, moment_y = 0;
  std::int32_t thickest = 0;
  for (const PatchCell& cell : cells) {
    const std::int32_t slabs = terrain.mobile()(wrap(cell.x, terrain.nx()), wrap(cell.y, terrain.ny())) - base;
    thickest = std::max(thickest, slabs);
    sand += slabs;
    moment_x += slabs * (cell.x + 0.5);
    moment_y += slabs * (cell.y + 0.5);
  }
  const double side = terrain.cell_size();
  dune.x = side * folded(moment_x / sand, terrain.nx());
  dune.y = side * folded(moment_y / sand, terrain.ny());
  dune.height = terrain.metres(thickest);
  dune.volume = sand * terrain.quantum() * side * side;
}

Dune measure_dune(const std::vector<PatchCell>& cells, const Terrain& terrain, const WindAxes& wind,
                  std::int32_t base) {
  Dune dune;
  dune.cells = static_cast<std::int64_t>(cells.size());
  measure_sand(cells, terrain, base, dune);
  const double side = terrain.cell_size();
  const Reach reach = reach_of(cells, wind);
  dune.length = side * (reach.along_to - reach.along_from + 1);
  dune.width = side * (reach.across_to - reach.across_from + 1);
  if (const auto horns = horns_of(downwind_edge(cells, wind, reach))) {
    dune.horns = Horns{side * horns->left, side * horns->right};
  }
  dune.slip_face = slip_face_of(cells, terrain, wind);
  dune.arms = arms_of(cells, wind);
  return dune;
}

}  // namespace

DuneRule DuneRule::usual(const Terrain& terrain) {
  check_whole(terrain);
  const auto cells = terrain.mobile().cells();
  DuneRule rule;
  std::vector<std::int32_t> sorted(cells.begin(), cells.end());
  const auto tenth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 10);
  std::nth_element(sorted.begin(), tenth, sorted.end());
  const double mean = static_cast<double>(terrain.total_mobile()) / static_cast<double>(cells.size());
  rule.base = *tenth;
  rule.least = std::max(rule.base + clear_of_base, static_cast<std::int32_t>(std::floor(mean)) + 1);
  return rule;
}

DuneOutlines find_dunes(const Terrain& terrain, double bearing, const DuneRule& rule) {
  check_whole(terrain);
  // Cells without sand over the base belong to no dune, whatever the rule says.
  const SandPatches patches = find_patches(terrain, std::max(rule.least, rule.base + 1), rule.smallest);
  DuneOutlines outlines{rule, {}, patches.endless, patches.cut};
  const WindAxes wind(bearing);
  for (const std::vector<PatchCell>& cells : patches.whole) {
    outlines.dunes.push_back(measure_dune(cells, terrain, wind, rule.base));
  }
  return outlines;
}

DuneOutlines find_dunes(const Terrain& terrain, double bearing) {
  return find_dunes(terrain, bearing, DuneRule::usual(terrain));
}

DuneMeans mean_of_dunes(const std::vector<Dune>& dunes) {
  DuneMeans means;
  double cells = 0;
  for (const Dune& dune : dunes) {
    const auto weight = static_cast<double>(dune.cells);
    cells += weight;
    means.arms += weight * dune.arms;
    means.length_over_width += weight * dune.length / dune.width;
  }
  if (cells <= 0) return means;
  means.dunes = static_cast<double>(dunes.size());
  means.length_over_width /= cells;
  means.arms /= cells;
  return means;
}

}  // namespace erg::analysis
