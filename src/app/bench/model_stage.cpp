#include "app/bench/model_stage.h"

#include <cstdio>

#include "app/bench/bench.h"
#include "core/units.h"

namespace erg::app {

using sim::set_from_text;
using sim::Simulation;

namespace {

/// How a scene is made.
struct Recipe {
  const char* name;
  int steps;        ///< until its forms stand
  double turn = 0;  ///< of the bench's bearing, degrees
  std::vector<std::string> settings = {};
};

const std::vector<std::string> waves{"grid.cell_size=0.1", "scene.sand=40", "wind.strength=12"};

std::vector<Recipe> recipes(const std::string& model) {
  if (model == "snow_sintering") {
    return {{"waves", 120, 0, waves},
            {"oblique wind", 120, oblique_turn, waves},
            {"sastrugi",
             160,
             0,
             {"grid.cell_size=0.05", "scene.sand=120", "parameters.slab_height=0.0025", "parameters.time_step=30",
              "parameters.start_age=60", "wind.strength=22"}}};
  }
  // Snow that freezes soon would leave little to measure.
  const std::vector<std::string> cold =
      model == "snow_packing" ? std::vector<std::string>{"temperature=-60"} : std::vector<std::string>{};
  return {{"dunes", 20, 0, cold}, {"oblique wind", 20, oblique_turn, cold}};
}

}  // namespace

std::vector<ModelScene> grow_scenes(const std::string& model, const BenchOptions& options) {
  std::vector<ModelScene> scenes;
  for (const Recipe& recipe : recipes(model)) {
    sim::Config config = bench_config(model, options.grid, recipe.settings);
    set_from_text(config, "run.executor=cpu");
    config.wind.intervals.front().bearing = fold_bearing(options.bearing + recipe.turn);
    std::fprintf(stderr, "bench: growing %s of %s, %d x %d cells\n", recipe.name, model.c_str(), options.grid,
                 options.grid);
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
