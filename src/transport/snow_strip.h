// The parallel flights of sintering snow, one strip of lines. A line follows the wind through the grid; a strip holds
// the snow and the weather of its lines side by side, row by row. Slabs in the air wait in a ring of rows for the row
// where they come down. All that a flight reads is its own line's, so strips need not wait for each other.
#pragma once

#include <cstdint>
#include <vector>

#include "core/terrain.h"
#include "transport/aligned_vector.h"
#include "transport/snow_sweep.h"
#include "wind/wind_frame.h"

namespace erg {

/// One step's flights: the terrain in its own order, and what is drawn for all strips.
struct SnowFlightPlan {
  const SnowLaw* law = nullptr;
  WindFrame frame;
  Extent extent;
  Boundary boundary = Boundary::torus;
  double inflow = 0;  ///< slabs a line and step, over open edges
  StepKey key;
  int sweeps = 8;
  const std::int32_t* bedrock = nullptr;
  std::int32_t* mobile = nullptr;
  std::int32_t* loose = nullptr;
  float* landed = nullptr;
  const std::uint32_t* chances = nullptr;  ///< SnowWeather of each cell
  const std::uint32_t* hops = nullptr;
  const std::int16_t* over = nullptr;
  std::uint32_t longest_mean_hop = 0;  ///< 1/64 rows
  bool relief = false;                 ///< the bedrock is not level

  // Filled in by SnowFlights.
  std::int64_t drift = 0;        ///< columns that a line moves over the length of the grid
  int reach = 1;                 ///< rows of the longest hop
  int ring_rows = 2;             ///< a power of two over `reach`
  const int* offsets = nullptr;  ///< column of line 0 in each row from -1 to length + reach
  const SnowKernels* kernels = nullptr;
};

/// What is drawn for one sub-sweep.
struct SnowSweep {
  bool polls = true;
  bool last = false;           ///< whatever comes down stays
  std::uint32_t step_key = 0;  ///< the same for all sub-sweeps of a step
  std::uint32_t key = 0;
  std::uint32_t polled_row[256] = {};  ///< of a block of K rows, for each random byte
};

class SnowStrip {
 public:
  /// Slabs in the air that have left the strip over the torus edge.
  struct Carried {
    std::uint32_t line = 0;  ///< that they have come from
    int row = 0;             ///< where they come down, counted from the edge
    std::uint64_t load = 0;
  };
  struct Counts {
    std::int64_t lifts = 0;
    std::int64_t rows_flown = 0;
    std::int64_t slabs_in = 0;
    std::int64_t slabs_out = 0;
  };

  /// Takes its lines' part of the terrain. `first`: number of its first line.
  void load(const SnowFlightPlan& plan, int first, int lines);
  /// One sub-sweep. On a torus what is in the air at the end is left in carried().
  void sweep(const SnowSweep& sweep);
  std::vector<Carried>& carried() { return carried_; }
  /// Puts slabs into the air over one of its lines (numbered from 0).
  void receive(int line, int row, std::uint64_t load);
  /// Writes the snow back into the terrain.
  void store();
  const Counts& counts() const { return counts_; }

 private:
  template <typename Visit>
  void for_cells(int begin, int end, const Visit& visit) const;
  void load_beyond_edge();
  void find_walls();
  bool before_wall(std::int32_t next_ground, std::int32_t surface) const {
    return next_ground - surface > plan_.law->wall;
  }
  void find_runs();
  int column(int row, int line) const;
  std::size_t at(int row, int line) const {
    return static_cast<std::size_t>(row) * snow_lines + static_cast<std::size_t>(line);
  }
  std::uint64_t& ring(std::int64_t row, int line) {
    return ring_[static_cast<std::size_t>(row & (plan_.ring_rows - 1)) * snow_lines + static_cast<std::size_t>(line)];
  }
  std::uint64_t& arrived(std::int64_t row) { return arrived_[static_cast<std::size_t>(row & (plan_.ring_rows - 1))]; }
  std::uint64_t find_lifts(int row, const SnowSweep& sweep, std::uint64_t (&lifts)[64]);
  void visit(int row, int line, bool lifts, std::uint32_t row_key, const SnowSweep& sweep);
  int strikes(int row, int line, std::uint64_t load, std::uint32_t word);
  bool struck(int row, int line, float power, std::uint32_t random) const;
  void launch(int row, int line, std::uint32_t word);
  void cross_open_edges(int row, const SnowSweep& sweep);
  void enter(int row, int line, const SnowSweep& sweep);
  void drop_out(int row, int line);
  void leave_grid();

  SnowFlightPlan plan_;
  int first_ = 0;
  int lines_ = 0;
  std::uint32_t rest_loose_ = 0;  ///< chances of 65536
  std::uint32_t rest_hard_ = 0;
  std::uint32_t rest_ground_ = 0;
  std::uint32_t suspension_ = 0;
  Counts counts_;
  AlignedVector<std::uint32_t> snow_;     ///< loose and all slabs (snow_word)
  AlignedVector<std::uint32_t> chances_;  ///< SnowWeather
  AlignedVector<std::uint32_t> hops_;
  AlignedVector<std::int16_t> over_;      ///< up to `reach` rows beyond the grid
  AlignedVector<std::int16_t> runs_;      ///< rows that a slab can fly from each cell before higher ground stops it
  AlignedVector<std::int32_t> ground_;    ///< bedrock where it is not level, else 0; one row beyond the grid
  std::vector<std::uint64_t> landed_;     ///< one bit a line: a slab has come to rest here
  std::int32_t upwind_[snow_lines] = {};  ///< surface of the row before the first
  AlignedVector<std::uint64_t> ring_;     ///< slabs that come down, and in the lower half the shares of hops they flew
  std::vector<std::uint64_t> arrived_;    ///< one bit a line of the ring's rows
  std::vector<Carried> carried_;
};

}  // namespace erg
