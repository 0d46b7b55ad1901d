// What the kernels of slabs read and write, as one plain struct that every launch hands over by value.
//
// Words. The terrain lies on the device in the wind's frame: cell = row * width + column, the wind blows along the
// rows' order. A *line* follows the wind: line i meets row y at column i + offset(y). A *ground word* holds a cell's
// height over the lowest bedrock in its lower 16 bits, and in its upper 16 bits how many slabs have come down there in
// this sub-sweep: the number that each of them drew decides whether it stays, and only how many there are decides how
// many stay. So slabs need not arrive in order, and each can fly in a thread of its own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/step_counters.h"
#include "kernels/terrain_order.h"
#include "models/slab/plane_layout.h"
#include "models/slab/slab_cell.h"
#include "models/slab/sub_sweep.h"

namespace erg::models::slab {

inline constexpr std::uint32_t height_mask = 0xffff;
inline constexpr std::uint32_t one_arrival = 0x10000;
/// Cells that come back together: what has changed is told by bands of the terrain.
inline constexpr std::int32_t band_cells = 4096;
/// Heights that hop tables and counts of heights hold.
inline constexpr int hop_heights = 0x10000;

/// A slab that flies on over the torus edge: the next in its line's list, and the row (counted on) where it comes down.
struct Aloft {
  std::int32_t row = 0;
  std::int32_t next = -1;
};

struct Plan {
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
  Aloft* aloft = nullptr;
  std::int32_t* aloft_count = nullptr;
  compute::CounterWord* counters = nullptr;  ///< counter_slots * step_counters

  int shadow_rows = 32;           ///< of a line that one thread scans for shadow
  PlaneLayout tiles;              ///< only its blocks and their skew: on the device a plane is not cut
  EdgeClass edges = along_even;   ///< what a launch that slides works on
  int critical_step = 0;          ///< the largest step over such an edge that stands: of bare sand
  int critical_step_covered = 0;  ///< the same where the higher cell's cover is covered_from or more
  int covered_from = 256;

  kernels::TerrainOrder order;
  std::int32_t* staged = nullptr;          ///< a layer in the terrain's order, on its way in or from frame to frame
  std::int32_t* lift_counts = nullptr;     ///< slabs lifted from each cell in the terrain's order; null: not counted
  std::int32_t* shown = nullptr;           ///< the surface in the terrain's order as the processor last saw it
  std::uint32_t* bands_changed = nullptr;  ///< 1 for bands of band_cells cells of `shown` that have changed since

  ERG_CELL_RULE std::int32_t cells() const { return width * length; }
};

}  // namespace erg::models::slab
