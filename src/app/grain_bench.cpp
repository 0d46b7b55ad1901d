#include "app/grain_bench.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "app/bench.h"
#include "app/text_table.h"
#include "models/grains.h"
#include "sim/simulation.h"

namespace erg {
namespace {

constexpr int first_steps = 3;  // enough for a rough bed
constexpr int measured_steps = 4;
constexpr int largest_bench_side = 256;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

GrainBenchRow measure_grains(const std::string& model, int side, const std::string& executor, int threads) {
  Simulation simulation(
      bench_config(model, side, {"run.executor=" + executor, "run.threads=" + std::to_string(threads)}));
  const auto& grain_model = dynamic_cast<const GrainModel&>(simulation.model());
  for (int step = 0; step < first_steps; ++step) simulation.step();
  std::int64_t polls = 0;
  std::int64_t grain_steps = 0;
  const double processor_start = processor_seconds();
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < measured_steps; ++step) {
    polls += simulation.step().polls;
    grain_steps += grain_model.flights().grain_steps;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double processor = processor_seconds() - processor_start;
  return {.model = model,
          .side = side,
          .executor = executor,
          .threads = simulation.executor().threads(),
          .polls_per_second = static_cast<double>(polls) / seconds,
          .grain_steps_per_second = static_cast<double>(grain_steps) / seconds,
          .grain_steps_per_cpu_second = static_cast<double>(grain_steps) / processor,
          .hash = state_hash(simulation.terrain())};
}

}  // namespace

std::vector<GrainBenchRow> bench_grains(const std::string& model, const BenchOptions& options) {
  const int threads = bench_threads(options);
  const int side = std::min(options.grid, largest_bench_side);
  std::fprintf(stderr, "bench: measuring %s, %d x %d cells\n", model.c_str(), side, side);
  std::vector<GrainBenchRow> rows{measure_grains(model, side, "serial", 1), measure_grains(model, side, "cpu", 1)};
  if (threads > 1) rows.push_back(measure_grains(model, side, "cpu", threads));
  if (options.executor == "cpu") return rows;
  // The same grid, for the bits, and all that was asked for, which would keep the processor busy for minutes.
  rows.push_back(measure_grains(model, side, options.executor, threads));
  if (options.grid > side) rows.push_back(measure_grains(model, options.grid, options.executor, threads));
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
         "thread's own\nprocessor time, which a busy machine does not hide.\n";
}

}  // namespace erg
