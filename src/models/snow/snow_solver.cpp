#include "models/snow/snow_solver.h"

#include <memory>

#include "models/snow/on_device.h"
#include "models/snow/on_processor.h"

namespace erg::models {

using compute::Executor;
using forcing::Forcing;

namespace {

/// A step of snow, as executors carry it out.
struct SnowDriftStep {
  using Solver = SnowSolver;
  using Report = StepReport;

  SnowStep snow;
  Forcing wind;
  StepKey key;

  std::unique_ptr<SnowSolver> make_solver(Executor& executor) const {
    if (compute::Backend* const device = executor.device())
      return std::make_unique<SnowOnDevice>(*device, executor.sub_sweeps());
    return std::make_unique<SnowOnProcessor>(executor.options().instructions);
  }
  void load(SnowSolver& solver, const Terrain& terrain) const {
    solver.load(terrain, forcing::wind_frame(terrain.extent(), wind.bearing));
  }
  StepReport run(SnowSolver& solver, Terrain& terrain, Executor& executor) const {
    return solver.step(terrain, snow, wind, key, executor);
  }
  SnowDriftStep kept(SnowSolver&) const { return *this; }
};

}  // namespace

StepReport drift_snow(Executor& executor, Terrain& terrain, const SnowStep& snow, const Forcing& wind, StepKey key) {
  return executor.carry_out(terrain, SnowDriftStep{snow, wind, key});
}

}  // namespace erg::models
