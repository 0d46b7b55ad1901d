// Work on sintering snow as data, and the kernels that do it: plain loops over neighbouring cells, compiled once for
// each instruction set. All give the same bits.
#pragma once

#include <cstdint>

#include "transport/executor.h"
#include "transport/snow_flight_cell.h"

namespace erg {

/// Cells in a row of the terrain whose weather is made.
struct SnowWeatherRow {
  int count = 0;
  float slope_by_x = 0;  ///< slope along the wind = slope_by_x (east - west) + slope_by_y (north - south)
  float slope_by_y = 0;
  float rows = 1;  ///< of the wind's frame for one cell along the wind
  const float* level = nullptr;
  const float* west = nullptr;  ///< levels of the neighbours
  const float* east = nullptr;
  const float* south = nullptr;
  const float* north = nullptr;
  const float* around = nullptr;
  const float* landed = nullptr;
  const float* age = nullptr;
  const std::uint32_t* surface = nullptr;
  const std::uint8_t* dark = nullptr;
  std::uint32_t* chances = nullptr;  ///< SnowWeather of each cell
  std::uint32_t* hops = nullptr;
  std::int16_t* over = nullptr;
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

/// Rows of a strip in which a sub-sweep polls each line once.
struct SnowPolls {
  int rows = 0;
  std::uint32_t key = 0;         ///< snow_poll_key
  std::uint32_t chance_key = 0;  ///< of the chances to lift
  std::uint32_t first_line = 0;
  int lines = 0;
  const std::uint32_t* polled_row = nullptr;  ///< 256 rows, one for each random byte
  const SnowCell* cells = nullptr;            ///< of the first row's first line
  int next_row = 0;                           ///< from a cell to that in the next row
  int next_line = 0;
  std::uint64_t* lifts = nullptr;  ///< one bit a line, for each row of a block; zero before
};

struct SnowKernels {
  /// Returns the longest mean hop, in 1/64 rows.
  std::uint32_t (*weather)(const SnowLaw& law, const SnowWeatherRow& row);
  void (*rest)(const SnowLaw& law, const SnowRestRow& row);
  void (*poll)(const SnowPolls& polls);
  /// Finds the runs of `count` cells that lie side by side, 64 at most: rows until higher ground, looking `reach` rows
  /// ahead; `unhindered_run` where there is none. `over` has `next_row` from a cell to that in the next row.
  void (*find_runs)(const std::int16_t* over, int next_row, int clearance_16, int reach, SnowCell* cells, int count);
  /// Whether any of `count` surfaces in `a` stands more than `step` over or under that in `b`. Ground may be null where
  /// it is level.
  bool (*any_steep)(const std::int32_t* ground_a, const std::int32_t* snow_a, const std::int32_t* ground_b,
                    const std::int32_t* snow_b, int count, int step);
  /// Strength of the uppermost bonded snow of `count` cells from (0, y) on.
  void (*strength)(const SnowLaw& law, int y, const std::int32_t* mobile, const std::int32_t* loose, float* strength,
                   int count);
};

const SnowKernels& snow_kernels(InstructionSet set);

}  // namespace erg
