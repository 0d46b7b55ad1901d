// Drifting, bonding snow on a device, and its time steps there: the phases of transport/snow_solver.h as kernels.
#pragma once

#include <cstdint>

#include "cuda/device_layers.h"
#include "cuda/device_tally.h"
#include "cuda/snow_plan.h"
#include "transport/executor.h"
#include "transport/snow_step.h"
#include "transport/snow_step_random.h"

namespace erg {

class DeviceSnow {
 public:
  /// `sweeps` as in ExecutorOptions.
  DeviceSnow(Device& device, int sweeps) : device_(device), sweeps_(sweeps), layers_(device) {}

  /// Brings the terrain, with the fields of SnowLayer, to the device. This and all that follows throws DeviceError.
  void load(const Terrain& terrain, const WindFrame& frame);
  /// One time step of what is loaded; `terrain` tells only what never changes between loads. `lift_counts`: as
  /// Executor::lift_counts. Throws InputError, before anything has changed, if the snow has grown too high to be
  /// counted.
  StepReport step(const Terrain& terrain, const SnowStep& snow, const WindFrame& frame, StepKey key,
                  Grid<std::int32_t>* lift_counts);
  /// Brings back the mobile layer and the fields. The terrain must be the one that was loaded.
  void settle(Terrain& terrain);

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
  void launch(SnowKernel kernel, const SnowPlan& plan) { device_.launch(kernel, cells(), plan); }

  Device& device_;
  int sweeps_;
  WindFrame frame_;
  std::int32_t base_ = 0;  // lowest bedrock
  bool relief_ = false;
  bool strength_shown_ = false;  // since the load
  StepRandom draws_;

  DeviceLayers layers_;
  DeviceLayer bedrock_;
  DeviceLayer mobile_;
  DeviceLayer loose_;
  DeviceLayer age_;  // floats, as the next two
  DeviceLayer landed_;
  DeviceLayer strength_;
  DeviceLayer lifted_;  // empty until lifts are counted
  DeviceArray<SnowLaw> law_;
  DeviceArray<std::uint32_t> bounds_;
  DeviceArray<std::uint32_t> heights_;
  DeviceArray<std::uint64_t> columns_;
  DeviceArray<std::uint64_t> sums_;
  DeviceArray<float> level_;
  DeviceArray<float> around_;
  DeviceArray<std::uint8_t> dark_;
  DeviceArray<SnowCell> cells_;
  DeviceArray<std::int16_t> over_;
  DeviceArray<int> offsets_;
  DeviceArray<SnowSweep> drawn_;
  DeviceArray<std::uint64_t> ring_;
  DeviceArray<std::uint64_t> aloft_;
  DeviceArray<std::uint32_t> left_;
  DeviceArray<TallyWord> tally_;
};

}  // namespace erg
