#include "app/bench/bench.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <typeinfo>

#include "app/bench/model_stage.h"
#include "core/random.h"
#include "core/units.h"
#include "models/slab/slab_model.h"
#include "process/allowance.h"
#include "sim/make_executor.h"
#include "sim/simulation.h"

namespace erg::app {

using compute::Executor;
using compute::ExecutorOptions;
using models::Cover;
using models::ModelType;
using models::SlabModel;
using sim::Config;

namespace {

constexpr int growing_steps = 300;     // enough for dunes to stand
constexpr int hashed_steps = 2;        // also warms caches up
constexpr double turn_seconds = 0.15;  // short, so that all share the machine's good and bad moments
constexpr std::uint64_t bench_seed = 1;

/// What all executors of a comparison start from.
struct Scene {
  std::string name;
  Terrain terrain;
  models::SlabLaw law;
  forcing::Forcing wind;
};

/// A law of slabs on an executor with its own copy of the terrain.
class LawRun {
 public:
  LawRun(const Scene& scene, const ExecutorOptions& options)
      : scene_(scene), terrain_(scene.terrain), executor_(sim::make_executor(options)) {}

  std::int64_t step() {
    return models::move_slabs(*executor_, terrain_, scene_.law, scene_.wind, {bench_seed, steps_++}).polls;
  }
  const Terrain& terrain() {
    executor_->sync_to_host(terrain_);
    return terrain_;
  }
  Executor& executor() { return *executor_; }

 private:
  const Scene& scene_;
  Terrain terrain_;
  std::unique_ptr<Executor> executor_;
  std::uint64_t steps_ = growing_steps;
};

/// An executor at work on a scene.
class Contestant {
 public:
  Contestant(BenchRow row) : row_(std::move(row)) {}
  virtual ~Contestant() = default;

  void run_hashed_steps() {
    for (int i = 0; i < hashed_steps; ++i) step();
    describe(row_);
  }

  void take_turn() {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::int64_t polls = 0;
    double seconds = 0;
    do {
      polls += step();
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    } while (seconds < turn_seconds);
    rates_.push_back(static_cast<double>(polls) / seconds);
  }

  const BenchRow& row() const { return row_; }
  /// Polls a second in each turn.
  const std::vector<double>& rates() const { return rates_; }

 private:
  virtual std::int64_t step() = 0;
  virtual void describe(BenchRow& row) = 0;

  BenchRow row_;
  std::vector<double> rates_;
};

/// `Run`: LawRun or ModelRun.
template <typename Run>
class RunContestant : public Contestant {
 public:
  template <typename Stage>
  RunContestant(const Stage& stage, const ExecutorOptions& options, BenchRow row)
      : Contestant(std::move(row)), run_(stage, options) {}

 private:
  std::int64_t step() override { return run_.step(); }
  void describe(BenchRow& row) override {
    row.nx = run_.terrain().nx();
    row.ny = run_.terrain().ny();
    row.executor = run_.executor().name();
    row.threads = run_.executor().threads();
    row.hash = state_hash(run_.terrain());
  }

  Run run_;
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
  Config config = bench_config(model, options.grid, {"scene.kind=" + kind, "run.executor=cpu"});
  config.wind.intervals.front().bearing = options.bearing;
  sim::Simulation simulation(config);
  const auto& slab_model = dynamic_cast<const SlabModel&>(simulation.model());
  std::fprintf(stderr, "bench: growing %s dunes on %s, %d x %d cells\n", model.c_str(), kind.c_str(), options.grid,
               options.grid);
  for (int i = 0; i < growing_steps; ++i) simulation.step();
  const Terrain& terrain = simulation.terrain();
  return {"dunes", terrain, slab_model.law(terrain), config.wind.at(0)};
}

/// Scattered plants: every cell has a cover of its own between bare and half.
Cover scattered_cover(Extent extent) {
  models::CoverField cover(extent);
  for (std::size_t cell = 0; cell < cover.size(); ++cell) {
    cover[cell] = static_cast<std::uint8_t>(random_below({bench_seed, 0}, 0, cell, 0, 128));
  }
  return Cover(std::move(cover));
}

using Contest = std::vector<std::unique_ptr<Contestant>>;

/// On one scene: serial first, then the given executors.
template <typename Run, typename Stage>
void enter(Contest& contest, const Stage& scene, double bearing, const std::vector<ExecutorOptions>& executors) {
  const auto one = [&](const ExecutorOptions& options) {
    BenchRow row;
    row.scene = scene.name;
    row.bearing = bearing;
    row.sweeps = options.name == "serial" ? 0 : options.sweeps;
    contest.push_back(std::make_unique<RunContestant<Run>>(scene, options, row));
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

std::vector<BenchRow> bench_model(const std::string& model, const BenchOptions& options) {
  const std::vector<ExecutorOptions> all = measured_options(options, true);
  const std::vector<ExecutorOptions> on_all_threads = measured_options(options, false);

  const Scene dunes = grow(model, "flat", options);
  Scene oblique = dunes;
  oblique.name = "oblique wind";
  oblique.wind.bearing = fold_bearing(oblique.wind.bearing + oblique_turn);
  const Cover cover = scattered_cover(dunes.terrain.extent());
  Scene covered = dunes;
  covered.name = "cover";
  covered.law.cover = &cover;
  Scene rocks = grow(model, "rocks", options);
  rocks.name = "obstacles";

  Contest contest;
  enter<LawRun>(contest, dunes, dunes.wind.bearing, all);
  for (const Scene* scene : {&oblique, &covered, &rocks}) {
    enter<LawRun>(contest, *scene, scene->wind.bearing, on_all_threads);
  }
  return measure_in_turns(model, contest);
}

/// Whole steps of a model that does more than to hand over a law of slabs.
std::vector<BenchRow> bench_steps(const std::string& model, const BenchOptions& options) {
  const std::vector<ModelScene> scenes = grow_scenes(model, options);
  Contest contest;
  for (const ModelScene& scene : scenes) {
    enter<ModelRun>(contest, scene, scene.config.wind.at(0).bearing,
                    measured_options(options, &scene == scenes.data()));
  }
  return measure_in_turns(model, contest);
}

/// Whether a model is nothing but a law of slabs.
bool is_law_alone(const ModelType& type) {
  const auto made = type.make(ParameterValues(type.parameters));
  const models::Model& model = *made;
  return typeid(model) == typeid(SlabModel);
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
    const ModelType& type = models::find_model(model);
    for (BenchRow& row :
         is_law_alone(type) ? bench_model(type.info.key, options) : bench_steps(type.info.key, options)) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace erg::app
