// A step of sintering snow as its kernels see it, and the kernels: plain loops over neighbouring cells, compiled once
// for each instruction set. All give the same bits.
#pragma once

#include <cstdint>

#include "compute/executor.h"
#include "kernels/box_mean.h"
#include "models/snow/snow_flight_cell.h"

namespace erg::models {

/// A cell as flights need it, in as few bytes as can be, for slabs come down all over the grid.
struct alignas(8) FlightCell {
  std::uint32_t snow = 0;  ///< snow_word
  std::uint32_t way = 0;   ///< mean hop in 1/64 rows (TransportRates); upper half: rows that a slab can fly from here
                           ///< before higher ground ends its hop, and as the highest bit whether one has come to rest
                           ///< here in this step
};
ERG_CELL_RULE int run_of(std::uint32_t way) { return static_cast<int>(way >> 16 & 0x7fff); }
inline constexpr std::uint32_t snow_has_landed = std::uint32_t{1} << 31;

/// All that a step works on. Layers of the terrain have its rows one after another; planes of the step lie in the same
/// order, in rows of `pitch` places, so that many lines of the wind fit into a processor's cache together.
struct SnowPlanes {
  const SnowLaw* law = nullptr;
  int nx = 0;
  int ny = 0;
  int pitch = 0;
  bool torus = true;
  bool relief = false;  ///< the bedrock is not level

  // The terrain.
  const std::int32_t* bedrock = nullptr;
  std::int32_t* mobile = nullptr;
  std::int32_t* loose = nullptr;
  float* age = nullptr;
  float* landed = nullptr;
  float* shown_loose = nullptr;
  float* shown_bonded = nullptr;

  // The wind's frame: its cell (u, v) has place origin + u step_u + v step_v.
  int width = 0;
  int length = 0;
  bool along_x = true;  ///< it runs along the terrain's rows
  std::int32_t origin = 0;
  std::int32_t step_u = 1;
  std::int32_t step_v = 1;

  // Transport rates.
  std::uint16_t* height = nullptr;  ///< surface over the lowest one, in the terrain's order as the next
  std::uint8_t* dark = nullptr;
  float slope_by_x = 0;  ///< slope along the wind = slope_by_x (east - west) + slope_by_y (north - south)
  float slope_by_y = 0;
  float rows = 1;               ///< of the wind's frame for one cell along the wind
  FlightCell* cells = nullptr;  ///< in the planes' order, as the next three (TransportRates)
  std::uint32_t* chances = nullptr;
  std::uint16_t* powers = nullptr;  ///< upper half of TransportRates::hops
  std::int16_t* over = nullptr;

  // What stands ahead of cells: `over` once more, with what lies beyond the ends of its rows.
  int reach = 1;  ///< rows to look ahead
  int ahead_pitch = 0;
  const std::int16_t* ahead = nullptr;  ///< of cell 0
  const int* offsets = nullptr;         ///< column of line 0 in each row from -1 to length + reach (StepRandom)
  const int* least_moved = nullptr;     ///< by how many columns lines move in so many rows, or by one more
  const std::int16_t* moved = nullptr;  ///< where it is one more, all ones, else 0: `pitch` places for each number of
                                        ///< rows; null where lines do not drift

  // Flights.
  int sweeps = 8;                    ///< that poll
  const SnowSweep* draws = nullptr;  ///< of each sub-sweep (StepRandom)
  double inflow = 0;                 ///< slabs a line and step, over open edges
  SnowRests rests;
  bool closes = true;                    ///< each line goes on as itself behind the torus edge, or not at all
  std::uint64_t* handed_over = nullptr;  ///< loads that go on in another line: as SnowStrip::loads, of all lines
  int drift = 0;                         ///< columns from a line to that other one
  std::int32_t* lift_counts = nullptr;   ///< Executor::lift_counts, or null

  // Rest.
  std::uint32_t bonding_key = 0;
  std::uint32_t number = 0;  ///< of cell (0, 0) of the terrain in the wind's frame; to the next one in x, in y
  std::uint32_t number_by_x = 1;
  std::uint32_t number_by_y = 1;

  ERG_CELL_RULE std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x);
  }
  ERG_CELL_RULE std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(pitch) + static_cast<std::size_t>(x);
  }
  /// The cell of the terrain at a place.
  ERG_CELL_RULE std::int32_t cell_at(std::int32_t place) const { return place - place / pitch * (pitch - nx); }
  /// The place where a line meets a row; where it does not, that where it would if it went on over the torus.
  ERG_CELL_RULE std::int32_t place_of_line(int line, int row) const {
    const int column = offsets[row + 1] + line;
    return origin + (column < width ? column : column - width) * step_u + row * step_v;
  }
};

/// The smoothed surface around a row of the terrain, and the mean of its surroundings. Rows of levels have a place more
/// on either side.
struct SnowLevels {
  const float* here = nullptr;
  const float* south = nullptr;
  const float* north = nullptr;
  const float* around = nullptr;
};

/// Most lines of a strip, and the places of a list of some of them: one is written beyond the last, and kernels look at
/// whole vectors.
inline constexpr int snow_strip_lines = 256;
inline constexpr int snow_strip_list = snow_strip_lines + 16;

/// Lines that one thread follows through the sub-sweeps of a step, side by side, and what is in the air over them.
/// Nothing in one line reads another.
struct SnowStrip {
  int first = 0;
  int lines = 0;
  std::int64_t lifts = 0;
  std::int64_t rows_flown = 0;
  std::int64_t slabs_in = 0;
  std::int64_t slabs_out = 0;
  bool hands_over = false;  ///< slabs have gone on in other lines

  // Polls, for each block of as many rows as there are sub-sweeps and each of these.
  std::uint16_t* polls = nullptr;  ///< `snow_strip_list` places
  int* poll_counts = nullptr;

  // Slabs in the air wait in a ring of rows.
  std::uint64_t* loads = nullptr;  ///< for each of its rows those of all lines of the grid, from the strip's first on
  int width = 0;                   ///< of the grid
  std::uint32_t ring_first = 0;    ///< the ring's row of the grid's first row
  std::uint32_t ring_mask = 1;     ///< rows of the ring less one
  std::uint16_t* lists = nullptr;  ///< for each row the lines of the strip that have a load, `snow_strip_list` places
  int* counts = nullptr;           ///< how many they are

  /// The ring's row of a row of the grid.
  ERG_CELL_RULE int ring_row(int row) const {
    return static_cast<int>((ring_first + static_cast<std::uint32_t>(row)) & ring_mask);
  }
  ERG_CELL_RULE std::uint64_t& load(int there, int line) const {
    return loads[static_cast<std::ptrdiff_t>(there) * width + line];
  }
  /// Puts a load into the air; one of 0 changes nothing.
  ERG_CELL_ACT void put(int there, int line, std::uint64_t added) const {
    std::uint64_t& waiting = load(there, line);
    int& count = counts[there];
    lists[there * snow_strip_list + count] = static_cast<std::uint16_t>(line);
    count += (waiting == 0 ? 1 : 0) & (added != 0 ? 1 : 0);
    waiting += added;
  }
  ERG_CELL_RULE bool anything_aloft() const {
    int loaded = 0;
    for (std::uint32_t row = 0; row <= ring_mask; ++row) loaded |= counts[row];
    return loaded != 0;
  }
};

struct SnowKernels {
  // Of a row `y` of the terrain.
  /// Returns the longest mean hop, in 1/64 rows.
  std::uint32_t (*rates)(const SnowPlanes& planes, int y, const SnowLevels& levels);
  void (*runs)(const SnowPlanes& planes, int y);
  void (*scatter)(const SnowPlanes& planes, int y);
  void (*rest)(const SnowPlanes& planes, int y);
  void (*strength)(const SnowPlanes& planes, int y, float* strength);

  /// Draws the polls of all sub-sweeps, which hang on nothing that flights change.
  void (*poll)(const SnowPlanes& planes, SnowStrip& strip);
  /// One sub-sweep of a strip, by its number.
  void (*fly)(const SnowPlanes& planes, int number, SnowStrip& strip);
  /// The edges between `count` cells (64 at most) from `a` on and those from `b` on over which loose snow might slide,
  /// as bits.
  std::uint64_t (*steep)(const SnowPlanes& planes, std::size_t a, std::size_t b, int count);
  kernels::BoxKernels boxes;
};

const SnowKernels& snow_kernels(compute::InstructionSet set);

}  // namespace erg::models
