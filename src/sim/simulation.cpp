#include "sim/simulation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/make_executor.h"
#include "sim/run_check.h"

namespace erg::sim {

using compute::ExecutorOptions;
using forcing::Forcing;
using models::StepReport;

namespace {

ExecutorOptions executor_options(const RunValues& run) {
  ExecutorOptions options;
  options.name = run.executor;
  options.threads = run.threads;
  options.sweeps = run.sweeps;
  return options;
}

/// Whether one of the values that are read only at the start differs.
bool start_differs(const ParameterValues& running, const ParameterValues& wanted) {
  return std::ranges::any_of(running.declared(), [&](const Parameter& parameter) {
    return parameter.at_start && running.value(parameter.key) != wanted.value(parameter.key);
  });
}

}  // namespace

bool needs_new_terrain(const Config& running, const Config& wanted) {
  return running.model != wanted.model || std::ranges::any_of(config_groups(), [&](const ConfigGroup& group) {
           return start_differs(running.*group.values, wanted.*group.values);
         });
}

Simulation::Simulation(Config config, const HeightPicture* picture, const HeightPicture* model_picture)
    : config_(std::move(config)) {
  start();
  state_.terrain = build_scene(config_, model_->quantum(), picture);
  begin_model(model_picture);
}

Simulation::Simulation(Config config, RunState state) : config_(std::move(config)), state_(std::move(state)) {
  start();
  check_state(config_, model_->quantum(), state_);
  begin_model(nullptr);
}

void Simulation::begin_model(const HeightPicture* picture) {
  Grid<float> resampled;
  model_->prepare(
      {run_.seed, weather(0), picture != nullptr ? &on_grid(*picture, state_.terrain.extent(), resampled) : nullptr});
  model_->begin(state_.terrain);
}

void Simulation::start() {
  check_config(config_);
  type_ = &models::find_model(config_.model);
  run_ = run_binding().read(config_.run);
  model_ = type_->make(config_.parameters);
  executor_ = make_executor(executor_options(run_));
}

Forcing Simulation::last_wind() const { return weather(std::max<std::int64_t>(0, state_.step - 1)); }

Forcing Simulation::weather(std::int64_t step) const {
  Forcing now = config_.wind.at(step, run_.seed);
  const std::int64_t last = run_.steps - 1;
  const double past = last > 0 ? static_cast<double>(step) / static_cast<double>(last) : 0.0;
  for (const forcing::Channel& channel : forcing::channels()) {
    if (channel.over_run != nullptr) now.*channel.now = (config_.weather.*channel.over_run).at(past);
  }
  return now;
}

StepReport Simulation::step() {
  if (finished()) return {};
  if (edited_) {
    check_edit();
    if (ledger_problem(state_.terrain)) {
      throw InputError("terrain", "it was edited, and the edit was not booked", "call book_edit after edit_terrain");
    }
    edited_ = false;
  }
  const StepKey key{run_.seed, static_cast<std::uint64_t>(state_.step)};
  const StepReport report = model_->step(state_.terrain, wind(), key, *executor_);
  state_.totals += report;
  ++state_.step;
  if (flux_) flux_->stepped();
  return report;
}

void Simulation::keep_trajectories(int count) {
  trajectories_wanted_ = count;
  model_->keep_trajectories(count);
}

void Simulation::watch_flux(bool wanted) {
  if (wanted == (flux_ != nullptr)) return;
  flux_ = wanted ? std::make_unique<FluxWatch>(state_.terrain.extent()) : nullptr;
  executor_->count_lifts(wanted ? &flux_->counts() : nullptr);
}

const Terrain& Simulation::terrain() {
  executor_->sync_to_host(state_.terrain);
  return state_.terrain;
}

Terrain& Simulation::edit_terrain() {
  executor_->sync_to_host(state_.terrain);
  edited_ = true;
  return state_.terrain;
}

void Simulation::check_edit() const {
  if (const auto problem = terrain_problem(config_, model_->quantum(), state_.terrain)) {
    throw InputError("terrain", "no run can go on from this edit: " + *problem, "mend it, and call book_edit again");
  }
}

void Simulation::book_edit() {
  check_edit();
  MassLedger& ledger = state_.terrain.ledger();
  if (!counts_in_range(ledger)) {
    throw InputError("terrain", "a count of its account is out of range", "leave the account to book_edit");
  }
  const std::int64_t change = state_.terrain.total_mobile() - ledger.expected();
  (change >= 0 ? ledger.in : ledger.out) += change >= 0 ? change : -change;
  edited_ = false;
  model_->edited(state_.terrain);
  wake();
}

void Simulation::change(Config config) {
  check_config(config);
  if (needs_new_terrain(config_, config)) {
    throw InputError("", "this change needs a new terrain", "create the terrain anew");
  }
  std::unique_ptr<models::Model> model = type_->make(config.parameters);
  // The executor stays unless it is what changes: threads and memory of its own take longer than a step.
  const ExecutorOptions options = executor_options(run_binding().read(config.run));
  std::unique_ptr<compute::Executor> other;
  if (options != executor_options(run_)) other = make_executor(options);
  executor_->sync_to_host(state_.terrain);
  config_ = std::move(config);
  run_ = run_binding().read(config_.run);
  model_ = std::move(model);
  if (other) {
    executor_ = std::move(other);
    if (flux_) executor_->count_lifts(&flux_->counts());
  }
  begin_model(nullptr);
  model_->keep_trajectories(trajectories_wanted_);
  wake();
}

void Simulation::wake() {
  state_.totals.finished = false;
  state_.totals.why_finished.clear();
}

const RunState& Simulation::state() {
  executor_->sync_to_host(state_.terrain);
  return state_;
}

}  // namespace erg::sim
