// How fast single grains fly: whole steps, grains and their time steps.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace erg::app {

struct BenchOptions;

/// One measured executor. Rates count the processor time that the program used, on all threads together, as well as the
/// time on the wall: the former also tells on a machine that is busy otherwise.
struct GrainBenchRow {
  std::string model;
  int side = 0;  ///< cells
  std::string executor;
  int threads = 1;
  double polls_per_second = 0;            ///< on the wall
  double grain_steps_per_second = 0;      ///< on the wall
  double grain_steps_per_cpu_second = 0;  ///< of one thread's time
  std::uint64_t hash = 0;                 ///< of the terrain after the same steps in every row
};

/// Measures a model of single grains on one thread, on more, and on the executor that the options name.
std::vector<GrainBenchRow> bench_grains(const std::string& model, const BenchOptions& options);

/// The rows as a table with its legend.
std::string grains_table(const std::vector<GrainBenchRow>& rows);

}  // namespace erg::app
