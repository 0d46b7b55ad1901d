// Makes snapshots of the runs, and sees to it that looking at them does not slow them down.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "session/run_group.h"
#include "session/snapshot.h"

namespace erg::session {

class TerrainPool;

/// Copies terrains, takes numbers, measures rates. Belongs to the worker.
class Publisher {
 public:
  using Clock = std::chrono::steady_clock;

  Publisher();
  ~Publisher();

  /// Whether it is time for the next picture of a running run: 30 times a second at most, and never so often that
  /// making snapshots takes more than a fifth of the worker's time.
  bool due(Clock::time_point now) const { return now >= next_; }
  Clock::time_point next() const { return next_; }
  /// The runs are other ones than before.
  void made_anew(RunGroup& runs);
  /// Notes a step done: `polls` of all runs. Takes the runs' numbers when a row of their
  /// series is due.
  void stepped(RunGroup& runs, std::int64_t polls);
  /// The runs were changed, painted on or taken back: they are not what was shown.
  void touched(RunGroup& runs);
  /// The runs have other configs; the terrain stays what it is.
  void configured(RunGroup& runs);
  /// Fills in `runs` and the rates; terrains that did not change since are shared with the last snapshot.
  void fill(Snapshot& snapshot, RunGroup& runs, bool running);
  /// Rates start anew: the runs begin to move now.
  void start_rates();
  void watch_shadow(bool wanted);
  void watch_flux(bool wanted);

 private:
  struct Lane;

  void look_at(Lane& lane, sim::Simulation& simulation);
  void take_numbers(Lane& lane, sim::Simulation& simulation);
  void space_out_numbers(Clock::time_point begin);
  void update_rates(Clock::time_point now);

  std::vector<std::unique_ptr<Lane>> lanes_;
  std::shared_ptr<TerrainPool> pool_;
  std::uint64_t next_version_ = 1;
  bool shadow_wanted_ = false;
  bool flux_wanted_ = false;
  Clock::time_point next_{};
  Clock::time_point numbers_taken_{};
  // Of the present second.
  Clock::time_point window_start_{};
  std::int64_t window_steps_ = 0;
  std::int64_t window_polls_ = 0;
  double steps_per_second_ = 0;
  double polls_per_second_ = 0;
};

}  // namespace erg::session
