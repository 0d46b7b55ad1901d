// The executor "cuda": the sub-sweeps of `cpu` on a graphics card, with the same bits. The terrain stays on the device
// between steps; only what is asked for comes back.
//
// Where the device is missing, full or fails, the processor goes on from the same state, and take_notice says so. For
// that the executor remembers the laws of the steps since the terrain was last brought back: the processor does those
// steps again, which gives the same bits.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cuda/device_slabs.h"
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
  void settle(Terrain& terrain) override;
  void for_pieces(std::int64_t items, const std::function<void(std::int64_t begin, std::int64_t end)>& work) override {
    cpu_.for_pieces(items, work);
  }
  std::string take_notice() override { return std::exchange(notice_, {}); }

  /// The device's name; empty without one.
  std::string device_name() const { return device_ ? device_->name() : std::string(); }

 private:
  /// A step that the device has done, as the processor would need it to do it again.
  struct Done {
    SlabLaw law;
    std::shared_ptr<const CoverField> cover;
    WindNow wind;
    StepKey key;
  };

  StepReport step_on_device(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key);
  void remember(const SlabLaw& law, const WindNow& wind, StepKey key);
  void give_up(Terrain& terrain, const std::string& why);
  bool holds(const Terrain& terrain) const { return loaded_ == &terrain && revision_ == terrain.revision(); }

  ParallelExecutor cpu_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<DeviceSlabs> slabs_;  // freed before the device
  std::string notice_;
  const Terrain* loaded_ = nullptr;
  std::uint64_t revision_ = 0;
  std::vector<Done> done_;  // since the terrain's layers were up to date
};

}  // namespace erg
