// Drifting, bonding snow on a device, and its time steps there: the phases of models/snow/on_processor.h as kernels.
#pragma once

#include <cstdint>

#include "kernels/frame_layers.h"
#include "models/snow/plan.h"
#include "models/snow/snow_solver.h"
#include "models/snow/snow_step_random.h"

namespace erg {

class SnowOnDevice : public SnowSolver {
 public:
  /// `sweeps` as in ExecutorOptions.
  SnowOnDevice(Backend& backend, int sweeps) : backend_(backend), sweeps_(sweeps), layers_(backend) {}

  bool holds_fields() const override { return true; }
  void load(const Terrain& terrain, const WindFrame& frame) override;
  StepReport step(Terrain& terrain, const SnowStep& snow, const Forcing& wind, StepKey key,
                  Executor& executor) override;
  /// Brings back the mobile layer and the fields.
  void sync_to_host(Terrain& terrain) override;

 private:
  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  void allocate(std::size_t cells);
  void turn(const WindFrame& frame);
  SnowPlan step_plan(const Terrain& terrain, const SnowStep& snow, StepKey key);
  void count_lifts(SnowPlan& plan, bool wanted);
  void measure(SnowPlan& plan, const SnowRadii& radii);
  void take_means(SnowPlan plan, int radius, bool twice, float* means);
  void send_draws(SnowPlan& plan, std::uint32_t longest_mean_hop, StepKey key);
  void fly(SnowPlan plan);
  void slide(SnowPlan plan, StepKey key);
  void slide_class(SnowPlan& plan, const SnowEdges& edges);
  void rest(SnowPlan& plan, const SnowStep& snow);
  void launch(const KernelOf<SnowPlan>& kernel, const SnowPlan& plan) { backend_.launch(kernel, cells(), plan); }

  Backend& backend_;
  int sweeps_;
  WindFrame frame_;
  std::int32_t base_ = 0;  // lowest bedrock
  bool relief_ = false;
  bool strength_shown_ = false;  // since the load
  StepRandom draws_;

  FrameLayers layers_;
  FrameLayer bedrock_;
  FrameLayer mobile_;
  FrameLayer loose_;
  FrameLayer age_;  // floats, as the next two
  FrameLayer landed_;
  FrameLayer strength_;
  FrameLayer lifted_;  // empty until lifts are counted
  Buffer<SnowLaw> law_;
  Buffer<std::uint32_t> bounds_;
  Buffer<std::uint32_t> heights_;
  Buffer<std::uint64_t> columns_;
  Buffer<std::uint64_t> sums_;
  Buffer<float> level_;
  Buffer<float> around_;
  Buffer<std::uint8_t> dark_;
  Buffer<SnowCell> cells_;
  Buffer<std::int16_t> over_;
  Buffer<int> offsets_;
  Buffer<SnowSweep> drawn_;
  Buffer<std::uint64_t> ring_;
  Buffer<std::uint64_t> aloft_;
  Buffer<std::uint32_t> left_;
  Buffer<CounterWord> counters_;
};

}  // namespace erg
