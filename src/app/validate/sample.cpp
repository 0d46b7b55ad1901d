#include "app/validate/sample.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "app/cli/presets.h"
#include "app/cli/progress.h"
#include "app/cli/text_table.h"
#include "io/config/config_file.h"
#include "process/allowance.h"

namespace erg::app {

using sim::Config;
using sim::set_from_text;

namespace {

SeedRun run_once(Config config, int seed, const std::vector<std::int64_t>& watch) {
  set_from_text(config, "run.seed=" + std::to_string(seed));
  sim::Simulation simulation(config);
  MeasuredRun run(simulation, config.run.integer("steps"));
  SeedRun result;
  while (!run.finished()) {
    run.step();
    if (std::find(watch.begin(), watch.end(), simulation.step_count()) != watch.end()) {
      result.sd_at.emplace_back(simulation.step_count(), analysis::measure(simulation.terrain()).sd_slabs);
    }
  }
  result.end = run.statistics();
  return result;
}

}  // namespace

void share_jobs(int jobs, const std::function<void(int)>& job) {
  const int workers = std::min(jobs, process::allowed_threads());
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    for (int at = next++; at < jobs; at = next++) {
      try {
        job(at);
      } catch (...) {
        const std::scoped_lock lock(failing);
        failure = std::current_exception();
        next = jobs;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    try {
      for (int worker = 1; worker < workers; ++worker) threads.emplace_back(work);
    } catch (const std::system_error&) {
      // The system gives no more threads than these.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

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

Config thesis_config(const std::string& name) { return io::read_config(config_path("thesis/" + name)); }

std::vector<SeedRun> run_seeds(const Config& config, const std::string& executor, int seeds,
                               const std::vector<std::int64_t>& watch) {
  Config seeded = config;
  set_from_text(seeded, "run.executor=" + executor);
  const auto start = std::chrono::steady_clock::now();
  std::fprintf(stderr, "validate: %s, %s, %s ... ", config.title.c_str(), executor.c_str(),
               count_text(seeds, "seed").c_str());
  set_from_text(seeded, "run.threads=1");
  std::vector<SeedRun> runs = side_by_side<SeedRun>(seeds, [&](int job) { return run_once(seeded, job + 1, watch); });
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::fprintf(stderr, "%s\n", duration_text(elapsed.count()).c_str());
  return runs;
}

}  // namespace erg::app
