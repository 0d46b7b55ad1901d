// The worker: owns the runs on a thread of its own, takes commands and publishes snapshots. The window never waits for
// a step, and no lock is held while anything is stepped or drawn.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "io/checkpoint/checkpoint.h"
#include "session/brush.h"
#include "session/log.h"
#include "session/publisher.h"
#include "session/run_group.h"
#include "session/snapshot.h"

namespace erg::session {

/// Owns one to four runs that go by one clock.
///
/// Each command returns at once; the worker carries commands out in the order given, between two steps. What goes wrong
/// is written to the log and leaves the runs as they were. All functions may be called from any thread,
/// watch_shadow and watch_flux from one alone.
class Runner {
 public:
  /// `log` must outlive the runner. `before_step` is called on the worker's thread before each step; what it throws is
  /// a failed step.
  explicit Runner(Log& log, std::function<void()> before_step = {});
  /// Stops after the step under way.
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  // -- what the window reads --

  /// The newest snapshot; never null.
  std::shared_ptr<const Snapshot> snapshot() const;
  /// Commands given so far: a snapshot with this many `commands_done` shows the work of all of them.
  std::uint64_t commands_given() const;
  /// Waits until every command given so far has been carried out, and shows in the snapshot.
  void wait_for_commands() const;
  /// The same, and until the worker is not running any more. Without a goal or an end that can be for ever.
  void wait_until_still() const;

  // -- commands --

  /// Makes terrains for these configs (1 to 4, one wind) and shows them, paused. When one cannot be made the runs that
  /// were there stay.
  void create(std::vector<sim::Config> configs);
  /// Goes on from saved states, paused.
  void resume(std::vector<io::Saved> saved);
  /// Everything back to what was created or resumed, paused. Can be undone.
  void reset();
  /// Steps on and on, until a pause or the end.
  void play();
  void pause();
  /// One step, then paused.
  void step();
  /// `steps` more steps, then paused.
  void run(std::int64_t steps);
  /// At most this many steps a second, 0: unlimited.
  void set_speed(double steps_per_second);
  /// The runs go on under these configs (as many as there are runs) from the next step on.
  void change(std::vector<sim::Config> configs);
  /// Puts a stamp on one run. Stamps with the same stroke number are undone together.
  void paint(std::size_t run, const BrushStamp& stamp, std::uint64_t stroke);
  /// Back to exactly what was before the last stroke or reset: terrain, account, clock. What the runs are set to stays.
  void undo();
  /// Takes the last undo back.
  void redo();
  /// Whether snapshots carry the wind's shadow.
  void watch_shadow(bool wanted);
  /// Whether the runs count where slabs are lifted, and snapshots carry that.
  void watch_flux(bool wanted);

 private:
  using Clock = std::chrono::steady_clock;
  using Command = std::function<void()>;  // carried out on the worker's thread

  void give(Command command);
  void work();
  bool take_commands();
  void wait_for_work(std::unique_lock<std::mutex>& lock);
  void carry_out(const Command& command);
  void start(std::int64_t goal);
  void halt();
  void step_once();
  void step_on();
  void make(const std::function<void()>& build);
  void edit(const std::function<void()>& change);
  void settle_edit();
  void settle();
  void fail(const std::string& what);
  void take_back_if_torn();
  void publish();

  Log& log_;
  std::function<void()> before_step_;

  // Shared, under mutex_. It is held for the moment of a swap only.
  mutable std::mutex mutex_;
  std::condition_variable given_something_;
  mutable std::condition_variable published_;
  std::deque<Command> queue_;
  std::uint64_t given_ = 0;
  bool stopping_ = false;
  std::shared_ptr<const Snapshot> newest_;

  // The worker's own.
  RunGroup runs_;
  Publisher publisher_;
  Activity activity_ = Activity::empty;
  std::string message_;
  bool unshown_ = false;  // steps were done that no snapshot shows
  bool torn_ = false;     // a step failed half way, and the runs stand there still
  std::uint64_t done_ = 0;
  std::uint64_t snapshots_ = 0;
  std::uint64_t failed_creation_ = 0;
  std::uint64_t creations_ = 0;
  double speed_limit_ = 0;
  std::int64_t goal_start_ = 0;
  std::int64_t goal_ = -1;
  Clock::time_point next_step_{};

  // The window's own: what it asked for last.
  bool shadow_watched_ = false;
  bool flux_watched_ = false;

  std::thread thread_;
};

}  // namespace erg::session
