// Snapshots without a worker.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "session/snapshot.h"

namespace erg::test {

/// What a runner would publish of one run at rest.
inline Snapshot snapshot_of(Simulation& simulation, std::uint64_t number) {
  RunSnapshot run;
  run.config = std::make_shared<const Config>(simulation.config());
  run.terrain = std::make_shared<const Terrain>(simulation.terrain());
  run.terrain_version = number;
  run.series = std::make_shared<const Series>();
  run.step = simulation.step_count();
  run.totals = simulation.totals();
  run.executor = simulation.config().run.text("executor");
  Snapshot snapshot;
  snapshot.number = number;
  snapshot.runs.push_back(std::move(run));
  return snapshot;
}

}  // namespace erg::test
