// What is drawn and fixed for a step of snow, as data: every executor that sweeps starts from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "models/snow/snow_flight_cell.h"

namespace erg::models {

/// The sub-sweeps of a step's flights, and the lines that they follow.
struct StepRandom {
  std::vector<SnowSweep> sweeps;  ///< K, and the passes without polls that may follow
  int reach = 1;                  ///< rows, over the longest hop
  int ring_rows = 2;              ///< a power of two over `reach`: rows in which slabs in the air may wait
  std::int64_t drift = 0;         ///< columns that a line moves over the length of the grid
  std::vector<int> offsets;       ///< column of line 0 in each row from -1 to length + reach

  /// Draws K sub-sweeps, and as many passes without polls as the longest flight takes.
  void draw_sweeps(StepKey key, int polling);
  /// Draws where lines run, for a longest mean hop in 1/64 rows. Their drift is whole, and right in the mean.
  void draw_lines(const forcing::WindFrame& frame, StepKey key, std::uint32_t longest_mean_hop);
  /// Whether each line goes on as itself behind the torus edge, or not at all.
  bool lines_close(const forcing::WindFrame& frame, Boundary boundary) const {
    return boundary == Boundary::open || drift % frame.width == 0;
  }
  /// The last pass is repeated for hops that are longer than the grid.
  std::size_t sweep_number(std::size_t number) const { return number < sweeps.size() ? number : sweeps.size() - 1; }
};

/// Rounds of slides in a step, each over four kinds of edges: along the wind from even places on, from odd ones,
/// across.
inline constexpr int snow_slide_rounds = 2;
struct SnowEdges {
  bool along = true;
  int odd = 0;
};
/// The kinds of edges in the order of a round.
void draw_snow_slides(StepKey key, int round, SnowEdges (&order)[4]);

/// The word from which a step's snowfall is drawn, and the key of what bonds.
std::uint64_t snowfall_word(StepKey key);
std::uint32_t bonding_key(StepKey key);

/// Throws InputError if snow or relief has grown too high to be counted.
void check_snow_height(std::int32_t most_snow, std::int32_t relief);

}  // namespace erg::models
