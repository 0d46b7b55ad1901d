#include "session/step_cost.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

#include "io/checkpoint/start_simulation.h"

namespace erg::session {

using sim::Config;

namespace {

constexpr std::int64_t most_cells = 64;  // a side, of the terrain that is measured

int threads_of(const Config& config) {
  if (config.run.text("executor") == "serial") return 1;
  const auto all = static_cast<std::int64_t>(std::max(1u, std::thread::hardware_concurrency()));
  const std::int64_t wanted = config.run.integer("threads");
  return static_cast<int>(wanted > 0 ? std::min(wanted, all) : all);
}

}  // namespace

double times_the_measured_terrain(const Config& config) {
  double times = 1;
  for (const char* const side : {"nx", "ny"}) {
    const std::int64_t wanted = config.grid.integer(side);
    times *= static_cast<double>(wanted) / static_cast<double>(std::min(wanted, most_cells));
  }
  return times / threads_of(config);
}

std::optional<double> measure_step(const Config& config) {
  using Clock = std::chrono::steady_clock;
  Config small = config;
  for (const char* const side : {"nx", "ny"}) small.grid.set(side, std::min(config.grid.integer(side), most_cells));
  small.run.set("threads", std::int64_t{1});
  try {
    sim::Simulation simulation = io::start_simulation(small);
    simulation.step();  // whatever is made once
    const Clock::time_point begin = Clock::now();
    simulation.step();
    return std::chrono::duration<double>(Clock::now() - begin).count() * times_the_measured_terrain(config);
  } catch (const std::exception&) {
    return std::nullopt;  // CREATE will say what stands against it
  }
}

std::optional<double> StepCost::of(const Config& config) {
  using namespace std::chrono_literals;
  if (measuring_.valid()) {
    if (measuring_.wait_for(0s) != std::future_status::ready) return std::nullopt;
    seconds_ = measuring_.get();
  }
  if (measured_ == config) return seconds_;
  measured_ = config;
  seconds_.reset();
  try {
    measuring_ = std::async(std::launch::async, measure_step, config);
  } catch (const std::system_error&) {  // no thread to be had
  }
  return std::nullopt;
}

}  // namespace erg::session
