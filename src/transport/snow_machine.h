// Carries out the snow law on a terrain: what a time step of drifting, bonding snow does.
//
// A step has four phases. *Weather*: the smoothed surface, the wind over it, the wind shadow and each cell's chance to
// lift, all from the surface at the beginning of the step. *Flights*: on an executor without sub-sweeps one slab after
// the other, each seeing what the last one left; else in K sub-sweeps, in each of which every thread decides the
// flights of its cells on a surface that nobody changes, and then all changes (whole numbers, which commute) are
// written. *Slides*: loose snow down too steep edges, class by class of edges that share no cell. *Rest*: snow falls,
// bonds and ages. Both ways use the rules of snow_cell.h; results depend on no number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "core/terrain.h"
#include "transport/executor.h"
#include "transport/snow_cell.h"
#include "wind/wind_frame.h"

namespace erg {

/// The layers of a snow terrain besides its heights, in the terrain's order.
struct SnowLayers {
  std::vector<std::int32_t> loose;  ///< slabs on top that have not bonded
  std::vector<float> age;           ///< mean age of the bonded part, h
  std::vector<float> landed;        ///< when a slab last came down, h since the beginning
};

class SnowMachine {
 public:
  /// Cells from the middle to the edge of the boxes over which means are taken.
  struct Radii {
    int smooth = 3;   ///< for the smoothed surface
    int around = 10;  ///< for its surroundings
  };
  /// One time step. `shadow_fall`: slabs a cell.
  StepReport step(Terrain& terrain, SnowLayers& layers, const SnowLaw& law, Radii radii, double shadow_fall,
                  const WindNow& wind, StepKey key, Executor& executor);

 private:
  enum class Change : std::uint8_t { lift, land, free };
  struct Event {
    std::uint32_t cell;
    Change change;
  };
  struct Batch {
    std::vector<Event> events;
    StepReport report;
  };
  struct Place {
    int u;
    int v;
  };

  void measure_weather(double shadow_fall);
  void measure_line(int line, double shadow_fall, int start_row);
  void fly_one_by_one();
  void fly_in_sweeps(int sweeps);
  void poll_lines(std::int64_t begin, std::int64_t end, int sweep, int sweeps, const std::uint8_t* rows);
  void write_events();
  template <typename Sink>
  void poll(Place place, std::uint64_t word, Sink& sink) const;
  template <typename Sink>
  void fly(Place place, std::uint64_t word, Sink& sink, bool enters) const;
  template <typename Sink>
  void let_drift_enter(Sink& sink) const;
  template <typename Sink>
  void strike(std::size_t cell, std::size_t from, float flown, std::uint32_t random, Sink& sink) const;
  template <typename Visit>
  void for_frame(int width, int length, const Visit& visit) const;
  void slide();
  void slide_class(bool along, int odd);
  void slide_edge(std::size_t a, std::size_t b);
  void let_snow_fall();
  void rest();

  std::size_t cell(int u, int v) const { return frame_.cell(u, v); }
  std::uint64_t number(int u, int v) const {
    return static_cast<std::uint64_t>(u) * static_cast<std::uint64_t>(frame_.length) + static_cast<std::uint64_t>(v);
  }
  bool inside(int& u, int& v) const;
  std::int32_t surface(std::size_t cell) const { return bedrock_[cell] + mobile_[cell]; }

  // Of the step under way.
  const SnowLaw* law_ = nullptr;
  Executor* executor_ = nullptr;
  SnowLayers* layers_ = nullptr;
  const std::int32_t* bedrock_ = nullptr;
  std::int32_t* mobile_ = nullptr;
  Extent extent_;
  Boundary boundary_ = Boundary::torus;
  double inflow_ = 0;
  Radii radii_;
  WindFrame frame_;
  StepKey key_;
  std::int64_t tangent_24_ = 0;
  StepReport report_;

  // Weather of the step, one value a cell.
  std::vector<std::int64_t> height_, scratch_, smooth_, around_;
  std::vector<float> relative_;        ///< surface over the smoothed surface, slabs
  std::vector<float> speed_;           ///< local wind, m/s
  std::vector<std::uint8_t> dark_;     ///< 1 in the wind shadow
  std::vector<std::uint32_t> chance_;  ///< to lift, of 65536
  std::mutex mutex_;
  std::vector<Batch> batches_;
  std::vector<std::uint32_t> order_;
};

}  // namespace erg
