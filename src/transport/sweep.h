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

#include "core/cell_rule.h"
#include "transport/executor.h"

namespace erg {

/// Lines that one strip holds at most; its scratch rows have this stride.
inline constexpr int strip_lines = 512;
/// Rows of a tile: slides inside tiles come first, then the seams between them.
inline constexpr int tile_rows = 32;
/// Slabs landing at one place that 8-bit lanes can count; more makes the sub-sweep start again with 16-bit lanes.
inline constexpr int narrow_arrivals = 100;

/// How a plane of the grid lies in memory: cut into blocks of columns, each whole and one after another, so that
/// threads which work on different columns touch different memory (and what their prefetchers read ahead is their own).
///
/// The planes of an oblique wind are *skewed*: column u of row v stands in *place* u - skew(v), round the torus, so
/// that lines, which drift sideways with the wind, stay in a block from the first row to the last (but for two
/// columns).
struct PlaneLayout {
  int width = 0;
  int length = 0;
  int block_columns = 0;  ///< columns of a block; the last may have fewer
  int blocks = 0;
  int pitch = 0;  ///< lanes from one row of a block to the next
  std::size_t block_size = 0;
  std::int64_t lean = 0;  ///< columns of skew for one row, times 2^24; 0: place and column are the same

  ERG_CELL_RULE std::size_t at(int block, int column_in_block, int row) const {
    return static_cast<std::size_t>(block) * block_size +
           static_cast<std::size_t>(row) * static_cast<std::size_t>(pitch) + static_cast<std::size_t>(column_in_block);
  }
  ERG_CELL_RULE int columns_of(int block) const {
    return block + 1 < blocks ? block_columns : width - block * block_columns;
  }
  /// The block of a place.
  ERG_CELL_RULE int block_of(int place) const {
    const int block = place / block_columns;
    return block < blocks ? block : blocks - 1;
  }
  /// Columns by which a row is shifted, at most those by which a line has drifted there.
  ERG_CELL_RULE int skew(int row) const { return static_cast<int>((row * lean) >> 24) - (lean != 0 ? 1 : 0); }
  ERG_CELL_RULE std::size_t at_place(int place, int row) const {
    const int block = block_of(place);
    return at(block, place - block * block_columns, row);
  }
  /// A number of columns or places, round the torus.
  ERG_CELL_RULE int wrapped(int column) const {
    const int rest = column % width;
    return rest < 0 ? rest + width : rest;
  }
};

/// On skewed planes a line stands in its own place or up to so many places beside it: a part for the phase, a part for
/// the rounded drift, and one that `skew` holds back.
inline constexpr int most_lead = 3;

/// Cells of one row that stand in the places of the next strip. They are handed over after the conveyor, or two threads
/// would write to the same piece of memory all the time.
template <typename Lane>
struct Overhang {
  Lane lead = 0;
  Lane heights[most_lead] = {};
};

/// Everything that all strips of a sub-sweep share. `Lane` counts slabs: 8 or 16 bits.
template <typename Lane>
struct SweepPlan {
  PlaneLayout layout;
  const Lane* before = nullptr;
  Lane* after = nullptr;
  const Lane* bedrock = nullptr;            ///< null where all bedrock is level (then it is 0)
  const std::uint8_t* cover = nullptr;      ///< null: bare
  const std::uint8_t* wall_rows = nullptr;  ///< with obstacles: 1 where the row holds bedrock that may stop slabs
  bool open = false;

  std::uint64_t sweep_word = 0;              ///< random word of (seed, step, sub-sweep)
  std::uint64_t poll_word = 0;               ///< the same for polls: of the whole round where polling is non-repeated
  int sweeps = 16;                           ///< K
  const std::uint8_t* polled_row = nullptr;  ///< non-repeated: 256 rows in [0, K), one for each random byte
  std::int64_t drift = 0;                    ///< columns that a line moves over the length of the grid
  std::int64_t phase = 0;                    ///< in [0, length)

  std::uint32_t p_sand_16 = 0;  ///< chance * 65536
  std::uint32_t p_bare_16 = 0;
  bool lift_in_shadow = true;
  bool oblique = false;
  std::uint32_t row_fall = 0;       ///< fall of the shadow line per row, 1/256 slabs
  std::uint32_t adjacent_fall = 0;  ///< to the next row
  int warm_up = 0;                  ///< rows to read upwind of row 0 before the shadow is known
  int wall_step = 0;                ///< slabs: bedrock standing higher than this over the ground before it is a wall

  bool hop_by_height = false;
  const std::uint32_t* hop_table = nullptr;  ///< rows * 256 for each height; one entry if not hop_by_height
  int ring_rows = 0;                         ///< power of two, more than the longest hop
  double inflow = 0;                         ///< slabs entering per line and sub-sweep
};

/// Counts of one strip in one sub-sweep.
struct SweepCounts {
  std::int64_t polls = 0;
  std::int64_t lifts = 0;
  std::int64_t rows_flown = 0;
  std::int64_t slabs_in = 0;
  std::int64_t slabs_out = 0;
  std::uint32_t highest = 0;       ///< highest cell written, before what the carry adds
  std::uint32_t most_landed = 0;   ///< most slabs set down on one cell by the conveyor
  std::uint32_t most_carried = 0;  ///< the same by the carry
  bool crowded = false;            ///< too many slabs at one place for 8-bit lanes
};

/// A strip of lines at work: its shadow line, its slabs in the air.
template <typename Lane>
struct Strip {
  using Shadow = std::conditional_t<sizeof(Lane) == 1, std::uint16_t, std::uint32_t>;
  int first = 0;  ///< first line
  int lines = 0;  ///< at most strip_lines
  SweepCounts counts;
  std::int64_t last_arrival = -1;        ///< no slab in the air comes down after this row
  alignas(64) Shadow line[strip_lines];  ///< height of the shadow line, 1/256 slabs
  alignas(64) Lane upwind[strip_lines];  ///< height of the row before (oblique winds)
  alignas(64) Lane target[strip_lines];  ///< the row of the block in which the line is polled
  Overhang<Lane>* overhang = nullptr;    ///< of each row; null where planes are not skewed
  Lane* ring = nullptr;                  ///< ring_rows x strip_lines, empty (0) between sub-sweeps
};

/// Slides of one sub-sweep: what all bands share.
template <typename Lane>
struct SlidePlan {
  PlaneLayout layout;
  Lane* heights = nullptr;
  const Lane* bedrock = nullptr;         ///< null where level
  const Lane* steps = nullptr;           ///< standing step of each cell; null: `step` everywhere
  const Lane* diagonal_steps = nullptr;  ///< the same to diagonal neighbours
  int step = 2;
  int diagonal_step = 3;
  bool diagonals = false;
  bool open = false;
  std::uint8_t order[8] = {};  ///< edge classes (EdgeClass) in the order of this sub-sweep
};

/// A block's cells in some of its rows, which slide by themselves. Tiles are a part of the rules: they depend on the
/// grid alone.
struct SlideTile {
  int block = 0;
  int first_row = 0;
  int end_row = 0;
};

/// Edge classes: edges of one class share no cell.
enum EdgeClass : std::uint8_t {
  along_even,
  along_odd,
  across_even,
  across_odd,
  rising_even,  ///< diagonal (u, v) - (u + 1, v + 1), v even
  rising_odd,
  falling_even,  ///< diagonal (u, v) - (u - 1, v + 1), v even
  falling_odd
};

template <typename Lane>
struct SweepKernels {
  void (*convey)(const SweepPlan<Lane>&, Strip<Lane>&);          ///< rows 0 ... length - 1 of a strip's lines
  void (*hand_over)(const SweepPlan<Lane>&, Strip<Lane>&);       ///< writes a strip's overhang
  void (*carry)(const SweepPlan<Lane>&, Strip<Lane>&);           ///< slabs still in the air go on over the torus edge
  void (*slide_tile)(const SlidePlan<Lane>&, const SlideTile&);  ///< all edges inside a tile
  void (*slide_row_seam)(const SlidePlan<Lane>&, const SlideTile& below);  ///< edges to what lies above a tile
  void (*slide_column_seam)(const SlidePlan<Lane>&, int left, int right);  ///< edges between two blocks
};

template <typename Lane>
const SweepKernels<Lane>& sweep_kernels(InstructionSet set);

}  // namespace erg
