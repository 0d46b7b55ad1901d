// Carries out the snow law on a terrain: what a time step of drifting, bonding snow does.
//
// A step has four phases. *Weather*: the smoothed surface, the wind over it, the wind shadow, and from them each cell's
// chances, hops and height for this step. *Flights*: on an executor without sub-sweeps one slab after the other in
// random order, each seeing what the last one left; else SnowFlights. *Slides*: loose snow down too steep edges, class
// by class of edges that share no cell. *Rest*: snow falls, bonds and ages. Both ways use the rules of snow_cell.h and
// snow_ground.h; results depend on no number of threads and no instruction set.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "compute/executor.h"
#include "core/terrain.h"
#include "forcing/regime.h"
#include "forcing/wind_frame.h"
#include "models/snow/snow_cell.h"
#include "models/snow/snow_flights.h"
#include "models/snow/snow_ground.h"
#include "models/snow/snow_step.h"
#include "models/step_report.h"

namespace erg {

/// The layers of a snow terrain besides its heights, in the terrain's order.
struct SnowLayers {
  std::vector<std::int32_t> loose;  ///< slabs on top that have not bonded
  std::span<float> age;             ///< mean age of the bonded part, h
  std::span<float> landed;          ///< when a slab last came down, h since the beginning
  std::span<float> shown_loose;     ///< written at the end of a step: `loose`, and what lies under it
  std::span<float> shown_bonded;
};

class SnowMachine {
 public:
  explicit SnowMachine(InstructionSet instructions = wanted_instruction_set()) : instructions_(instructions) {}

  /// One time step. `shadow_fall`: slabs a cell. Throws InputError if the snow has grown too high to be counted.
  StepReport step(Terrain& terrain, SnowLayers& layers, const SnowLaw& law, SnowRadii radii, double shadow_fall,
                  const WindNow& wind, StepKey key, Executor& executor);

 private:
  struct Place {
    int u;
    int v;
  };

  void measure_heights();
  void measure_weather(double shadow_fall);
  void find_shadow(double shadow_fall);
  void shade_lines(int first, int lines, double shadow_fall);
  struct ShadowTile;
  template <typename Visit>
  void for_tile(int begin, int end, int lines, const ShadowTile& tile, const Visit& visit) const;
  SnowWeatherRow weather_row(int y) const;
  std::uint32_t make_weather(int begin, int end);
  void fly_one_by_one();
  void poll(Place place, std::uint64_t word);
  void fly(Place place, std::uint64_t word, bool enters);
  void let_drift_enter();
  bool strikes(std::size_t here, std::size_t from, float flown, std::uint32_t random) const;
  void fly_in_sweeps();
  void slide();
  void slide_class(bool along, int odd);
  void find_steep();
  void slide_in_row(int y, int first);
  void slide_to_next(int y);
  void slide_edge(int x, int y, int other_x, int other_y);
  void mark_steep(int x, int y);
  std::uint64_t steep_edges(std::size_t a, std::size_t b, int count) const;
  void find_steep_blocks(std::size_t a, std::size_t b, int count, std::uint8_t* flags) const;
  void let_snow_fall();
  void rest();

  std::size_t cell(int u, int v) const { return frame_.cell(u, v); }
  /// Whether the wind's frame runs along the terrain's rows. In a grid of one column its steps do not tell.
  bool along_x() const { return (frame_.step_v == 1 || frame_.step_v == -1) && frame_.length == extent_.nx; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(extent_.nx) + static_cast<std::size_t>(x);
  }
  /// Of the flags of steep edges.
  std::size_t block(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(blocks_) + static_cast<std::size_t>(x) / 64;
  }
  std::int32_t surface(std::size_t cell) const { return bedrock_[cell] + mobile_[cell]; }
  /// Null where it is level.
  const std::int32_t* bedrock_at(std::size_t cell) const { return relief_ ? bedrock_ + cell : nullptr; }

  const InstructionSet instructions_;

  // Of the step under way.
  const SnowLaw* law_ = nullptr;
  Executor* executor_ = nullptr;
  SnowLayers* layers_ = nullptr;
  const std::int32_t* bedrock_ = nullptr;
  std::int32_t* mobile_ = nullptr;
  Extent extent_;
  Boundary boundary_ = Boundary::torus;
  double inflow_ = 0;
  SnowRadii radii_;
  WindFrame frame_;
  SnowGround ground_;
  StepKey key_;
  StepReport report_;

  // Weather of the step, one value a cell.
  std::int32_t low_ = 0;  ///< lowest surface
  std::int32_t high_ = 0;
  bool relief_ = false;
  std::vector<std::uint16_t> height_;  ///< surface over the lowest surface
  std::vector<std::uint8_t> dark_;
  std::vector<std::uint32_t> chances_;  ///< SnowWeather
  std::vector<std::uint32_t> hops_;
  std::vector<std::int16_t> over_;
  std::uint32_t longest_mean_hop_ = 0;

  // Not 0 where an edge of a block of cells may be too steep: those along a row, and those to the next row.
  int blocks_ = 0;  ///< in a row
  std::vector<std::uint8_t> steep_in_row_;
  std::vector<std::uint8_t> steep_to_next_;

  SnowFlights flights_;
  std::mutex mutex_;
  std::vector<std::vector<std::uint32_t>> fallen_;
  std::vector<std::uint32_t> order_;
};

}  // namespace erg
