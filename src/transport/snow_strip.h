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
  std::uint32_t longest_mean_hop = 0;         ///< 1/64 rows
  bool relief = false;                        ///< the bedrock is not level
  Grid<std::int32_t>* lift_counts = nullptr;  ///< Executor::lift_counts

  // Filled in by SnowFlights.
  std::int64_t drift = 0;  ///< SnowDraws
  int reach = 1;
  int windows = 2;               ///< of rows in which slabs may be in the air, a power of two
  const int* offsets = nullptr;  ///< SnowDraws
  const SnowKernels* kernels = nullptr;
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
  /// Takes over the memory of a strip that is stored, or not yet loaded.
  void swap_memory(SnowStrip& other);
  /// One sub-sweep. On a torus what is in the air at the end is added to carried().
  void sweep(const SnowSweep& sweep);
  std::vector<Carried>& carried() { return carried_; }
  /// Puts slabs into the air over one of its lines (numbered from 0).
  void receive(int line, int row, std::uint64_t load);
  /// Writes the snow back into the terrain.
  void store();
  const Counts& counts() const { return counts_; }

 private:
  /// A slab that lifts after its line has crossed an open side.
  struct LateLift {
    int line;
    int row;
    int fall;
    std::uint64_t load;
  };

  template <typename Visit>
  void for_cells(int begin, int end, const Visit& visit) const;
  SnowStretch stretch(int row, int line, int count, SnowCell* cells, std::int16_t* heights) const;
  void exchange(bool takes);
  void exchange_oblique(bool takes);
  void lay_out();
  void load_beyond_edge();
  int offset(int row) const { return plan_.offsets[row + 1]; }
  void find_walls();
  void find_runs();
  std::int32_t surface(std::size_t here) const {
    return mobile_of(cells_[here].snow) + (plan_.relief ? ground_[here] : 0);
  }
  int column(int row, int line) const;
  std::size_t at(int row, int line) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(next_row_) +
           static_cast<std::size_t>(line) * static_cast<std::size_t>(next_line_);
  }
  SnowLines lines_of() { return {cells_.data(), next_row_, next_line_, first_, lines_}; }
  SnowLandings landings_of(const SnowSweep& sweep);
  SnowAir air_of() { return {loads_.data(), falls_.data(), plan_.windows, next_load_}; }
  void lift(int begin, int end, const SnowSweep& sweep, const std::uint64_t* row_words, std::uint64_t crossing,
            SnowAir& air);
  int entering_line(int row) const;
  std::uint64_t find_crossing(int begin, int end) const;
  void hold_back(std::uint64_t crossing, SnowLifts& lifts);
  void cross_open_side(const SnowLandings& landings, const std::uint64_t* row_words, int begin, int end,
                       const SnowSweep& sweep, SnowAir& air);
  template <typename Visit>
  void take_all(int line, int first, const Visit& visit);
  void enter(int row, int line, const SnowSweep& sweep);
  void drop_out(int row, int line);
  void leave_grid();

  SnowFlightPlan plan_;
  int first_ = 0;
  int lines_ = 0;
  Counts counts_;
  int next_row_ = snow_lines;  ///< in the layers below: cells lie as they do in the terrain, lines or rows side by side
  int next_line_ = 1;
  AlignedVector<SnowCell> cells_;         ///< up to `reach` rows beyond the grid, as all layers
  AlignedVector<std::int16_t> over_;      ///< SnowWeather
  AlignedVector<std::int32_t> ground_;    ///< bedrock; empty where it is level
  std::int32_t upwind_[snow_lines] = {};  ///< surface of the row before the first
  int next_load_ = 0;                     ///< from a load to that of the next line
  AlignedVector<std::uint64_t> loads_;    ///< SnowAir
  AlignedVector<std::uint64_t> falls_;
  std::vector<LateLift> late_;  ///< of the window under way, over open edges
  std::vector<Carried> carried_;
};

}  // namespace erg
