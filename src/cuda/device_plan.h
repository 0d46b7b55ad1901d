// What the kernels of the CUDA executor read and write, as one plain struct that every launch hands over by value.
//
// Words. The terrain lies on the device in the wind's frame: cell = row * width + column, the wind blows along the
// rows' order. A *line* follows the wind: line i meets row y at column i + offset(y). A *ground word* holds a cell's
// height over the lowest bedrock in its lower 16 bits, and in its upper 16 bits how many slabs have come down there in
// this sub-sweep: the number that each of them drew decides whether it stays, and only how many there are decides how
// many stay. So slabs need not arrive in order, and each can fly in a thread of its own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/cell_rule.h"
#include "transport/plane_layout.h"
#include "transport/slab_cell.h"
#include "transport/sub_sweep.h"

namespace erg {

struct WindFrame;

inline constexpr std::uint32_t height_mask = 0xffff;
inline constexpr std::uint32_t one_arrival = 0x10000;
/// Rows that one thread scans for shadow.
inline constexpr int shadow_rows = 32;
/// Cells that come back together: what has changed is told by bands of the terrain.
inline constexpr std::int32_t band_cells = 4096;
/// Heights that hop tables and counts of heights hold.
inline constexpr int device_heights = 0x10000;

/// What is counted. Threads spread over `tally_slots` sets of counters, so that they seldom wait for each other.
enum Tally : int { tally_polls, tally_lifts, tally_rows, tally_in, tally_out, tallies };
inline constexpr int tally_slots = 256;
using TallyWord = unsigned long long;  // the type that CUDA's atomics take; sums are signed and wrap

/// A slab that flies on over the torus edge: the next in its line's list, and the row (counted on) where it comes down.
struct SlabAloft {
  std::int32_t row = 0;
  std::int32_t next = -1;
};

/// Where the cells of the frame stand in the terrain's order.
struct TerrainOrder {
  int width = 0;
  std::ptrdiff_t origin = 0;  ///< terrain cell of column 0, row 0; the others follow by these steps
  std::ptrdiff_t step_u = 0;
  std::ptrdiff_t step_v = 0;

  ERG_CELL_RULE std::ptrdiff_t place(std::int32_t cell) const {
    return origin + cell % width * step_u + cell / width * step_v;
  }
};

TerrainOrder terrain_order(const WindFrame& frame);

/// A layer of 32-bit words that is to be turned between the terrain's order and the frame's.
struct LayerPlan {
  TerrainOrder order;
  std::int32_t cells = 0;
  std::int32_t* staged = nullptr;  ///< in the terrain's order
  std::int32_t* layer = nullptr;   ///< in the frame's
};

struct DevicePlan {
  int width = 0;
  int length = 0;
  bool open = false;
  SubSweep sweep;

  std::uint32_t* before = nullptr;        ///< ground words, frozen
  std::uint32_t* after = nullptr;         ///< ground words, written
  std::uint16_t* bedrock = nullptr;       ///< over the lowest bedrock; null where level
  std::uint8_t* cover = nullptr;          ///< null: bare
  std::uint8_t* dark = nullptr;           ///< 1 where the cell lies in shadow
  std::uint32_t* highest = nullptr;       ///< bound on the heights in `before`
  std::uint32_t* next_highest = nullptr;  ///< the same for `after`
  bool walls = false;                     ///< bedrock stops slabs where it stands too steeply

  bool hop_by_height = false;
  std::uint32_t* hop_table = nullptr;  ///< rows * 256 for each height; one entry if not hop_by_height
  HopCurve hop;                        ///< what fills the table
  double hop_reference = 0;            ///< height over the lowest bedrock
  std::uint32_t* height_counts = nullptr;

  std::int32_t* first_aloft = nullptr;  ///< for each line; -1: none
  SlabAloft* aloft = nullptr;
  std::int32_t* aloft_count = nullptr;
  TallyWord* tally = nullptr;  ///< tally_slots * tallies

  PlaneLayout tiles;             ///< only its blocks and their skew: on the device a plane is not cut
  EdgeClass edges = along_even;  ///< what a launch that slides works on
  int stands = 0;                ///< the largest step over such an edge that stands: of bare sand
  int stands_covered = 0;        ///< the same where the higher cell's cover is covered_from or more
  int covered_from = 256;

  TerrainOrder order;
  std::int32_t* staged = nullptr;          ///< a layer in the terrain's order, on its way in or from frame to frame
  std::int32_t* lift_counts = nullptr;     ///< slabs lifted from each cell in the terrain's order; null: not counted
  std::int32_t* shown = nullptr;           ///< the surface in the terrain's order as the processor last saw it
  std::uint32_t* bands_changed = nullptr;  ///< 1 for bands of band_cells cells of `shown` that have changed since

  ERG_CELL_RULE std::int32_t cells() const { return width * length; }
};

}  // namespace erg
