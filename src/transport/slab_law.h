// A slab model is a law, not a loop: this plain struct is all that an executor knows of Werner, Momiji, Bishop and the
// models built on them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.h"

namespace erg {

/// Cover as executors use it: 255 is rho = 1 (nothing lifts, everything that lands stays), 0 is bare.
using CoverField = Grid<std::uint8_t>;

/// How far a slab flies in one hop, in cells, at ground of height h (slabs):
/// strength + linear * (h - reference) + quadratic * (h - reference)^2, the last term only above the reference
/// (Momiji et al. 2000, eq. 4.1 in Cimbura 2022). Werner: linear = quadratic = 0. Never below `shortest_hop`.
struct HopLaw {
  double linear = 0;
  double quadratic = 0;
  double reference = 0;  ///< slabs
  bool depends_on_height() const { return linear != 0 || quadratic != 0; }
  double cells(double strength, double height) const;
};
inline constexpr double shortest_hop = 1.0;

struct SlabLaw {
  HopLaw hop;
  double p_sand = 0.6;             ///< chance that a slab stays where sand lies
  double p_bare = 0.4;             ///< chance that it stays on bare ground
  double shadow_fall = 0.8;        ///< slabs a cell: the shadow line behind a peak
  bool erode_in_shadow = true;     ///< Werner: yes; Momiji and Bishop: no
  int standing_step = 2;           ///< slabs: a larger step to a neighbour slides
  int standing_step_covered = 2;   ///< the same where cover >= covered_from
  std::uint8_t covered_from = 77;  ///< 0.3 of 255
  int neighbours = 4;              ///< 4 or 8: where sand slides to
  bool repeated_polling = true;    ///< false: each cell is polled exactly once a step
  bool forced_erosion = false;     ///< poll until as many slabs as cells have been lifted
  bool obstacles = true;           ///< slabs drop before bedrock that stands too steeply
  double inflow = 0;               ///< open boundary: slabs entering per step and cell of upwind edge
  const CoverField* cover = nullptr;  ///< not owned; null: bare everywhere
  std::uint64_t cover_revision = 0;   ///< changes when the cover's values do
};

}  // namespace erg
