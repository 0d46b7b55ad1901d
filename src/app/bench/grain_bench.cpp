#include "app/bench/grain_bench.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>

#include "app/bench/bench.h"
#include "app/cli/text_table.h"
#include "models/model.h"
#include "sim/simulation.h"

namespace erg::app {
namespace {

constexpr int first_steps = 3;  // enough for a rough bed
constexpr int measured_steps = 6;
constexpr int largest_bench_side = 256;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A number that the model tells of its last step; 0 where it does not.
double read(const models::Model& model, const std::string& key) {
  for (const models::Diagnostic& diagnostic : model.diagnostics()) {
    if (diagnostic.key == key) return diagnostic.value;
  }
  return 0;
}

/// An executor at work on a bed of its own.
class GrainContestant {
 public:
  GrainContestant(const std::string& model, int side, const std::string& executor, int threads)
      : simulation_(bench_config(model, side, {"run.executor=" + executor, "run.threads=" + std::to_string(threads)})) {
    for (int step = 0; step < first_steps; ++step) simulation_.step();
    row_.model = model;
    row_.side = side;
    row_.executor = executor;
    row_.threads = simulation_.executor().threads();
  }

  /// One step; the best of all counts.
  void measure_step() {
    const double processor_start = processor_seconds();
    const auto start = std::chrono::steady_clock::now();
    const auto polls = static_cast<double>(simulation_.step().polls);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double processor = processor_seconds() - processor_start;
    const double grain_steps = read(simulation_.model(), "grain_steps");
    row_.polls_per_second = std::max(row_.polls_per_second, polls / seconds);
    row_.grain_steps_per_second = std::max(row_.grain_steps_per_second, grain_steps / seconds);
    row_.grain_steps_per_cpu_second = std::max(row_.grain_steps_per_cpu_second, grain_steps / processor);
  }

  GrainBenchRow row() {
    row_.hash = state_hash(simulation_.terrain());
    return row_;
  }

 private:
  sim::Simulation simulation_;
  GrainBenchRow row_;
};

}  // namespace

std::vector<GrainBenchRow> bench_grains(const std::string& model, const BenchOptions& options) {
  const int threads = bench_threads(options);
  const int side = std::min(options.grid, largest_bench_side);
  std::fprintf(stderr, "bench: measuring %s, %d x %d cells\n", model.c_str(), side, side);
  std::vector<std::unique_ptr<GrainContestant>> contest;
  const auto enter = [&](int cells, const std::string& executor, int count) {
    contest.push_back(std::make_unique<GrainContestant>(model, cells, executor, count));
  };
  enter(side, "serial", 1);
  enter(side, "cpu", 1);
  if (threads > 1) enter(side, "cpu", threads);
  if (options.executor != "cpu") {
    // The same grid, for the bits, and all that was asked for, which would keep the processor busy for minutes.
    enter(side, options.executor, threads);
    if (options.grid > side) enter(options.grid, options.executor, threads);
  }
  // In turns, so that each has its share of the machine's good moments.
  for (int step = 0; step < measured_steps; ++step) {
    for (const auto& contestant : contest) contestant->measure_step();
  }
  std::vector<GrainBenchRow> rows;
  for (const auto& contestant : contest) rows.push_back(contestant->row());
  return rows;
}

std::string grains_table(const std::vector<GrainBenchRow>& rows) {
  constexpr double million = 1e6;
  TextTable table;
  table.heading = {"model", "cells", "executor", "threads", "grains", "grain steps", "of a thread's own second"};
  for (const GrainBenchRow& row : rows) {
    table.rows.push_back({row.model, std::to_string(row.side) + " x " + std::to_string(row.side), row.executor,
                          std::to_string(row.threads), fixed_text(row.polls_per_second / million, 3),
                          fixed_text(row.grain_steps_per_second / million, 1),
                          fixed_text(row.grain_steps_per_cpu_second / million, 1)});
  }
  return table.aligned() +
         "\nMillion grains polled and million time steps of grains a second on the wall; time steps in a second of one "
         "thread's own\nprocessor time, which a busy machine does not hide. The best of a few steps in which all take "
         "turns.\n";
}

}  // namespace erg::app
