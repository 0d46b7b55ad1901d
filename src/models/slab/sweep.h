// One sub-sweep of the parallel engine, as data: what the kernels read and write. The kernels themselves are compiled
// once for each instruction set (sweep_kernels.inl); all of them give the same bits.
//
// Words. The grid lies in a frame in which the wind blows along +v. A *row* is a row of the frame (across the wind). A
// *line* follows the wind: line i meets row y at column i + offset(y). A *lane* is one line's place in a vector. Plane
// `before` is frozen: all decisions read it; plane `after` is written. Slabs in the air wait in a *ring* of rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "compute/executor.h"
#include "models/slab/plane_layout.h"
#include "models/slab/sub_sweep.h"

namespace erg::models {

/// Lines that one strip holds at most; its scratch rows have this stride.
inline constexpr int strip_lines = 512;
/// Slabs landing at one place that 8-bit lanes can count; more makes the sub-sweep start again with 16-bit lanes.
inline constexpr int narrow_arrivals = 100;

/// On skewed planes a line stands in its own place or up to so many places beside it: a part for the phase, a part for
/// the rounded drift, and one that `skew` holds back.
inline constexpr int most_offset = 3;

/// Cells of one row that stand in the places of the next strip. They are handed over after the transport pass, or two
/// threads would write to the same piece of memory all the time.
template <typename Lane>
struct Halo {
  Lane offset = 0;
  Lane heights[most_offset] = {};
};

/// Places at the start of each row of a block that are kept packed together, for the strip before it to read: in their
/// places they lie in a cache line a row that their own thread writes to all the time. One more than needed, to fill a
/// word.
inline constexpr int ghost_places = most_offset + 1;

/// Everything that all strips of a sub-sweep share: what was drawn for it, and where it works. `Lane` counts slabs: 8
/// or 16 bits.
template <typename Lane>
struct SweepPlan : SubSweep {
  PlaneLayout layout;
  const Lane* before = nullptr;
  Lane* after = nullptr;
  const Lane* before_ghosts = nullptr;      ///< skewed planes: ghost_places of each row of each block of `before`
  const Lane* bedrock = nullptr;            ///< null where all bedrock is level (then it is 0)
  const std::uint8_t* cover = nullptr;      ///< null: bare
  const std::uint8_t* wall_rows = nullptr;  ///< with obstacles: 1 where the row holds bedrock that may stop slabs
  std::uint8_t* lifted = nullptr;           ///< written: 1 where a slab was lifted, else 0; null: not wanted
  bool open = false;

  int warm_up = 0;  ///< rows to read upwind of row 0 before the shadow is known

  bool hop_by_height = false;
  const std::uint32_t* hop_table = nullptr;  ///< rows * 256 for each height; one entry if not hop_by_height
  int ring_rows = 0;                         ///< power of two, more than the longest hop
};

/// Counts of one strip in one sub-sweep.
struct SweepCounters {
  std::int64_t polls = 0;
  std::int64_t lifts = 0;
  std::int64_t rows_flown = 0;
  std::int64_t slabs_in = 0;
  std::int64_t slabs_out = 0;
  std::uint32_t highest = 0;       ///< highest cell written, before what the carry adds
  std::uint32_t most_landed = 0;   ///< most slabs set down on one cell by the transport pass
  std::uint32_t most_carried = 0;  ///< the same by the carry
  bool overflow = false;           ///< too many slabs at one place for 8-bit lanes
};

/// Bytes between what two threads write all the time: a processor fetches ahead of what it reads, up to the end of a
/// page, and takes from another what that is writing to.
inline constexpr std::size_t fetched_ahead = 4096;

/// A strip of lines at work: its shadow line, its slabs in the air.
template <typename Lane>
struct alignas(fetched_ahead) Strip {
  using Shadow = std::conditional_t<sizeof(Lane) == 1, std::uint16_t, std::uint32_t>;
  int first = 0;  ///< first line
  int lines = 0;  ///< at most strip_lines
  SweepCounters counts;
  SweepCounters shown[2];                   ///< counts of the last two sub-sweeps, for all members to read
  std::int64_t last_arrival = -1;           ///< no slab in the air comes down after this row
  alignas(64) Shadow line[strip_lines];     ///< height of the shadow line, 1/256 slabs
  alignas(64) Lane upwind[2][strip_lines];  ///< heights of the last two rows, in turn (oblique winds)
  int second = 0;                           ///< where in `upwind` the earlier one is
  alignas(64) Lane target[strip_lines];     ///< the row of the block in which the line is polled
  Halo<Lane>* halo = nullptr;               ///< of each row; null where planes are not skewed
  int next_block = -1;                      ///< the block that begins where the strip's own places end, if one does
  Lane* ring = nullptr;                     ///< ring_rows x strip_lines, empty (0) between sub-sweeps
};

/// Slides of one sub-sweep, for one thread: what slides by which rules, and its room for borders.
template <typename Lane>
struct SlidePlan {
  PlaneLayout layout;
  Lane* heights = nullptr;
  const Lane* bedrock = nullptr;         ///< null where level
  const Lane* steps = nullptr;           ///< critical step of each cell; null: `step` everywhere
  const Lane* diagonal_steps = nullptr;  ///< the same to diagonal neighbours
  int step = 2;
  int diagonal_step = 3;
  bool diagonals = false;
  bool open = false;
  const std::uint8_t* order = nullptr;  ///< edge classes in the order of this sub-sweep
  Lane* ghosts = nullptr;               ///< skewed planes: ghost_places of each row of each block
  Lane* edges = nullptr;                ///< what stands in the outermost columns of each block (edge_column)
  Lane* border = nullptr;               ///< room for the columns of one border: border_columns x length

  /// Where column `k` of a block's outermost ones is kept: 0, 1 from the left, 2, 3 to the right.
  Lane* edge_column(int block, int k) const {
    return edges + static_cast<std::size_t>(4 * block + k) * static_cast<std::size_t>(layout.length);
  }
};

/// Four columns beside a border with the height, bedrock and both critical steps of their cells.
inline constexpr int border_columns = 16;

/// A block's cells in some of its rows, which slide by themselves. Tiles are a part of the rules: they depend on the
/// grid alone.
struct SlideTile {
  int block = 0;
  int first_row = 0;
  int end_row = 0;
};

template <typename Lane>
struct SweepKernels {
  void (*transport_pass)(const SweepPlan<Lane>&, Strip<Lane>&);  ///< rows 0 ... length - 1 of a strip's lines
  void (*hand_over)(const SweepPlan<Lane>&, Strip<Lane>&);       ///< writes a strip's halo
  void (*wrap_pass)(const SweepPlan<Lane>&, Strip<Lane>&);       ///< slabs still in the air go on over the torus edge
  void (*slide_tile)(const SlidePlan<Lane>&, const SlideTile&);  ///< all edges inside a tile
  void (*slide_row_border)(const SlidePlan<Lane>&, const SlideTile& below);  ///< edges to what lies above a tile
  void (*keep_edges)(const SlidePlan<Lane>&, int block);                     ///< copies the outermost columns
  /// Edges between two blocks, from the columns that both have kept; writes to those blocks that are `mine`.
  void (*slide_column_border)(const SlidePlan<Lane>&, int left, int right, bool left_mine, bool right_mine);
  /// Copies the first places of a block's rows [first, end).
  void (*keep_ghosts)(const SlidePlan<Lane>&, int block, int first_row, int end_row);
  void (*slide_corners)(const SlidePlan<Lane>&);  ///< skewed planes: edges between blocks over the torus edge
};

template <typename Lane>
const SweepKernels<Lane>& sweep_kernels(compute::InstructionSet set);

}  // namespace erg::models
