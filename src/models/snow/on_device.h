// Drifting, bonding snow on a device, and its time steps there: the phases of models/snow/on_processor.h as kernels.
#pragma once

#include <cstdint>

#include "kernels/frame_layers.h"
#include "models/snow/plan.h"
#include "models/snow/snow_solver.h"
#include "models/snow/snow_step_random.h"

namespace erg::models {

class SnowOnDevice : public SnowSolver {
 public:
  /// `sweeps` as in ExecutorOptions.
  SnowOnDevice(compute::Backend& backend, int sweeps) : backend_(backend), sweeps_(sweeps), layers_(backend) {}

  bool holds_fields() const override { return true; }
  void load(const Terrain& terrain, const forcing::WindFrame& frame) override;
  StepReport step(Terrain& terrain, const SnowStep& snow, const forcing::Forcing& wind, StepKey key,
                  compute::Executor& executor) override;
  /// Brings back the mobile layer and the fields.
  void sync_to_host(Terrain& terrain) override;

 private:
  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  void allocate(std::size_t cells);
  void turn(const forcing::WindFrame& frame);
  SnowPlan step_plan(const Terrain& terrain, const SnowStep& snow, StepKey key);
  void count_lifts(SnowPlan& plan, bool wanted);
  void measure(SnowPlan& plan, const SnowRadii& radii);
  void take_means(SnowPlan plan, int radius, bool twice, float* means);
  void send_draws(SnowPlan& plan, std::uint32_t longest_mean_hop, StepKey key);
  void fly(SnowPlan plan);
  void slide(SnowPlan plan, StepKey key);
  void slide_class(SnowPlan& plan, const SnowEdges& edges);
  void rest(SnowPlan& plan, const SnowStep& snow);
  void launch(const compute::KernelOf<SnowPlan>& kernel, const SnowPlan& plan) {
    backend_.launch(kernel, cells(), plan);
  }

  compute::Backend& backend_;
  int sweeps_;
  forcing::WindFrame frame_;
  std::int32_t base_ = 0;  // lowest bedrock
  bool relief_ = false;
  bool strength_shown_ = false;  // since the load
  StepRandom draws_;

  kernels::FrameLayers layers_;
  kernels::FrameLayer bedrock_;
  kernels::FrameLayer mobile_;
  kernels::FrameLayer loose_;
  kernels::FrameLayer age_;  // floats, as the next two
  kernels::FrameLayer landed_;
  kernels::FrameLayer strength_;
  kernels::FrameLayer lifted_;  // empty until lifts are counted
  compute::Buffer<SnowLaw> law_;
  compute::Buffer<std::uint32_t> bounds_;
  compute::Buffer<std::uint32_t> heights_;
  compute::Buffer<std::uint64_t> columns_;
  compute::Buffer<std::uint64_t> sums_;
  compute::Buffer<float> level_;
  compute::Buffer<float> around_;
  compute::Buffer<std::uint8_t> dark_;
  compute::Buffer<SnowCell> cells_;
  compute::Buffer<std::int16_t> over_;
  compute::Buffer<int> offsets_;
  compute::Buffer<SnowSweep> drawn_;
  compute::Buffer<std::uint64_t> ring_;
  compute::Buffer<std::uint64_t> aloft_;
  compute::Buffer<std::uint32_t> left_;
  compute::Buffer<compute::CounterWord> counters_;
};

}  // namespace erg::models
