#include "cuda/cuda_executor.h"

namespace erg {
namespace {

/// Steps after which the terrain comes back unasked, so that a device that fails never costs more than these.
constexpr std::size_t most_remembered = 256;

}  // namespace

CudaExecutor::CudaExecutor(const ExecutorOptions& options, std::unique_ptr<DeviceCalls> calls) : cpu_(options) {
  try {
    device_ = std::make_unique<Device>(std::move(calls));
    slabs_ = std::make_unique<DeviceSlabs>(*device_, options.sweeps);
  } catch (const DeviceError& error) {
    notice_ = std::string("cuda: ") + error.what() + "; computing on the processor";
  }
}

StepReport CudaExecutor::step(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) {
  if (device_) {
    try {
      return step_on_device(terrain, law, wind, key);
    } catch (const DeviceError& error) {
      give_up(terrain, error.what());
    }
  }
  cpu_.count_lifts(lift_counts());
  return cpu_.step(terrain, law, wind, key);
}

StepReport CudaExecutor::step_on_device(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) {
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  if (!holds(terrain)) {
    loaded_ = nullptr;
    done_.clear();
    slabs_->load(terrain, frame);
    loaded_ = &terrain;
    revision_ = terrain.revision();
  }
  slabs_->count_lifts(lift_counts() != nullptr);
  const StepReport report = slabs_->step(law, frame, wind.strength, key);
  if (lift_counts() != nullptr) slabs_->take_lift_counts(*lift_counts());
  terrain.ledger().in += report.slabs_in;
  terrain.ledger().out += report.slabs_out;
  remember(law, wind, key);
  if (done_.size() >= most_remembered) settle(terrain);
  return report;
}

void CudaExecutor::remember(const SlabLaw& law, const WindNow& wind, StepKey key) {
  Done step{law, nullptr, wind, key};
  if (law.cover != nullptr) {
    const bool same = !done_.empty() && done_.back().cover && done_.back().law.cover_revision == law.cover_revision;
    step.cover = same ? done_.back().cover : std::make_shared<const CoverField>(*law.cover);
    step.law.cover = step.cover.get();
  }
  done_.push_back(std::move(step));
}

void CudaExecutor::settle(Terrain& terrain) {
  if (device_ && holds(terrain) && !done_.empty()) {
    try {
      slabs_->settle(terrain);
      revision_ = terrain.revision();
      done_.clear();
      return;
    } catch (const DeviceError& error) {
      give_up(terrain, error.what());
    }
  }
  cpu_.settle(terrain);
}

/// Hands over to the processor: it does again what the device has done since the terrain's layers were up to date.
void CudaExecutor::give_up(Terrain& terrain, const std::string& why) {
  notice_ = "cuda: " + why + "; computing on the processor from here on";
  if (holds(terrain)) {
    const MassLedger booked = terrain.ledger();
    for (const Done& step : done_) cpu_.step(terrain, step.law, step.wind, step.key);
    terrain.ledger() = booked;
  }
  done_.clear();
  loaded_ = nullptr;
  slabs_.reset();
  device_.reset();
}

}  // namespace erg
