// One dune turned into the wind, for comparing dunes under winds from different bearings: whether its two sides are
// alike, and whether it is the same dune at every bearing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/grid.h"
#include "core/terrain.h"

namespace erg::analysis {

/// A place or a way on the grid, in cells; x east, y north.
struct GridPoint {
  double x = 0;
  double y = 0;
};

/// Mobile material thinner than this many quanta is strewn sand, no dune.
inline constexpr std::int32_t thinnest_dune = 2;

/// The middle of the dune, the grid taken as a torus: the mean direction of its sand along each axis (circular mean),
/// so a dune may lie across the edge. Nothing where there is none, or where it lies all around.
std::optional<GridPoint> dune_centre(const Terrain& terrain);

/// The thickness of a dune around its middle, turned so that the wind blows along +x.
struct DuneMap {
  int reach = 0;        ///< cells from the middle to each edge
  Grid<double> height;  ///< m; of (2 reach + 1)^2 points a cell apart, the middle in the middle, y to the wind's left

  /// At x cells downwind and y cells to the left of the middle; both from -reach to reach.
  double at(int x, int y) const { return height(x + reach, y + reach); }
  double volume() const;  ///< sum of all heights
};

/// Of the only dune on a torus, for a wind from `bearing` (degrees), interpolated between four cells. The map's reach
/// should take in the whole dune and be less than half the grid. Throws InputError where there is no dune.
DuneMap dune_map(const Terrain& terrain, double bearing, int reach);

/// Point by point; all of one reach, at least one.
DuneMap mean_map(std::span<const DuneMap> maps);

/// Half of the summed |difference| of two maps over the sand of both on the mean: the share of sand that lies
/// elsewhere. 0 for equal maps, 1 for maps that share nothing.
double mismatch(const DuneMap& one, const DuneMap& other);

/// The mismatch of a dune and its mirror image about the wind through its middle.
double asymmetry(const DuneMap& map);

/// A barchan's horns: sand that lies further downwind than the foot of the slip face on the dune's axis.
struct HornVolumes {
  double left = 0;  ///< their volumes, sums of m
  double right = 0;
  int left_length = 0;  ///< cells downwind from the foot that a horn reaches
  int right_length = 0;
};
/// The foot is where the axis (mean of five lines) falls below `least` m behind its highest point; what is thinner
/// counts nowhere.
HornVolumes find_horns(const DuneMap& map, double least);

}  // namespace erg::analysis
