// The parallel flights of sintering snow, one strip of lines at a time. A line follows the wind through the grid; a
// strip holds the snow and the weather of its lines. Slabs in the air wait in a ring of rows for the row where they
// come down. All that a flight reads is its own line's, so strips need not wait for each other.
#pragma once

#include <cstdint>
#include <vector>

#include "compute/aligned_vector.h"
#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "models/snow/snow_places.h"
#include "models/snow/snow_sweep.h"

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
  std::uint32_t* chances = nullptr;  ///< SnowWeather of each cell; changed where walls stand
  std::uint32_t* hops = nullptr;
  std::int16_t* over = nullptr;
  std::uint32_t longest_mean_hop = 0;         ///< 1/64 rows
  bool relief = false;                        ///< the bedrock is not level
  Grid<std::int32_t>* lift_counts = nullptr;  ///< Executor::lift_counts

  // Filled in by SnowFlights.
  const SnowSweep* draws = nullptr;  ///< of each sub-sweep
  int reach = 1;
  int windows = 2;                       ///< of rows in which slabs may be in the air, a power of two
  const int* offsets = nullptr;          ///< SnowDraws
  const std::int32_t* upwind = nullptr;  ///< surface of each line in the row before the first, before the flights
  const SnowPlaces* places = nullptr;
  const SnowKernels* kernels = nullptr;
};

class SnowStrip {
 public:
  /// Slabs in the air that have left the strip over the torus edge.
  struct Carried {
    std::uint32_t line = 0;  ///< that they have come from, or go on in
    int row = 0;             ///< where they come down, counted from the edge
    std::uint64_t load = 0;
  };
  struct Counts {
    std::int64_t lifts = 0;
    std::int64_t rows_flown = 0;
    std::int64_t slabs_in = 0;
    std::int64_t slabs_out = 0;
  };

  /// Begins with its lines' part of the terrain, of which nothing is taken yet. `first`: number of its first line.
  void begin(const SnowFlightPlan& plan, int first, int lines);
  /// Takes its part from the terrain, and draws the step's polls.
  void load();
  /// One sub-sweep. On a torus what is in the air at the end is added to carried(). Without polls it goes on until
  /// nothing is in the air, and takes from the terrain what it comes to.
  void sweep(const SnowSweep& sweep);
  std::vector<Carried>& carried() { return carried_; }
  /// Puts slabs into the air over one of its lines (numbered from 0).
  void receive(int line, int row, std::uint64_t load);
  /// Writes the snow back into the terrain.
  void store();
  /// Of all strips that it has been.
  const Counts& counts() const { return counts_; }
  void forget_counts() { counts_ = {}; }

 private:
  /// A slab that lifts after its line has crossed an open side.
  struct LateLift {
    int line;
    int row;
    int fall;
    std::uint64_t load;
  };

  template <typename Visit>
  void for_stretches(int begin, int end, const Visit& visit) const;
  SnowStretch stretch(int row, int line, int count);
  SnowAhead ahead_of(int row, int line) const;
  void ask_ahead(int row, int line, int count, bool takes) const;
  void take_rows(int end);
  void take_heights(int end);
  void take_ground(int begin, int end);
  void draw_polls();
  int offset(int row) const { return plan_.offsets[row + 1]; }
  int column(int row, int line) const;
  std::size_t at(int row, int line) const { return plan_.places->cells.at(row, line); }
  SnowLines lines_of();
  SnowLandings landings_of(const SnowSweep& sweep);
  SnowAir air_of() { return {loads_.data(), excess_.empty() ? nullptr : excess_.data(), falls_.data(), plan_.windows}; }
  bool anything_aloft() const;
  void lift(int begin, int number, const std::uint64_t* row_words, std::uint64_t crossing, SnowAir& air);
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
  int rows_ = 0;                         ///< that have been taken from the terrain
  int rows_ahead_ = 0;                   ///< whose heights have been
  AlignedVector<StripCell> cells_;       ///< in the places of SnowPlaces::cells, as the next three
  AlignedVector<std::uint16_t> powers_;  ///< upper half of SnowWeather::hops
  AlignedVector<std::uint32_t> chances_;
  AlignedVector<std::int32_t> ground_;  ///< bedrock; empty where it is level
  AlignedVector<std::int16_t> over_;    ///< SnowWeather, in those of SnowPlaces::heights
  AlignedVector<std::uint16_t> polls_;  ///< SnowPollDraw of each window
  std::vector<int> poll_counts_;
  AlignedVector<std::uint32_t> loads_;  ///< SnowAir
  AlignedVector<std::uint64_t> excess_;
  AlignedVector<std::uint32_t> falls_;
  std::vector<LateLift> late_;  ///< of the window under way, over open edges
  std::vector<Carried> carried_;
};

}  // namespace erg
