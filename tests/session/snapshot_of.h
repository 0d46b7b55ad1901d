// Snapshots without a worker.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "session/snapshot.h"

namespace erg::test {

/// What a runner would publish of one run at rest.
inline session::Snapshot snapshot_of(sim::Simulation& simulation, std::uint64_t number) {
  session::RunSnapshot run;
  run.config = std::make_shared<const sim::Config>(simulation.config());
  run.terrain = std::make_shared<const Terrain>(simulation.terrain());
  run.terrain_version = number;
  run.series = std::make_shared<const session::Series>();
  run.step = simulation.step_count();
  run.totals = simulation.totals();
  run.executor = simulation.config().run.text("executor");
  session::Snapshot snapshot;
  snapshot.number = number;
  snapshot.runs.push_back(std::move(run));
  return snapshot;
}

}  // namespace erg::test
