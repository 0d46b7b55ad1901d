#include "cuda/cuda_executor.h"

namespace erg {
namespace {

/// Steps after which the terrain comes back unasked, so that a device that fails never costs more than these.
constexpr std::size_t most_remembered = 256;

}  // namespace

CudaExecutor::CudaExecutor(const ExecutorOptions& options, std::unique_ptr<DeviceCalls> calls) : cpu_(options) {
  try {
    device_ = std::make_unique<Device>(std::move(calls));
  } catch (const DeviceError& error) {
    notice_ = std::string("cuda: ") + error.what() + "; computing on the processor";
  }
}

// --- steps ---

/// Once the device has failed the processor goes on from the same state.
template <typename OnDevice, typename OnProcessor>
auto CudaExecutor::carry_out(Terrain& terrain, const OnDevice& on_device, const OnProcessor& on_processor) {
  if (device_) {
    try {
      return on_device();
    } catch (const DeviceError& error) {
      give_up(terrain, error.what());
    }
  }
  cpu_.count_lifts(lift_counts());
  return on_processor();
}

StepReport CudaExecutor::step(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) {
  return carry_out(
      terrain, [&] { return step_on_device(terrain, law, wind, key); },
      [&] { return cpu_.step(terrain, law, wind, key); });
}

GrainReport CudaExecutor::fly_grains(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key,
                                     const GroundLook& look) {
  return carry_out(
      terrain, [&] { return fly_on_device(terrain, law, wind, key, look); },
      [&] { return cpu_.fly_grains(terrain, law, wind, key, look); });
}

StepReport CudaExecutor::drift_snow(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key) {
  return carry_out(
      terrain, [&] { return drift_on_device(terrain, snow, wind, key); },
      [&] { return cpu_.drift_snow(terrain, snow, wind, key); });
}

StepReport CudaExecutor::step_on_device(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) {
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  DeviceSlabs& slabs = held_as(slabs_, terrain, frame, sub_sweeps());
  slabs.count_lifts(lift_counts() != nullptr);
  const StepReport report = slabs.step(law, frame, wind.strength, key);
  if (lift_counts() != nullptr) slabs.take_lift_counts(*lift_counts());
  terrain.ledger().in += report.slabs_in;
  terrain.ledger().out += report.slabs_out;
  remember(again(law, wind, key), terrain);
  return report;
}

GrainReport CudaExecutor::fly_on_device(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key,
                                        const GroundLook& look) {
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  DeviceGrains& grains = held_as(grains_, terrain, frame);
  const GrainReport report = book_grains(terrain, grains.step(terrain, law, frame, key, look, lift_counts()));
  remember([this, law, wind, key](Terrain& ground) { cpu_.fly_grains(ground, law, wind, key, {}); }, terrain);
  return report;
}

StepReport CudaExecutor::drift_on_device(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key) {
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  DeviceSnow& drifting = held_as(snow_, terrain, frame, sub_sweeps());
  const StepReport report = drifting.step(terrain, snow, frame, key, lift_counts());
  terrain.ledger().in += report.slabs_in;
  terrain.ledger().out += report.slabs_out;
  remember([this, snow, wind, key](Terrain& ground) { cpu_.drift_snow(ground, snow, wind, key); }, terrain);
  return report;
}

// --- what the device holds ---

/// Gives back the memory of other ways to hold a terrain before it takes its own.
template <typename Held, typename... More>
Held& CudaExecutor::held_as(std::unique_ptr<Held>& held, Terrain& terrain, const WindFrame& frame, More... more) {
  if (held && holds(terrain)) return *held;
  bring_back(terrain);
  forget();
  std::unique_ptr<Held> kept = std::move(held);
  free_all();
  held = kept ? std::move(kept) : std::make_unique<Held>(*device_, more...);
  held->load(terrain, frame);
  take_up(terrain);
  return *held;
}

void CudaExecutor::free_all() {
  slabs_.reset();
  grains_.reset();
  snow_.reset();
}

bool CudaExecutor::holds(const Terrain& terrain) const {
  return stamp_ == terrain.stamp() && (slabs_ || fields_stamp_ == terrain.fields_stamp());
}

void CudaExecutor::take_up(const Terrain& terrain) {
  stamp_ = terrain.stamp();
  fields_stamp_ = terrain.fields_stamp();
}

void CudaExecutor::forget() {
  stamp_ = 0;
  done_.clear();
  cover_.reset();
}

/// The cover may change before the step is done again: it needs one of its own, as long as the cover stays the same.
CudaExecutor::Again CudaExecutor::again(const SlabLaw& law, const WindNow& wind, StepKey key) {
  if (law.cover == nullptr) {
    cover_.reset();
  } else if (!cover_ || cover_stamp_ != law.cover->stamp()) {
    cover_ = std::make_shared<const Cover>(*law.cover);
    cover_stamp_ = law.cover->stamp();
  }
  return [this, law, cover = cover_, wind, key](Terrain& terrain) {
    SlabLaw same = law;
    same.cover = cover.get();
    cpu_.step(terrain, same, wind, key);
  };
}

void CudaExecutor::remember(Again step, Terrain& terrain) {
  done_.push_back(std::move(step));
  if (done_.size() >= most_remembered) settle(terrain);
}

/// Brings the terrain back if the device has changed it.
void CudaExecutor::bring_back(Terrain& terrain) {
  if (!holds(terrain) || done_.empty()) return;
  if (slabs_) slabs_->settle(terrain);
  if (grains_) grains_->settle(terrain);
  if (snow_) snow_->settle(terrain);
  take_up(terrain);
  done_.clear();
  cover_.reset();
}

void CudaExecutor::settle(Terrain& terrain) {
  if (device_) {
    try {
      bring_back(terrain);
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
    for (const Again& step : done_) step(terrain);
    terrain.ledger() = booked;
  }
  forget();
  free_all();
  device_.reset();
}

}  // namespace erg
