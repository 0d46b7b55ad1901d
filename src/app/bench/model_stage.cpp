#include "app/bench/model_stage.h"

#include <cstdio>

#include "app/bench/bench.h"
#include "core/units.h"

namespace erg::app {

using sim::set_from_text;
using sim::Simulation;

std::vector<ModelScene> grow_scenes(const models::ModelType& model, const BenchOptions& options) {
  std::vector<ModelScene> scenes;
  for (const models::BenchScene& recipe : model.info.bench_scenes) {
    sim::Config config = bench_config(model.info.key, options.grid, recipe.settings);
    set_from_text(config, "run.executor=cpu");
    config.wind.intervals.front().bearing = fold_bearing(options.bearing + (recipe.oblique ? oblique_turn : 0));
    std::fprintf(stderr, "bench: growing %s of %s, %d x %d cells\n", recipe.name.c_str(), model.info.key.c_str(),
                 options.grid, options.grid);
    Simulation simulation(config);
    for (int step = 0; step < recipe.steps; ++step) simulation.step();
    scenes.push_back({recipe.name, config, simulation.state()});
  }
  return scenes;
}

ModelRun::ModelRun(const ModelScene& scene, const compute::ExecutorOptions& options)
    : scene_(scene), config_(scene.config) {
  set_from_text(config_, "run.executor=" + options.name);
  set_from_text(config_, "run.threads=" + std::to_string(options.threads));
  set_from_text(config_, "run.sweeps=" + std::to_string(options.sweeps));
  begin();
}

void ModelRun::begin() { simulation_ = std::make_unique<Simulation>(config_, scene_.grown); }

std::int64_t ModelRun::step() {
  if (simulation_->finished()) begin();
  return simulation_->step().polls;
}

}  // namespace erg::app
