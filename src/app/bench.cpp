#include "app/bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>

#include "core/random.h"
#include "models/slab_model.h"
#include "sim/simulation.h"

namespace erg {
namespace {

constexpr int growing_steps = 300;       // enough for dunes to stand
constexpr int hashed_steps = 2;          // also warms caches up
constexpr int repeats = 8;               // the best of them counts
constexpr double repeat_seconds = 0.15;  // short, so that executors share the machine's good and bad moments
constexpr double oblique_turn = -30;     // degrees from the straight wind
constexpr std::uint64_t bench_seed = 1;

/// What all executors of a comparison start from.
struct Scene {
  std::string name;
  Terrain terrain;
  SlabLaw law;
  WindNow wind;
};

/// An executor with its own copy of the terrain.
class Contestant {
 public:
  Contestant(const Scene& scene, ExecutorOptions options)
      : scene_(scene), options_(std::move(options)), terrain_(scene.terrain), executor_(make_executor(options_)) {}

  void run_hashed_steps() {
    for (int i = 0; i < hashed_steps; ++i) step();
    executor_->settle(terrain_);
    hash_ = state_hash(terrain_);
  }

  void run_repeat() {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::int64_t polls = 0;
    double seconds = 0;
    do {
      polls += step();
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    } while (seconds < repeat_seconds);
    best_ = std::max(best_, static_cast<double>(polls) / seconds);
  }

  BenchRow row(const std::string& model) const {
    const bool serial = options_.name == "serial";
    return {.model = model,
            .scene = scene_.name,
            .nx = terrain_.nx(),
            .ny = terrain_.ny(),
            .executor = executor_->name(),
            .threads = executor_->threads(),
            .bearing = scene_.wind.bearing,
            .sweeps = serial ? 0 : options_.sweeps,
            .polls_per_second = best_,
            .hash = hash_};
  }

 private:
  std::int64_t step() { return executor_->step(terrain_, scene_.law, scene_.wind, {bench_seed, steps_++}).polls; }

  const Scene& scene_;
  ExecutorOptions options_;
  Terrain terrain_;
  std::unique_ptr<Executor> executor_;
  std::uint64_t steps_ = growing_steps;
  std::uint64_t hash_ = 0;
  double best_ = 0;
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

Scene grow(const std::string& model, const std::string& kind, const BenchOptions& options) {
  Config config(model);
  const std::string side = std::to_string(options.grid);
  for (const std::string& assignment : {"grid.nx=" + side, "grid.ny=" + side, "scene.kind=" + kind,
                                        std::string("run.executor=cpu"), "run.seed=" + std::to_string(bench_seed)}) {
    set_from_text(config, assignment);
  }
  config.wind = Regime::constant(options.bearing, Season{}.first);
  Simulation simulation(config);
  const auto* slab_model = dynamic_cast<const SlabModel*>(&simulation.model());
  if (slab_model == nullptr) throw InputError("--model", "\"" + model + "\" is no slab model", "see `erg models`");
  std::fprintf(stderr, "bench: growing %s dunes on %s, %d x %d cells\n", model.c_str(), kind.c_str(), options.grid,
               options.grid);
  for (int i = 0; i < growing_steps; ++i) simulation.step();
  const Terrain& terrain = simulation.terrain();
  return {"dunes", terrain, slab_model->law(terrain), config.wind.at(0)};
}

/// Scattered plants: every cell has a cover of its own between bare and half.
CoverField scattered_cover(Extent extent) {
  CoverField cover(extent);
  for (std::size_t cell = 0; cell < cover.size(); ++cell) {
    cover[cell] = static_cast<std::uint8_t>(random_below({bench_seed, 0}, 0, cell, 0, 128));
  }
  return cover;
}

using Contest = std::vector<std::unique_ptr<Contestant>>;

/// On one scene: serial first, then the given executors.
void enter(Contest& contest, const Scene& scene, const std::vector<ExecutorOptions>& executors) {
  contest.push_back(std::make_unique<Contestant>(scene, ExecutorOptions{.name = "serial", .threads = 1}));
  for (const ExecutorOptions& options : executors) contest.push_back(std::make_unique<Contestant>(scene, options));
}

/// Measures all in turns, so that each has its share of the machine's good moments, and sets each beside its
/// references.
std::vector<BenchRow> measure_in_turns(const std::string& model, const Contest& contest) {
  std::fprintf(stderr, "bench: measuring %s\n", model.c_str());
  for (const auto& contestant : contest) contestant->run_hashed_steps();
  for (int i = 0; i < repeats; ++i) {
    for (const auto& contestant : contest) contestant->run_repeat();
  }
  std::vector<BenchRow> rows;
  for (const auto& contestant : contest) rows.push_back(contestant->row(model));
  double serial = 0;
  for (BenchRow& row : rows) {
    if (row.sweeps == 0) serial = row.polls_per_second;
    row.serial_polls_per_second = serial;
    for (const BenchRow& plain : rows) {
      const bool same_executor = plain.sweeps == row.sweeps && plain.threads == row.threads;
      if (plain.scene == rows.front().scene && same_executor) row.plain_polls_per_second = plain.polls_per_second;
    }
  }
  return rows;
}

std::vector<BenchRow> bench_model(const std::string& model, const BenchOptions& options) {
  const std::vector<ExecutorOptions> all = measured_options(options, true);
  const std::vector<ExecutorOptions> on_all_threads = measured_options(options, false);

  const Scene dunes = grow(model, "flat", options);
  Scene oblique = dunes;
  oblique.name = "oblique wind";
  oblique.wind.bearing = std::fmod(oblique.wind.bearing + oblique_turn + 360, 360);
  const CoverField cover = scattered_cover(dunes.terrain.extent());
  Scene covered = dunes;
  covered.name = "cover";
  covered.law.cover = &cover;
  covered.law.cover_revision = 1;
  Scene rocks = grow(model, "rocks", options);
  rocks.name = "obstacles";

  Contest contest;
  enter(contest, dunes, all);
  enter(contest, oblique, on_all_threads);
  enter(contest, covered, on_all_threads);
  enter(contest, rocks, on_all_threads);
  return measure_in_turns(model, contest);
}

}  // namespace

int bench_threads(const BenchOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::vector<BenchRow> run_bench(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const std::string& model : options.models) {
    for (BenchRow& row : bench_model(find_model(model).info.key, options)) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace erg
