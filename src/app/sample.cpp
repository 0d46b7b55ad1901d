#include "app/sample.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <future>

#include "app/presets.h"
#include "app/progress.h"
#include "app/text_table.h"
#include "core/allowance.h"
#include "io/config_file.h"

namespace erg {
namespace {

SeedRun run_once(Config config, int seed, const std::vector<std::int64_t>& watch) {
  set_from_text(config, "run.seed=" + std::to_string(seed));
  Simulation simulation(config);
  MeasuredRun run(simulation, config.run.integer("steps"));
  SeedRun result;
  while (!run.finished()) {
    run.step();
    if (std::find(watch.begin(), watch.end(), simulation.step_count()) != watch.end()) {
      result.sd_at.emplace_back(simulation.step_count(), measure(simulation.terrain()).sd_slabs);
    }
  }
  result.end = run.statistics();
  return result;
}

}  // namespace

double Sample::mean() const {
  double sum = 0;
  for (const double value : values_) sum += value;
  return sum / static_cast<double>(values_.size());
}

double Sample::spread() const {
  if (values_.size() < 2) return 0;
  const double middle = mean();
  double squares = 0;
  for (const double value : values_) squares += (value - middle) * (value - middle);
  return std::sqrt(squares / static_cast<double>(values_.size() - 1));
}

std::string Sample::text(int digits) const {
  return fixed_text(mean(), digits) + " (" + fixed_text(spread(), digits) + ")";
}

Config thesis_config(const std::string& name) { return read_config(config_path("thesis/" + name)); }

std::vector<SeedRun> run_seeds(const Config& config, const std::string& executor, int seeds,
                               const std::vector<std::int64_t>& watch) {
  Config seeded = config;
  set_from_text(seeded, "run.executor=" + executor);
  const auto start = std::chrono::steady_clock::now();
  std::fprintf(stderr, "validate: %s, %s, %s ... ", config.title.c_str(), executor.c_str(),
               count_text(seeds, "seed").c_str());
  // As many runs as there are processors go side by side, each on one thread: none waits for another.
  set_from_text(seeded, "run.threads=1");
  const int side_by_side = allowed_threads();
  std::vector<SeedRun> runs;
  for (int first = 1; first <= seeds; first += side_by_side) {
    std::vector<std::future<SeedRun>> batch;
    for (int seed = first; seed < std::min(first + side_by_side, seeds + 1); ++seed) {
      batch.push_back(std::async(std::launch::async, run_once, seeded, seed, watch));
    }
    for (std::future<SeedRun>& run : batch) runs.push_back(run.get());
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::fprintf(stderr, "%s\n", duration_text(elapsed.count()).c_str());
  return runs;
}

}  // namespace erg
