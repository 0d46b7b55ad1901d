// The executor "cuda": the sub-sweeps of `cpu`, the flights of grains and the drift of snow on a graphics card, with
// the same bits. The terrain stays on the device between steps; only what is asked for comes back.
//
// Where the device is missing, full or fails, the processor goes on from the same state, and take_notice says so. For
// that the executor remembers the steps since the terrain was last brought back: the processor does those steps again,
// which gives the same bits.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cuda/device_grains.h"
#include "cuda/device_slabs.h"
#include "cuda/device_snow.h"
#include "transport/parallel_executor.h"

namespace erg {

class CudaExecutor : public Executor {
 public:
  /// options as for ParallelExecutor. Without a device that works it is `cpu` from the start.
  CudaExecutor(const ExecutorOptions& options, std::unique_ptr<DeviceCalls> calls);

  std::string name() const override { return device_ ? "cuda" : "cpu"; }
  int threads() const override { return cpu_.threads(); }
  int sub_sweeps() const override { return cpu_.sub_sweeps(); }
  StepReport step(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) override;
  GrainReport fly_grains(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key,
                         const GroundLook& look) override;
  StepReport drift_snow(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key) override;
  void settle(Terrain& terrain) override;
  void for_pieces(std::int64_t items, const std::function<void(std::int64_t begin, std::int64_t end)>& work) override {
    cpu_.for_pieces(items, work);
  }
  std::string take_notice() override { return std::exchange(notice_, {}); }

  /// The device's name; empty without one.
  std::string device_name() const { return device_ ? device_->name() : std::string(); }

 private:
  /// A step that the device has done, to be done again by the processor.
  using Again = std::function<void(Terrain& terrain)>;

  template <typename OnDevice, typename OnProcessor>
  auto carry_out(Terrain& terrain, const OnDevice& on_device, const OnProcessor& on_processor);
  StepReport step_on_device(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key);
  GrainReport fly_on_device(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key,
                            const GroundLook& look);
  StepReport drift_on_device(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key);
  Again again(const SlabLaw& law, const WindNow& wind, StepKey key);
  void remember(Again step, Terrain& terrain);
  void bring_back(Terrain& terrain);
  /// `held` with the terrain on the device, made of the device and `more` where there is none.
  template <typename Held, typename... More>
  Held& held_as(std::unique_ptr<Held>& held, Terrain& terrain, const WindFrame& frame, More... more);
  void take_up(const Terrain& terrain);
  void free_all();
  void forget();
  void give_up(Terrain& terrain, const std::string& why);
  bool holds(const Terrain& terrain) const;

  ParallelExecutor cpu_;
  std::unique_ptr<Device> device_;
  // What holds a terrain on the device: one of them at most. They are freed before the device.
  std::unique_ptr<DeviceSlabs> slabs_;
  std::unique_ptr<DeviceGrains> grains_;
  std::unique_ptr<DeviceSnow> snow_;
  std::string notice_;
  std::uint64_t stamp_ = 0;  // of the terrain that the device holds, if it holds one
  std::uint64_t fields_stamp_ = 0;
  std::vector<Again> done_;             // since the terrain's layers were up to date
  std::shared_ptr<const Cover> cover_;  // of the last of them
  std::uint64_t cover_stamp_ = 0;       // of what it is a copy of
};

}  // namespace erg
