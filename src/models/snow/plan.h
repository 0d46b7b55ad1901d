// What the kernels of sintering snow read and write, as one plain struct that every launch hands over by value. Snow
// lies on the device in the wind's frame, cell = row * width + column; a line follows the wind through it.
#pragma once

#include "kernels/step_counters.h"
#include "kernels/terrain_order.h"
#include "models/snow/snow_flight_cell.h"
#include "models/snow/snow_ground.h"

namespace erg::models {

/// Words that tell the processor what the weather of a step is like.
enum SnowBound : int {
  bound_highest,     ///< surface over the lowest bedrock, slabs
  bound_not_lowest,  ///< ~ the lowest surface
  bound_snow,        ///< most slabs of snow in a cell
  bound_hop,         ///< longest mean hop, 1/64 rows
  snow_bounds
};

/// Edges that share no cell: number k of a row (or column) begins at place 2 k + odd.
struct SnowEdgeClass {
  bool along = true;  ///< from row to row, or from column to column
  int odd = 0;
  int count = 0;        ///< in each column (or row)
  bool closes = false;  ///< instead the one from the last place to the first, over the torus edge
};

struct SnowPlan {
  SnowGround ground;
  std::int32_t base = 0;  ///< lowest bedrock
  float* age = nullptr;
  float* strength = nullptr;
  const SnowLaw* law = nullptr;              ///< on the device: its tables are more than a launch can hand over
  compute::CounterWord* counters = nullptr;  ///< counter_slots * step_counters

  // Weather.
  std::uint32_t* bounds = nullptr;   ///< SnowBound
  std::uint32_t* heights = nullptr;  ///< surface over the lowest bedrock
  std::uint64_t* columns = nullptr;  ///< sums over the columns of boxes
  std::uint64_t* sums = nullptr;     ///< sums over boxes
  float* means = nullptr;            ///< where average_rows leaves its means
  int radius = 0;                    ///< of the boxes
  float share = 1;                   ///< box_share
  float* level = nullptr;
  float* around = nullptr;
  std::uint8_t* dark = nullptr;
  int shadow_rows = 32;    ///< of a line that one thread follows
  double shadow_fall = 1;  ///< slabs a cell
  double tangent = 0;
  double cosine = 1;
  float along = 0;  ///< slope = along (next row - row before) + across (next column - column before)
  float across = 0;

  // Flights (StepRandom).
  SnowCell* cells = nullptr;
  std::int16_t* over = nullptr;  ///< TransportRates
  const int* offsets = nullptr;
  const SnowSweep* sweeps = nullptr;
  int polling = 16;     ///< sub-sweeps that poll
  int last_sweep = 16;  ///< number of the last one
  int sweep = 0;        ///< that bring_down does
  int reach = 1;
  int ring_mask = 1;               ///< rows of a ring less one
  std::uint64_t* ring = nullptr;   ///< slabs in the air: for each row of the ring the loads of all lines
  std::uint64_t* aloft = nullptr;  ///< the same of slabs that go on in another line, for the next pass
  std::uint32_t* left = nullptr;   ///< 1 where there are any
  std::int64_t drift = 0;
  bool closes = true;  ///< each line goes on as itself behind the torus edge, or not at all
  double inflow = 0;
  SnowRests rests;
  std::int32_t* lift_counts = nullptr;  ///< slabs lifted from each cell; null: not counted
  kernels::TerrainOrder order;
  int nx = 0;  ///< of the terrain

  // Slides and rest.
  SnowEdgeClass edges;  ///< what a launch that slides works on
  std::uint64_t fall_word = 0;
  std::int32_t* fallen = nullptr;  ///< slabs that fell on each cell; null: no snow falls
  std::uint32_t bonding_key = 0;

  ERG_CELL_RULE int width() const { return ground.width; }
  ERG_CELL_RULE int length() const { return ground.length; }
  ERG_CELL_RULE std::int32_t cell_count() const { return ground.width * ground.length; }
};

namespace snow {
using Plan = SnowPlan;
}

}  // namespace erg::models
