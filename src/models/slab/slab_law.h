// A slab model is a law, not a loop: this plain struct is all that an executor knows of Werner, Momiji, Bishop and the
// models built on them.
#pragma once

#include <cstdint>

#include "core/grid.h"
#include "core/stamp.h"
#include "models/slab/slab_cell.h"

namespace erg::models {

/// Cover as executors use it: 255 is rho = 1 (nothing lifts, everything that lands stays), 0 is bare.
using CoverField = Grid<std::uint8_t>;
/// With the stamp by which executors know whether the cover that they have loaded is still the same.
using Cover = Stamped<CoverField>;
/// The cover that an effectiveness rho in [0, 1] means.
inline std::uint8_t cover_of(float rho) { return static_cast<std::uint8_t>(rho * 255.0f + 0.5f); }

/// How far a slab flies in one hop, in cells, from ground of height h (slabs):
///
///     strength + linear * (h - reference) + quadratic * (h - reference)^2
///
/// the last term only above the reference (Momiji et al. 2000; Cimbura 2022, eq. 4.1), never below `shortest_hop`, nor
/// below a strength that is less. reference = mean height - deviation_weight * (mean of |h - mean height|): weight 0 is
/// Momiji, 1/2 is Bishop et al. 2002 (Cimbura 2022, eq. 4.2). Werner: linear = quadratic = 0.
struct HopLaw {
  double linear = 0;
  double quadratic = 0;
  double deviation_weight = 0;

  bool depends_on_height() const { return linear != 0 || quadratic != 0; }
  /// Length of a hop in a wind of this strength (cells) from ground so many slabs above the reference.
  double cells(double strength, double above_reference) const;
};

/// The largest steps between neighbouring cells that stand, in slabs; a larger one slides (tested before the move).
struct ReposeSteps {
  int straight = 2;
  int diagonal = 3;  ///< to a diagonal neighbour, sqrt(2) cells away

  bool operator==(const ReposeSteps&) const = default;

  /// The steps that an angle of repose (degrees) means on this grid.
  static ReposeSteps of_angle(double angle, double cell_size, double slab_height);
};

/// What a model of slabs hands over for a step. The numbers here are those of a bare law in tests and measurements; a
/// model sets them from its parameters.
struct SlabLaw {
  HopLaw hop;
  double p_sand = 0.6;             ///< chance that a slab stays where sand lies
  double p_bare = 0.4;             ///< chance that it stays on bare ground
  double shadow_fall = 0.8;        ///< slabs a cell: the shadow line behind a peak
  bool lift_in_shadow = true;      ///< Werner: yes; Momiji and Bishop: no
  ReposeSteps bare;                ///< repose of bare sand
  ReposeSteps covered;             ///< repose of the higher cell's sand where its cover >= covered_from
  std::uint8_t covered_from = 77;  ///< 0.3 of 255
  int neighbours = 4;              ///< 4 or 8: where sand slides to
  bool repeated_polling = true;    ///< false: each cell is polled exactly once a step
  bool forced_erosion = false;     ///< poll until as many slabs as there are cells have been lifted
  bool obstacles = true;           ///< slabs drop before bedrock that stands too steeply
  double inflow = 0;               ///< open boundary: slabs entering per step and cell of upwind edge
  const Cover* cover = nullptr;    ///< not owned; null: bare everywhere
};

}  // namespace erg::models
