// A terrain on a device, and the time steps of grains there: the phases of transport/grain_phases.h as kernels.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cuda/device_layers.h"
#include "cuda/grain_plan.h"
#include "transport/grain_phases.h"

namespace erg {

class DeviceGrains : private GrainPhases {
 public:
  explicit DeviceGrains(Device& device) : device_(device), layers_(device) {}

  /// Brings the terrain to the device. This and all that follows throws DeviceError.
  void load(const Terrain& terrain, const WindFrame& frame);
  /// One time step of what is loaded; `terrain` tells only what never changes between loads. `lift_counts`: as
  /// Executor::lift_counts.
  GrainTally step(const Terrain& terrain, const GrainStepLaw& law, const WindFrame& frame, StepKey key,
                  const GroundLook& look, Grid<std::int32_t>* lift_counts);
  /// Brings back the mobile layer and, where grains may have bonded or come free since the terrain was loaded, the
  /// field of bonded ones. The terrain must be the one that was loaded.
  void settle(Terrain& terrain);

 private:
  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  void allocate(std::size_t cells, const WindFrame& frame);
  void turn(const WindFrame& frame);
  void send_law(const GrainStepLaw& law);

  void freeze() override;
  void fly(const GrainMoment& now) override;
  void let_in(const GrainMoment& now, double inflow) override;
  void show_ground(const GroundLook& look) override;
  void hand_out(const GrainMoment& now) override;
  void settle_accounts() override;
  void slide(const BedEdges& edges, int standing) override;
  bool has_slid() override;
  void creep(const BedEdges& edges, const GrainMoment& now) override;
  void bond(const GrainMoment& now) override;

  Device& device_;
  WindFrame frame_;
  std::int32_t lowest_ = 0;  // bedrock
  bool may_bond_ = false;    // some grains are bonded, or were since the load
  GrainPlan plan_;           // of the step under way
  std::optional<GrainLaw> law_on_device_;
  std::shared_ptr<const std::vector<float>> shelter_on_device_;

  DeviceLayers layers_;
  DeviceLayer bedrock_;
  DeviceLayer mobile_;
  DeviceLayer bonded_;
  DeviceLayer gone_;
  DeviceLayer come_;
  DeviceLayer stirred_;
  DeviceLayer lifted_;  // empty until lifts are counted
  DeviceLayer asked_;
  DeviceLayer asked_speed_;
  DeviceArray<float> shelter_;
  DeviceArray<GroundPoint> points_;
  DeviceArray<GrainLaw> law_;
  DeviceArray<std::uint32_t> bounds_;  // highest, ~lowest, slid
  DeviceArray<TallyWord> tally_;
};

}  // namespace erg
