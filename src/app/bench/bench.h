// How fast the executors are, on dunes that have grown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/config.h"

namespace erg::app {

/// What `erg bench` was asked for.
struct BenchOptions {
  int grid = 1024;                  ///< cells a side
  std::vector<std::string> models;  ///< keys
  std::string executor = "cpu";     ///< measured beside serial: "cpu" or "cuda"
  int threads = 0;                  ///< measured beside one thread; 0: one for each processor
  int sweeps = 0;                   ///< K; 0: 8 and 16
  double bearing = 270;             ///< degrees
};

/// How much an oblique wind is turned from the straight one, degrees.
inline constexpr double oblique_turn = -30;

/// How many threads are measured beside one.
int bench_threads(const BenchOptions& options);

/// What a bench grows: a model as it starts, on `side` x `side` cells, always with the same seed, and what `--set`
/// would change of it.
sim::Config bench_config(const std::string& model, int side, const std::vector<std::string>& settings = {});

/// Turns that each of those who are measured takes.
inline constexpr int bench_turns = 20;

/// One measured executor on one scene.
struct BenchRow {
  std::string model;
  std::string scene;  ///< of ModelInfo::bench_scenes
  int nx = 0;
  int ny = 0;
  std::string executor;
  int threads = 1;
  double bearing = 270;                ///< degrees
  int sweeps = 0;                      ///< 0 for serial, which has none
  double polls_per_second = 0;         ///< in the best turn
  double serial_polls_per_second = 0;  ///< the reference on the same scene, in its best turn
  double times_serial = 0;             ///< the median over the turns of the ratio to the reference in the same turn
  double of_plain = 0;                 ///< the same to this executor on the model's plain scene under the straight wind
  std::uint64_t hash = 0;              ///< of the terrain after the same few steps in every row of a scene
};

/// Measures whole steps of models, without statistics and files; says on standard error what it is at. Throws
/// InputError for unknown models.
std::vector<BenchRow> run_bench(const BenchOptions& options);

}  // namespace erg::app
