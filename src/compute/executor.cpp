#include "compute/executor.h"

#include <bit>

namespace erg::compute {

Executor::Executor(const ExecutorOptions& options, std::unique_ptr<Backend> device, std::string notice)
    : options_(options),
      processor_(options.name == "serial" ? 1 : options.threads),
      device_(std::move(device)),
      notice_(std::move(notice)) {
  if (!std::has_single_bit(static_cast<unsigned>(options.sweeps)) || options.sweeps < 2 || options.sweeps > 64) {
    throw InputError("sweeps", std::to_string(options.sweeps) + " sub-sweeps a step", "use 2, 4, 8, 16, 32 or 64");
  }
}

std::string Executor::name() const {
  if (device_) return device_->name();
  return options_.name == "serial" ? "serial" : "cpu";
}

bool Executor::holds(const Terrain& terrain) const {
  return held_.ground == terrain.stamp() && solver_ &&
         (!solver_->holds_fields() || held_.fields == terrain.fields_stamp());
}

void Executor::clear() {
  held_ = {};
  stepped_ = false;
  log_.clear();
}

/// Brings the terrain back if the solver has changed it.
void Executor::bring_back(Terrain& terrain) {
  if (!stepped_ || !holds(terrain)) return;
  solver_->sync_to_host(terrain);
  clear();
  adopt(terrain);
}

void Executor::sync_to_host(Terrain& terrain) {
  if (device_) {
    try {
      return bring_back(terrain);
    } catch (const DeviceError& error) {
      fall_back_to_cpu(terrain, error.what());
    }
  }
  bring_back(terrain);
}

/// The processor does once more what the device has done since the terrain's layers were up to date.
void Executor::fall_back_to_cpu(Terrain& terrain, const std::string& why) {
  notice_ = device_->name() + ": " + why + "; computing on the processor from here on";
  const std::vector<LoggedStep> log = holds(terrain) ? std::move(log_) : std::vector<LoggedStep>{};
  clear();
  const MassLedger booked = terrain.ledger();
  Grid<std::int32_t>* const counted = std::exchange(lift_counts_, nullptr);
  const auto restore = [&] {
    terrain.ledger() = booked;
    lift_counts_ = counted;
  };
  try {
    solver_.reset();
    device_.reset();
    for (const LoggedStep& step : log) step(terrain);
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

}  // namespace erg::compute
