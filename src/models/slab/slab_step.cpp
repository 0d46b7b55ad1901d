#include "models/slab/slab_step.h"

#include <memory>

#include "models/slab/engine.h"
#include "models/slab/on_device.h"
#include "models/slab/reference.h"

namespace erg::models {

using compute::Executor;
using forcing::Forcing;

namespace {

/// A step of slabs, as executors carry it out.
struct SlabStep {
  using Solver = SlabSolver;
  using Report = StepReport;

  SlabLaw law;
  Forcing wind;
  StepKey key;
  std::shared_ptr<const Cover> cover = {};  ///< the law's, where it is kept for later

  std::unique_ptr<SlabSolver> make_solver(Executor& executor) const {
    if (compute::Backend* const device = executor.device())
      return std::make_unique<SlabOnDevice>(*device, executor.sub_sweeps());
    if (executor.sub_sweeps() == 0) return std::make_unique<SlabReference>();
    return std::make_unique<SlabEngine>(executor);
  }
  forcing::WindFrame frame(const Terrain& terrain) const { return forcing::wind_frame(terrain.extent(), wind.bearing); }
  void load(SlabSolver& solver, const Terrain& terrain) const { solver.load(terrain, frame(terrain)); }
  StepReport run(SlabSolver& solver, Terrain& terrain, Executor& executor) const {
    const StepReport report = solver.step(terrain, law, frame(terrain), wind.strength, key, executor.lift_counts());
    terrain.ledger().in += report.slabs_in;
    terrain.ledger().out += report.slabs_out;
    return report;
  }
  /// The cover may change before the step is done once more: it needs one of its own, the same as long as that stays.
  SlabStep kept(SlabSolver& solver) const {
    SlabStep copy{law, wind, key, static_cast<SlabOnDevice&>(solver).kept_cover()};
    copy.law.cover = copy.cover.get();
    return copy;
  }
};

}  // namespace

StepReport move_slabs(Executor& executor, Terrain& terrain, const SlabLaw& law, const Forcing& wind, StepKey key) {
  return wind.strength > 0 ? executor.carry_out(terrain, SlabStep{law, wind, key}) : StepReport{};
}

}  // namespace erg::models
