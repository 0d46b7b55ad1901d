// Whole models at work, for `erg bench`: scenes that have grown, and runs that go on from them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace erg::app {

struct BenchOptions;

/// A scene on which a model's whole steps are measured.
struct ModelScene {
  std::string name;
  sim::Config config;
  sim::RunState grown;
};

/// Grows the scenes of a model (ModelInfo::bench_scenes). Says on standard error what it is at.
std::vector<ModelScene> grow_scenes(const models::ModelType& model, const BenchOptions& options);

/// A run that goes on from a scene on an executor; where nothing moves any more it begins anew.
class ModelRun {
 public:
  ModelRun(const ModelScene& scene, const compute::ExecutorOptions& options);
  /// One step; its polls.
  std::int64_t step();
  const Terrain& terrain() { return simulation_->terrain(); }
  compute::Executor& executor() { return simulation_->executor(); }

 private:
  void begin();

  const ModelScene& scene_;
  sim::Config config_;
  std::unique_ptr<sim::Simulation> simulation_;
};

}  // namespace erg::app
