// Time steps of grains on any back end, and the bed that they fly over: whole counts of parcels in the wind's frame,
// which stays there between steps.
//
// A step is cut into sub-steps. Each takes a snapshot of the ground, polls a random part of the cells and flies their
// grains, resolves what impacts knocked loose, applies what came and went, and lets slopes slide. All rules stand in
// grain_bed_cell.h, one kernel each (grain_kernels.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "compute/executor.h"
#include "forcing/wind_frame.h"
#include "forcing/wind_schedule.h"
#include "kernels/frame_layers.h"
#include "models/grains/grain_step.h"
#include "models/grains/plan.h"

namespace erg::models {

/// Called with the ground that the flights of a step's last sub-step see; it may fly some of them once more.
using GroundLook = std::function<void(const SurfaceSnapshot& ground)>;

/// Flies the grains of one time step, lets their bed slide, creep and bond, and books in- and outflow. The same bits on
/// every executor. `look` may be empty.
GrainReport fly_grains(compute::Executor& executor, Terrain& terrain, const GrainStepLaw& law,
                       const forcing::Forcing& wind, StepKey key, const GroundLook& look);

class GrainSolver : public compute::Solver {
 public:
  explicit GrainSolver(compute::Backend& backend) : backend_(backend), layers_(backend) {}

  bool holds_fields() const override { return true; }
  /// Brings the mobile layer back and, where grains may have bonded or come free since the terrain was loaded, the
  /// field of bonded ones.
  void sync_to_host(Terrain& terrain) override;
  void load(const Terrain& terrain, const forcing::WindFrame& frame);
  /// One time step of what is loaded; `terrain` tells only what never changes between loads. `lift_counts`: as
  /// Executor::lift_counts.
  GrainCounters step(const Terrain& terrain, const GrainStepLaw& law, const forcing::WindFrame& frame, StepKey key,
                     const GroundLook& look, Grid<std::int32_t>* lift_counts);

 private:
  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  void allocate(std::size_t cells, const forcing::WindFrame& frame);
  void send_law(const GrainStepLaw& law);
  void prepare(const Terrain& terrain, const GrainStepLaw& law, bool counts_lifts);
  void run(const GrainStepLaw& law, double inflow, StepKey key, const GroundLook& look);

  void snapshot();
  void show_ground(const GroundLook& look);
  void slide_slopes(ReposeSteps repose);
  bool has_slid();
  void launch_edges(const compute::KernelOf<grain::Plan>& kernel, int way);

  compute::Backend& backend_;
  forcing::WindFrame frame_;
  std::int32_t lowest_ = 0;  // bedrock
  bool may_bond_ = false;    // some grains are bonded, or were since the load
  grain::Plan plan_;         // of the step under way
  std::optional<GrainLaw> sent_law_;
  std::shared_ptr<const std::vector<float>> sent_shelter_;

  kernels::FrameLayers layers_;
  kernels::FrameLayer bedrock_;
  kernels::FrameLayer mobile_;
  kernels::FrameLayer bonded_;
  kernels::FrameLayer departures_;
  kernels::FrameLayer arrivals_;
  kernels::FrameLayer disturbed_;
  kernels::FrameLayer lifted_;  // empty until lifts are counted
  kernels::FrameLayer ejection_requests_;
  kernels::FrameLayer ejection_speed_;
  compute::Buffer<float> shelter_;
  compute::Buffer<GroundPoint> points_;
  compute::Buffer<GrainLaw> law_;
  compute::Buffer<std::uint32_t> bounds_;  // highest, ~lowest, slid
  compute::Buffer<compute::CounterWord> counters_;
};

}  // namespace erg::models
