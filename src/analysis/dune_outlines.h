// Single dunes: where each stands, how high, wide and long it is, its horns and its slip face.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/terrain.h"

namespace erg::analysis {

/// What counts as a dune: a patch of sand (cells that touch along rows and columns) that is thick and large enough. The
/// outline of the dune is the edge of the patch.
struct DuneRule {
  std::int32_t base = 0;       ///< quanta of sand between the dunes; heights and volumes count from there
  std::int32_t least = 3;      ///< quanta of sand from which on a cell belongs to a dune
  std::int64_t smallest = 30;  ///< cells from which on a patch is a dune

  /// The usual rule for a terrain. Between the dunes lies what nine cells in ten have or exceed (0 where a tenth of the
  /// terrain is bare), and a dune is thicker than that by `clear_of_base` quanta, and thicker than the mean: than what
  /// there would be were all sand spread evenly. So the outline of a barchan on bare ground runs near its foot, and
  /// ridges that stand foot to foot are told apart half-way up.
  static DuneRule usual(const Terrain& terrain);
};
/// Quanta by which a dune is at least thicker than the sand between dunes: less is rubble.
inline constexpr std::int32_t clear_of_base = 3;

/// How far the horns of a barchan reach beyond the bay between them, m, seen looking downwind.
struct Horns {
  double left = 0;
  double right = 0;
};

/// One dune. Lengths in m.
struct Dune {
  std::int64_t cells = 0;
  double x = 0;       ///< east of the grid's south-west corner, of the middle of its sand; within the grid
  double y = 0;       ///< north of it
  double height = 0;  ///< of its thickest column over DuneRule::base
  double length = 0;  ///< of the outline along the wind, horns and all
  double width = 0;   ///< of the outline across the wind
  double volume = 0;  ///< m3: of the sand within the outline over DuneRule::base
  /// Where both reach at least `least_horn` cells beyond the bay: the deepest hollow of the outline's downwind edge.
  std::optional<Horns> horns;
  /// Degrees: the middle (median) slope of the cells that fall downwind by more than `least_slip_slope`, the terrain
  /// taken as planes through 3 x 3 cells; nothing where fewer than `least_slip_cells` do.
  std::optional<double> slip_face;
  /// Mean of x y^2 over the spreads of x and y^2 of its cells, x downwind and y across from the outline's middle.
  /// Positive where the sides lie downwind of the middle (horns of a barchan), negative where they lie upwind (arms of
  /// a parabolic dune); 0 for an ellipse or a rectangle.
  double arms = 0;
};
inline constexpr double least_horn = 3;         ///< cells: less is raggedness
inline constexpr double least_slip_slope = 20;  ///< degrees: lee slopes without avalanches are gentler
inline constexpr int least_slip_cells = 6;

/// The dunes of a terrain.
struct DuneOutlines {
  DuneRule rule;             ///< by which they were found
  std::vector<Dune> dunes;   ///< from south-west to north-east, by the first cell met
  std::int64_t endless = 0;  ///< ridges that reach around the torus: without ends, so not among the dunes
  std::int64_t cut = 0;      ///< patches that an open edge cuts off, likewise
};

/// Finds and measures the dunes of `terrain` for a wind from `bearing` (degrees). Throws InputError for one without
/// cells.
DuneOutlines find_dunes(const Terrain& terrain, double bearing, const DuneRule& rule);
/// The same by the usual rule.
DuneOutlines find_dunes(const Terrain& terrain, double bearing);

/// Means over dunes, each counted by its cells; all 0 where there is none.
struct DuneMeans {
  double dunes = 0;
  double length_over_width = 0;
  double arms = 0;
};
DuneMeans mean_of_dunes(const std::vector<Dune>& dunes);

}  // namespace erg::analysis
