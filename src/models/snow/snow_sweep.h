// Work on sintering snow as data, and the kernels that do it: plain loops over neighbouring cells, compiled once for
// each instruction set. All give the same bits.
#pragma once

#include <cstdint>

#include "compute/instruction_set.h"
#include "models/snow/snow_flight_cell.h"

namespace erg {

/// Cells in a row of the terrain whose weather is made. Rows of levels have a place more on either side.
struct SnowWeatherRow {
  int count = 0;
  float slope_by_x = 0;  ///< slope along the wind = slope_by_x (east - west) + slope_by_y (north - south)
  float slope_by_y = 0;
  float rows = 1;                ///< of the wind's frame for one cell along the wind
  const float* level = nullptr;  ///< smoothed surface; beside a cell stand its neighbours
  const float* south = nullptr;
  const float* north = nullptr;
  const float* around = nullptr;  ///< mean of the surroundings
  const float* landed = nullptr;
  const float* age = nullptr;
  const std::uint16_t* surface = nullptr;
  const std::uint8_t* dark = nullptr;
  std::uint32_t* chances = nullptr;  ///< SnowWeather of each cell
  std::uint32_t* hops = nullptr;
  std::int16_t* over = nullptr;
};

/// Sums over boxes of cells, row by row.
template <typename Sum>
struct BoxKernels {
  /// columns += entering - leaving; null: nothing leaves.
  void (*add_numbers)(const std::uint16_t* entering, const std::uint16_t* leaving, Sum* columns, int count);
  void (*add_sums)(const Sum* entering, const Sum* leaving, Sum* columns, int count);
  /// sums = those of `window` neighbours from each of `count` columns on. Destroys `columns`.
  void (*add_up)(Sum* columns, Sum* sums, int count, int window);
  /// Sums are below 2^63 (2^31).
  void (*average)(const Sum* sums, float share, float* means, int count);
};

/// What is to be known of the heights of many cells.
struct SnowHeights {
  std::int32_t level = 0;                  ///< of the bedrock, if it is level
  std::int32_t lowest = 0x7fffffff;        ///< surface
  std::int32_t highest = -0x7fffffff - 1;  ///< surface
  std::int32_t most_snow = 0;
  std::int32_t uneven = 0;  ///< not 0: the bedrock is not level
};

/// Lines of shadow side by side in a row, and what they have passed.
struct SnowShadowRow {
  int count = 0;
  std::int32_t fall_far = 0;  ///< of the shadow from row to row, fixed point
  std::int32_t fall_near = 0;
  const std::uint16_t* surface = nullptr;
  std::int32_t* far = nullptr;
  std::int32_t* near = nullptr;
  std::uint8_t* dark = nullptr;
};

/// The noise of strength at the points of its lattice around some rows of the terrain: drawn once, looked up for each
/// cell.
struct StrengthLattice {
  static constexpr int layers = 64;  ///< that it holds
  float* points = nullptr;           ///< two rows of noise_columns + 1 places of so many layers
  int row = -1;                      ///< of the lattice; -1: empty
  int lowest = 0;                    ///< layer
};

/// The strength of the uppermost bonded snow in a row of the terrain.
struct SnowStrengthRow {
  int y = 0;
  int count = 0;
  const std::int32_t* mobile = nullptr;
  const std::int32_t* loose = nullptr;
  float* strength = nullptr;
};

/// Cells in a row of the terrain whose snow rests for a step.
struct SnowRestRow {
  int count = 0;
  std::uint32_t key = 0;     ///< of this step's draws
  std::uint32_t number = 0;  ///< of the first cell, in the wind's frame
  std::uint32_t next_number = 1;
  const std::int32_t* mobile = nullptr;
  const float* landed = nullptr;
  std::int32_t* loose = nullptr;
  float* age = nullptr;
  float* shown_loose = nullptr;
  float* shown_bonded = nullptr;
};

/// Most lines of a strip.
inline constexpr int snow_lines = 64;
/// Rows that are gone through together: one bit each in a word. What a window's flights touch fits into the innermost
/// cache.
inline constexpr int snow_window = 32;

/// A cell of a strip: all that a slab needs to know that comes down there, in as few bytes as can be.
struct alignas(8) StripCell {
  std::uint32_t snow = 0;  ///< snow_word
  std::uint32_t way = 0;   ///< mean hop in 1/64 rows (SnowWeather); upper half: rows that a slab can fly from here
                           ///< before higher ground ends its hop, and as the highest bit whether one has come to rest
                           ///< here in this step
};
ERG_CELL_RULE int run_of(std::uint32_t way) { return static_cast<int>(way >> 16 & 0x7fff); }
inline constexpr std::uint32_t snow_has_landed = std::uint32_t{1} << 31;

/// A strip's cells as the kernels see them.
struct SnowLines {
  StripCell* cells = nullptr;
  const std::uint16_t* powers = nullptr;  ///< upper half of SnowWeather::hops, of each cell
  const int* places = nullptr;            ///< of line 0 in each row, from row 0 on
  int next_line = 0;                      ///< from a cell to that of the next line
  int first_line = 0;
  int lines = 0;
};

/// The cells that a step's sub-sweeps poll in a window, as far as a slab might lift: known before the flights. A word
/// for each: line, row of the window, and whether loose snow would lift, and bonded snow.
inline constexpr int polled_row_bit = 6;
inline constexpr int lifts_loose_bit = 12;
inline constexpr int lifts_hard_bit = 13;
/// Places for as many of them as a window may have in one of so many sub-sweeps; some are for what is written beyond
/// the last.
inline constexpr int most_polls(int sweeps) {
  return snow_lines * (sweeps < snow_window ? snow_window / sweeps : 1) + 16;
}

struct SnowPollDraw {
  int first_row = 0;
  int end = 0;
  int sweeps = 8;
  const SnowSweep* draws = nullptr;        ///< of each sub-sweep
  const std::uint32_t* chances = nullptr;  ///< SnowWeather of each cell of the strip
  std::uint16_t* polls = nullptr;          ///< to be written: a list of most_polls for each sub-sweep
  int* counts = nullptr;                   ///< to be written: how many polls each has
};

/// Polls of a window in a sub-sweep, `snow_lines` at most.
struct SnowPolls {
  const std::uint16_t* polls = nullptr;
  int count = 0;
  int first_row = 0;
  const std::uint64_t* row_words = nullptr;  ///< flight_row_word of each row
};

/// Slabs that come down in a cell of a strip together, in half the bytes of a load (snow_flight_cell.h): how many, and
/// in the lower 20 bits the shares of hops that they flew.
inline constexpr std::uint32_t short_slab = std::uint32_t{1} << 20;
inline constexpr std::uint32_t most_short_slabs = 4095;
ERG_CELL_RULE std::uint32_t short_slabs_of(std::uint32_t load) { return load / short_slab; }
ERG_CELL_RULE std::uint64_t long_load(std::uint32_t load) {
  return std::uint64_t{load / short_slab} << 32 | load % short_slab;
}

/// Slabs in the air, in the rows where they will come down. Rows are a ring of whole windows. Each line may have as
/// many slabs in the air as it has rows, and those that enter it: on long lines they may be more than a short load
/// counts.
struct SnowAir {
  std::uint32_t* loads = nullptr;   ///< short, for each window, line and row
  std::uint64_t* excess = nullptr;  ///< what came to loads that were full; null where none can be
  std::uint32_t* falls = nullptr;   ///< for each window and line, one bit for each row that has a load
  int windows = 1;                  ///< a power of two
  std::int64_t rows_flown = 0;
  std::int64_t carried_off = 0;

  /// Adds to a load; a short one of 0 slabs or 1.
  ERG_CELL_RULE void put(int place, std::uint32_t slab) const {
    if (loads[place] < most_short_slabs * short_slab) {
      loads[place] += slab;
    } else {
      excess[place] += long_load(slab);
    }
  }
  /// What a short load at a place and its excess are together.
  ERG_CELL_RULE std::uint64_t all_of(int place, std::uint32_t load) const {
    return long_load(load) + (load < most_short_slabs * short_slab ? 0 : excess[place]);
  }
};
/// Slabs that lift, and where they come down. Those of polls from which none does have no load.
struct SnowLifts {
  int count = 0;  ///< of the polls
  int lifted = 0;
  std::int64_t rows_flown = 0;
  alignas(64) std::int32_t line[snow_lines];
  alignas(64) std::int32_t row[snow_lines];   ///< that they lift from
  alignas(64) std::int32_t fall[snow_lines];  ///< row where they come down
  // What they add in SnowAir.
  alignas(64) std::int32_t place[snow_lines];   ///< of the load
  alignas(64) std::int32_t window[snow_lines];  ///< of the bit, with the line
  alignas(64) std::uint32_t load[snow_lines];
  alignas(64) std::uint32_t bit[snow_lines];
};

/// What becomes of slabs that come down, in a sub-sweep.
struct SnowLandings {
  const SnowLaw* law = nullptr;
  SnowLines lines;
  const std::int32_t* ground = nullptr;  ///< bedrock of each cell of the strip; null where it is level
  const std::int32_t* upwind = nullptr;  ///< surface of each line in the row before the first
  SnowRests rests;
  bool last = false;  ///< whatever comes down stays
  // Where a cell stands in the terrain.
  const int* offsets = nullptr;  ///< column of line 0 in each row, from row 0 on
  int width = 0;
  std::int64_t origin = 0;
  std::int64_t step_u = 0;
  std::int64_t step_v = 0;
  int nx = 0;
};
/// The surface before the first row of an open grid.
inline constexpr std::int32_t no_surface = -0x7fffffff - 1;

/// What stands ahead of cells that lie side by side, row by row down the wind: heights over the smoothed surface.
struct SnowAhead {
  const std::int16_t* heights = nullptr;  ///< of the cells
  int next_row = 1;                       ///< from a cell to that of its line in the next row, if lines do not drift
  int reach = 1;                          ///< rows to look ahead
  // Where the cells lie along oblique lines. From row to row each line goes on in the same place or in that beside it.
  const std::int16_t* drifted = nullptr;        ///< columns that lines have moved, from the first cell's row on; null:
                                                ///< they do not
  const std::int16_t* least_drifted = nullptr;  ///< the least that they move in so many rows; at most 1 more
  int next_line = 0;
};

/// Most cells of a stretch.
inline constexpr int snow_stretch = 64;
/// Cells that lie side by side in the terrain and in a strip, `snow_stretch` at most: a strip takes their snow from the
/// terrain and gives it back.
struct SnowStretch {
  const SnowLaw* law = nullptr;
  int count = 0;
  int step = 1;  ///< 1 or -1: from a cell of the strip to the next, in the layers of the terrain
  std::int32_t* mobile = nullptr;
  std::int32_t* loose = nullptr;
  float* landed = nullptr;
  const std::uint32_t* chances = nullptr;
  const std::uint32_t* hops = nullptr;
  SnowAhead ahead;
  // In the strip.
  StripCell* cells = nullptr;
  std::uint16_t* powers = nullptr;
  std::uint32_t* polled_chances = nullptr;
};

struct SnowKernels {
  /// Returns the longest mean hop, in 1/64 rows.
  std::uint32_t (*weather)(const SnowLaw& law, const SnowWeatherRow& row);
  void (*rest)(const SnowLaw& law, const SnowRestRow& row);
  void (*draw_polls)(const SnowPollDraw& draw, const SnowLines& lines);
  /// Finds the slabs that lift from polled cells, and takes them off these.
  void (*lift)(const SnowPolls& polls, const SnowLines& lines, const SnowAir& air, SnowLifts& lifts);
  /// Puts them into the air.
  void (*launch)(const SnowLifts& lifts, SnowAir& air);
  /// Brings down what comes down in the rows of a window from `first_row` to before `end`, in the lines whose bits are
  /// set in `among`.
  void (*land)(const SnowLandings& landings, const std::uint64_t* row_words, int first_row, int end,
               std::uint64_t among, SnowAir& air);
  /// The flight_row_word of each row of a window.
  void (*draw_rows)(std::uint32_t sweep_key, int first_row, std::uint64_t* row_words);
  void (*take_snow)(const SnowStretch& stretch);
  void (*give_snow)(const SnowStretch& stretch);
  /// Which of `count` surfaces in `a` (64 at most) stand more than `step` over or under those in `b`, as bits. Ground
  /// may be null where it is level.
  std::uint64_t (*find_steep)(const std::int32_t* ground_a, const std::int32_t* snow_a, const std::int32_t* ground_b,
                              const std::int32_t* snow_b, int count, int step);
  /// The same of any number: for each block of 64 whether there is one, 0 or 1.
  void (*find_steep_blocks)(const std::int32_t* ground_a, const std::int32_t* snow_a, const std::int32_t* ground_b,
                            const std::int32_t* snow_b, int count, int step, std::uint8_t* blocks);
  void (*strength)(const SnowLaw& law, const SnowStrengthRow& row, StrengthLattice& lattice);
  void (*survey)(const std::int32_t* bedrock, const std::int32_t* mobile, int count, SnowHeights& heights);
  /// height = surface over `low`
  void (*raise)(const std::int32_t* bedrock, const std::int32_t* mobile, int low, std::uint16_t* height, int count);
  void (*shade)(const SnowShadowRow& row);
  BoxKernels<std::uint32_t> boxes;
  BoxKernels<std::uint64_t> wide_boxes;
};

const SnowKernels& snow_kernels(InstructionSet set);

}  // namespace erg
