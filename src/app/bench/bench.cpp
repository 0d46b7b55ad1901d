#include "app/bench/bench.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>

#include "app/bench/model_stage.h"
#include "core/units.h"
#include "models/model.h"
#include "process/allowance.h"
#include "sim/make_executor.h"
#include "sim/simulation.h"

namespace erg::app {

using compute::ExecutorOptions;
using models::ModelType;
using sim::Config;

namespace {

constexpr int hashed_steps = 2;        // also warms caches up
constexpr double turn_seconds = 0.15;  // short, so that all share the machine's good and bad moments
constexpr std::uint64_t bench_seed = 1;

/// An executor at work on a scene.
class Contestant {
 public:
  Contestant(const ModelScene& scene, const ExecutorOptions& options, BenchRow row)
      : row_(std::move(row)), run_(scene, options) {}

  void run_hashed_steps() {
    for (int i = 0; i < hashed_steps; ++i) run_.step();
    row_.nx = run_.terrain().nx();
    row_.ny = run_.terrain().ny();
    row_.executor = run_.executor().name();
    row_.threads = run_.executor().threads();
    row_.hash = state_hash(run_.terrain());
  }

  void take_turn() {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::int64_t polls = 0;
    double seconds = 0;
    do {
      polls += run_.step();
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    } while (seconds < turn_seconds);
    rates_.push_back(static_cast<double>(polls) / seconds);
  }

  const BenchRow& row() const { return row_; }
  /// Polls a second in each turn.
  const std::vector<double>& rates() const { return rates_; }

 private:
  BenchRow row_;
  ModelRun run_;
  std::vector<double> rates_;
};

/// What is measured beside serial on `threads` threads, and where `beside_one` on one thread too.
std::vector<ExecutorOptions> measured_options(const BenchOptions& options, bool beside_one) {
  const int threads = bench_threads(options);
  const std::vector<int> sweeps = options.sweeps > 0 ? std::vector<int>{options.sweeps} : std::vector<int>{8, 16};
  std::vector<ExecutorOptions> all;
  for (const int k : sweeps) {
    if (beside_one && threads > 1 && options.executor == "cpu") {
      all.push_back({.name = options.executor, .threads = 1, .sweeps = k});
    }
    all.push_back({.name = options.executor, .threads = threads, .sweeps = k});
  }
  return all;
}

using Contest = std::vector<std::unique_ptr<Contestant>>;

/// On one scene: serial first, then the given executors.
void enter(Contest& contest, const ModelScene& scene, const std::vector<ExecutorOptions>& executors) {
  const auto one = [&](const ExecutorOptions& options) {
    BenchRow row;
    row.scene = scene.name;
    row.bearing = scene.config.wind.at(0).bearing;
    row.sweeps = options.name == "serial" ? 0 : options.sweeps;
    contest.push_back(std::make_unique<Contestant>(scene, options, row));
  };
  one({.name = "serial", .threads = 1});
  for (const ExecutorOptions& options : executors) one(options);
}

/// The median over turns of how one ran beside another in the same turn: on a busy machine two best turns may stem from
/// moments that have nothing in common.
double median_ratio(const std::vector<double>& rates, const std::vector<double>& reference) {
  std::vector<double> ratios(rates.size());
  std::ranges::transform(rates, reference, ratios.begin(), std::divides<>());
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::ranges::nth_element(ratios, middle);
  return *middle;
}

/// Measures all in turns and sets each beside its references.
std::vector<BenchRow> measure_in_turns(const std::string& model, const Contest& contest) {
  std::fprintf(stderr, "bench: measuring %s\n", model.c_str());
  for (const auto& contestant : contest) contestant->run_hashed_steps();
  for (int i = 0; i < bench_turns; ++i) {
    for (const auto& contestant : contest) contestant->take_turn();
  }
  std::vector<BenchRow> rows;
  const std::vector<double>* serial = nullptr;
  for (const auto& contestant : contest) {
    BenchRow row = contestant->row();
    if (row.sweeps == 0) serial = &contestant->rates();
    row.model = model;
    row.polls_per_second = std::ranges::max(contestant->rates());
    row.serial_polls_per_second = std::ranges::max(*serial);
    row.times_serial = median_ratio(contestant->rates(), *serial);
    for (const auto& plain : contest) {
      const bool same_executor = plain->row().sweeps == row.sweeps && plain->row().threads == row.threads;
      if (plain->row().scene == contest.front()->row().scene && same_executor) {
        row.of_plain = median_ratio(contestant->rates(), plain->rates());
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<BenchRow> bench_model(const ModelType& model, const BenchOptions& options) {
  const std::vector<ModelScene> scenes = grow_scenes(model, options);
  Contest contest;
  for (const ModelScene& scene : scenes) enter(contest, scene, measured_options(options, &scene == scenes.data()));
  return measure_in_turns(model.info.key, contest);
}

}  // namespace

int bench_threads(const BenchOptions& options) {
  return options.threads > 0 ? options.threads : process::allowed_threads();
}

Config bench_config(const std::string& model, int side, const std::vector<std::string>& settings) {
  Config config(model);
  config.grid.set("nx", std::int64_t{side});
  config.grid.set("ny", std::int64_t{side});
  config.run.set("seed", static_cast<std::int64_t>(bench_seed));
  for (const std::string& setting : settings) sim::set_from_text(config, setting);
  return config;
}

std::vector<BenchRow> run_bench(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const std::string& model : options.models) {
    for (BenchRow& row : bench_model(models::find_model(model), options)) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace erg::app
