// Carries out the snow law on a terrain: what a time step of drifting, bonding snow does.
//
// A step has four phases. *Transport rates*: the smoothed surface, the wind over it, the wind shadow, and from them
// each cell's chances, hops and height for this step. *Flights*: on an executor without sub-sweeps one slab after the
// other in random order, each seeing what the last one left (snow_one_by_one.h); else K sub-sweeps over lines that
// follow the wind, on all threads. *Slides*: loose snow down too steep edges, class by class of edges that share no
// cell. *Rest*: snow falls, bonds and ages. Both ways use the rules of snow_cell.h and snow_ground.h; results depend on
// no number of threads and no instruction set.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "compute/aligned_vector.h"
#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "models/snow/snow_ground.h"
#include "models/snow/snow_planes.h"
#include "models/snow/snow_solver.h"
#include "models/snow/snow_step.h"
#include "models/snow/snow_step_random.h"

namespace erg::models {

class SnowOnProcessor : public SnowSolver {
 public:
  explicit SnowOnProcessor(compute::InstructionSet instructions = compute::wanted_instruction_set())
      : kernels_(snow_kernels(instructions)) {}

  // It works on the terrain's own layers.
  bool holds_fields() const override { return true; }
  void load(const Terrain& terrain, const forcing::WindFrame& frame) override;
  void sync_to_host(Terrain&) override {}
  /// On the threads of `executor`, in as many sub-sweeps as it has. The terrain is up to date afterwards.
  StepReport step(Terrain& terrain, const SnowStep& snow, const forcing::Forcing& wind, StepKey key,
                  compute::Executor& executor) override;

 private:
  void begin(Terrain& terrain, const SnowStep& snow, const forcing::Forcing& wind, StepKey key);
  void point_at_layers(Terrain& terrain);
  void turn_into_wind(const SnowLaw& law);
  void make_room(std::size_t cells);
  void for_rows(const std::function<void(int y)>& work);

  // Transport rates.
  void measure_heights();
  void find_shadow(double shadow_fall);
  void shade_lines(const SnowShadow& shadow, int first, int lines);
  void find_rates(SnowRadii radii);
  std::uint32_t find_rates_of(int begin, int end, SnowRadii radii);

  // Flights in sub-sweeps.
  void fly_in_sweeps();
  void find_walls();
  void lay_out_ahead();
  void make_strips();
  void for_strips(const std::function<void(SnowStrip& strip)>& work);
  void bring_down();

  void slide();
  void slide_class(bool along, int odd);
  void slide_in_row(int y, int first);
  void slide_to_next(int y);
  void let_snow_fall();

  const SnowKernels& kernels_;

  // Of the step under way.
  compute::Executor* executor_ = nullptr;
  forcing::WindFrame frame_;
  SnowGround ground_;
  SnowPlanes planes_;
  StepKey key_;
  StepReport report_;
  std::mutex mutex_;  ///< of what threads find out

  std::vector<std::int32_t> loose_;  ///< of the terrain's cells

  std::int32_t relief_ = 0;                       ///< slabs from the lowest surface to the highest
  compute::AlignedVector<std::uint16_t> height_;  ///< SnowPlanes, as what follows
  compute::AlignedVector<std::uint8_t> dark_;
  compute::AlignedVector<FlightCell> cells_;
  compute::AlignedVector<std::uint32_t> chances_;
  compute::AlignedVector<std::uint16_t> powers_;
  compute::AlignedVector<std::int16_t> over_;
  std::uint32_t longest_mean_hop_ = 0;  ///< 1/64 rows
  StepRandom random_;
  compute::AlignedVector<std::int16_t> ahead_;
  std::vector<int> least_moved_;
  compute::AlignedVector<std::int16_t> moved_;
  compute::AlignedVector<std::uint64_t> aloft_;
  compute::AlignedVector<std::uint64_t> handed_over_;
  std::vector<SnowStrip> strips_;
  std::vector<std::uint16_t> lists_;
  std::vector<int> counts_;
};

}  // namespace erg::models
