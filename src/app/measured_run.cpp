#include "app/measured_run.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "analysis/crests.h"
#include "core/exact_text.h"
#include "io/provenance.h"
#include "wind/shadow.h"

namespace erg {
namespace {

constexpr std::int64_t longest_watch = 500;       // steps
constexpr std::int64_t longest_watch_pause = 10;  // steps: dunes move less than a cell a step

}  // namespace

MeasuredRun::MeasuredRun(Simulation& simulation, std::int64_t last_step, bool watch_migration)
    : simulation_(simulation), last_step_(last_step), watch_migration_(watch_migration) {
  const std::int64_t watch = std::clamp<std::int64_t>(last_step / 4, 1, longest_watch);
  watch_from_ = last_step - watch;
  watch_every_ = std::clamp<std::int64_t>(watch / 8, 1, longest_watch_pause);
  observe();
}

StepReport MeasuredRun::step() {
  const auto start = std::chrono::steady_clock::now();
  StepReport report = simulation_.step();
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  polls_ += report.polls;
  observe();
  return report;
}

void MeasuredRun::finish() {
  while (!finished()) step();
}

void MeasuredRun::observe() {
  const std::int64_t step = simulation_.step_count();
  if (!watch_migration_ || step < watch_from_) return;
  if ((last_step_ - step) % watch_every_ != 0) return;
  migration_.observe(step, coarse_surface(simulation_.terrain(), Layer::surface));
}

RunStatistics MeasuredRun::statistics() {
  const Terrain& terrain = simulation_.terrain();
  RunStatistics numbers;
  numbers.shape = measure(terrain);
  const double fall = simulation_.model().shadow_fall(terrain.cell_size());
  numbers.shadow_fraction = shadow_fraction(shadow_map(terrain, simulation_.last_wind().bearing, fall));
  const CoarseSurface surface = coarse_surface(terrain, Layer::surface);
  numbers.spectrum = measure_spectrum(surface);
  numbers.crest_spacing = crest_spacing(surface, simulation_.last_wind().mean_bearing());
  numbers.migration = migration_.velocity().value_or(Shift{});
  numbers.totals = simulation_.totals();
  numbers.readings = simulation_.model().readings();
  const auto cell_steps = static_cast<double>(terrain.extent().cells()) * static_cast<double>(simulation_.step_count());
  numbers.flux = cell_steps > 0 ? numbers.totals.travel / cell_steps : 0;
  numbers.ledger = terrain.ledger();
  numbers.mass_now = terrain.total_mobile();
  numbers.hash = state_hash(terrain);
  numbers.seconds = seconds_;
  numbers.polls_per_second = seconds_ > 0 ? static_cast<double>(polls_) / seconds_ : 0;
  return numbers;
}

std::string statistics_json(Simulation& simulation, const RunStatistics& numbers) {
  const Terrain& terrain = simulation.terrain();
  nlohmann::ordered_json object;
  object["version"] = program_version();
  object["title"] = simulation.config().title;
  object["model"] = simulation.config().model;
  object["nx"] = terrain.nx();
  object["ny"] = terrain.ny();
  object["cell_size"] = terrain.cell_size();
  object["slab_height"] = terrain.quantum();
  object["steps"] = simulation.step_count();
  object["seed"] = simulation.config().run.integer("seed");
  object["executor"] = simulation.executor().name();
  object["threads"] = simulation.executor().threads();
  object["instructions"] = to_string(wanted_instruction_set());
  object["sweeps"] = simulation.config().run.integer("sweeps");
  object["max_slabs"] = numbers.shape.max_slabs;
  object["mean_slabs"] = numbers.shape.mean_slabs;
  object["sd_slabs"] = numbers.shape.sd_slabs;
  object["bare_fraction"] = numbers.shape.bare_fraction;
  object["shadow_fraction"] = numbers.shadow_fraction;
  object["mass_start"] = numbers.ledger.start;
  object["mass_now"] = numbers.mass_now;
  object["mass_in"] = numbers.ledger.in;
  object["mass_out"] = numbers.ledger.out;
  object["lifts"] = numbers.totals.lifts;
  object["polls"] = numbers.totals.polls;
  object["flux"] = numbers.flux;
  object["migration_x"] = numbers.migration.x;
  object["migration_y"] = numbers.migration.y;
  object["wavelength"] = numbers.spectrum.wavelength;
  object["crest_spacing"] = numbers.crest_spacing;
  object["crest_bearing"] = numbers.spectrum.crest_bearing;
  object["state_hash"] = hash_text(numbers.hash);
  object["seconds"] = numbers.seconds;
  object["polls_per_second"] = numbers.polls_per_second;
  for (const Reading& reading : numbers.readings) object[reading.key] = reading.value;
  if (simulation.finished()) object["why_finished"] = simulation.totals().why_finished;
  return object.dump(2) + "\n";
}

}  // namespace erg
