#include "app/cli/measured_run.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "analysis/crests.h"
#include "core/number_text.h"
#include "core/units.h"
#include "io/config/config_file.h"
#include "io/config/provenance.h"
#include "kernels/shadow.h"
#include "sim/step_time.h"

namespace erg::app {

using analysis::coarse_surface;
using analysis::Layer;
using models::StepReport;
using sim::Simulation;

namespace {

constexpr std::int64_t longest_watch = 500;       // steps
constexpr int most_blocks = 512;                  // a side: enough for where whole dunes stand
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
  migration_.observe(step, coarse_surface(simulation_.terrain(), Layer::surface, most_blocks),
                     simulation_.share_work());
}

RunStatistics MeasuredRun::statistics() {
  const Terrain& terrain = simulation_.terrain();
  RunStatistics numbers;
  numbers.shape = analysis::measure(terrain);
  const double fall = simulation_.model().shadow_fall(terrain.cell_size());
  numbers.shadow_fraction =
      analysis::shadow_fraction(kernels::shadow_map(terrain, simulation_.last_wind().bearing, fall));
  const analysis::CoarseSurface surface = coarse_surface(terrain, Layer::surface);
  numbers.spectrum = analysis::measure_spectrum(surface, simulation_.share_work());
  numbers.crest_spacing =
      analysis::crest_spacing(surface, simulation_.last_wind().mean_bearing(), simulation_.share_work());
  numbers.migration = migration_.velocity().value_or(analysis::Shift{});
  numbers.totals = simulation_.totals();
  numbers.diagnostics = simulation_.model().diagnostics();
  const auto cell_steps = static_cast<double>(terrain.extent().cells()) * static_cast<double>(simulation_.step_count());
  numbers.flux = cell_steps > 0 ? numbers.totals.travel / cell_steps : 0;
  numbers.ledger = terrain.ledger();
  numbers.mass_now = terrain.total_mobile();
  numbers.hash = state_hash(terrain);
  numbers.seconds = seconds_;
  numbers.polls_per_second = seconds_ > 0 ? static_cast<double>(polls_) / seconds_ : 0;
  return numbers;
}

namespace {

/// The numbers of `--stats` and, beside them, what they are measured in.
class NumbersWithUnits {
 public:
  /// `unit`: "" for what is no quantity, "1" for a pure number.
  template <typename Value>
  void add(const std::string& key, const char* unit, const Value& value) {
    object_[key] = value;
    if (*unit != 0) units_[key] = unit;
  }
  template <typename Value>
  void add(const std::string& key, const char* unit, const std::optional<Value>& value) {
    value ? add(key, unit, *value) : add(key, unit, nullptr);
  }
  /// All of them, the units under "units" at the end.
  nlohmann::ordered_json finish() {
    object_["units"] = units_;
    return std::move(object_);
  }

 private:
  nlohmann::ordered_json object_;
  nlohmann::ordered_json units_;
};

void add_run(NumbersWithUnits& all, Simulation& simulation) {
  const Terrain& terrain = simulation.terrain();
  const sim::Config& config = simulation.config();
  all.add("version", "", io::program_version());
  all.add("title", "", config.title);
  all.add("model", "", config.model);
  all.add("nx", "cells", terrain.nx());
  all.add("ny", "cells", terrain.ny());
  all.add("cell_size", "m", terrain.cell_size());
  all.add("slab_height", "m", terrain.quantum());
  all.add("steps", "steps", simulation.step_count());
  const double seconds = sim::step_scale(config).seconds;
  all.add("days_a_step", "days", seconds > 0 ? std::optional(seconds / seconds_a_day) : std::nullopt);
  all.add("days", "days", seconds > 0 ? std::optional(sim::days_after(config, simulation.step_count())) : std::nullopt);
  all.add("wind_bearing", "deg", simulation.last_wind().bearing);
  all.add("wind_strength", simulation.model_type().info.strength_label.c_str(), simulation.last_wind().strength);
  all.add("seed", "", config.run.integer("seed"));
  all.add("executor", "", simulation.executor().name());
  all.add("threads", "1", simulation.executor().threads());
  all.add("instructions", "", compute::to_string(compute::wanted_instruction_set()));
  all.add("sweeps", "1", config.run.integer("sweeps"));
}

void add_numbers(NumbersWithUnits& all, const RunStatistics& numbers) {
  all.add("max_slabs", "slabs", numbers.shape.max_slabs);
  all.add("mean_slabs", "slabs", numbers.shape.mean_slabs);
  all.add("sd_slabs", "slabs", numbers.shape.sd_slabs);
  all.add("bare_fraction", "1", numbers.shape.bare_fraction);
  all.add("shadow_fraction", "1", numbers.shadow_fraction);
  all.add("mass_start", "slabs", numbers.ledger.start);
  all.add("mass_now", "slabs", numbers.mass_now);
  all.add("mass_in", "slabs", numbers.ledger.in);
  all.add("mass_out", "slabs", numbers.ledger.out);
  all.add("lifts", "slabs", numbers.totals.lifts);
  all.add("polls", "cells", numbers.totals.polls);
  all.add("flux", "slabs/step", numbers.flux);
  all.add("migration_x", "cells/step", numbers.migration.x);
  all.add("migration_y", "cells/step", numbers.migration.y);
  all.add("wavelength", "cells", numbers.spectrum.wavelength);
  all.add("crest_spacing", "cells", numbers.crest_spacing);
  all.add("crest_bearing", "deg", numbers.spectrum.crest_bearing);
  all.add("alignment", "1", numbers.spectrum.alignment);
  all.add("state_hash", "", hash_text(numbers.hash));
  all.add("seconds", "s", numbers.seconds);
  all.add("polls_per_second", "cells/s", numbers.polls_per_second);
}

}  // namespace

std::string statistics_json(Simulation& simulation, const RunStatistics& numbers) {
  NumbersWithUnits all;
  add_run(all, simulation);
  add_numbers(all, numbers);
  for (const models::Diagnostic& diagnostic : numbers.diagnostics) {
    all.add(diagnostic.key, diagnostic.unit.empty() ? "1" : diagnostic.unit.c_str(), diagnostic.value);
  }
  if (simulation.finished()) all.add("why_finished", "", simulation.totals().why_finished);
  nlohmann::ordered_json object = all.finish();
  object["config"] = nlohmann::ordered_json::parse(io::config_text(simulation.config()));
  return object.dump(2) + "\n";
}

}  // namespace erg::app
