// What a crash may leave that can be read and yet not be gone on with.
#pragma once

#include <filesystem>

#include "session/session.h"
#include "snapshot_of.h"

namespace erg::test {

/// A lost session of two runs that stand at different steps, which runs of one comparison never do.
inline void leave_torn_session(const std::filesystem::path& folder, const sim::Config& config) {
  session::Session session(folder);
  sim::Simulation first(config);
  sim::Simulation second(config);
  second.step();
  session::Snapshot torn = snapshot_of(first, 1);
  torn.runs.push_back(snapshot_of(second, 1).runs.front());
  session.save(torn);
  session.keep();
}

}  // namespace erg::test
