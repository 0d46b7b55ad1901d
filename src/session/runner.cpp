#include "session/runner.h"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

#include "sim/memory.h"

namespace erg::session {

using sim::Config;
using sim::problem_of;

namespace {

/// Lets the window's thread go first where there are no more processors than threads at work. Threads that this one
/// starts, the executors', inherit it: under Linux a priority is a thread's own.
void step_aside() {
  constexpr int politeness = 10;
  setpriority(PRIO_PROCESS, 0, politeness);  // refused, nothing is lost but some frames
}

}  // namespace

Runner::Runner(Log& log, std::function<void()> before_step)
    : log_(log), before_step_(std::move(before_step)), newest_(std::make_shared<const Snapshot>()), thread_([this] {
        step_aside();
        work();
      }) {}

Runner::~Runner() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  given_something_.notify_all();
  thread_.join();
}

// -- what the window reads --

std::shared_ptr<const Snapshot> Runner::snapshot() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

std::uint64_t Runner::commands_given() const {
  const std::lock_guard lock(mutex_);
  return given_;
}

void Runner::wait_for_commands() const {
  std::unique_lock lock(mutex_);
  published_.wait(lock, [&, given = given_] { return newest_->commands_done >= given; });
}

void Runner::wait_until_still() const {
  std::unique_lock lock(mutex_);
  published_.wait(
      lock, [&, given = given_] { return newest_->commands_done >= given && newest_->activity != Activity::running; });
}

// -- commands --

void Runner::give(Command command) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(command));
    ++given_;
  }
  given_something_.notify_one();
}

void Runner::create(std::vector<Config> configs) {
  give([this, configs = std::move(configs)] {
    make([&] {
      std::vector<std::string> notes;
      runs_.create(configs, &notes);
      for (const std::string& note : notes) log_.information(note);
    });
  });
}

void Runner::resume(std::vector<io::Saved> saved) {
  give([this, saved = std::move(saved)]() mutable { make([&] { runs_.resume(std::move(saved)); }); });
}

void Runner::reset() {
  give([this] {
    halt();
    edit([this] { runs_.reset(); });
  });
}

void Runner::play() {
  give([this] { start(-1); });
}

void Runner::pause() {
  give([this] { halt(); });
}

void Runner::step() {
  give([this] {
    start(-1);
    if (activity_ != Activity::running) return;
    step_once();
    halt();
  });
}

void Runner::run(std::int64_t steps) {
  give([this, steps] {
    if (steps > 0) start(runs_.step_count() + steps);
  });
}

void Runner::set_speed(double steps_per_second) {
  give([this, steps_per_second] {
    speed_limit_ = steps_per_second > 0 ? steps_per_second : 0;
    next_step_ = Clock::now();
  });
}

void Runner::change(std::vector<Config> configs) {
  give([this, configs = std::move(configs)] {
    take_back_if_torn();
    runs_.change(configs);
    publisher_.configured(runs_);
    settle_edit();
  });
}

void Runner::paint(std::size_t run, const BrushStamp& stamp, std::uint64_t stroke) {
  give([this, run, stamp, stroke] { edit([&] { runs_.paint(run, stamp, stroke); }); });
}

void Runner::undo() {
  give([this] { edit([this] { runs_.undo(); }); });
}

void Runner::redo() {
  give([this] { edit([this] { runs_.redo(); }); });
}

void Runner::watch_shadow(bool wanted) {
  if (std::exchange(shadow_watched_, wanted) == wanted) return;
  give([this, wanted] { publisher_.watch_shadow(wanted); });
}

void Runner::watch_flux(bool wanted) {
  if (std::exchange(flux_watched_, wanted) == wanted) return;
  give([this, wanted] { publisher_.watch_flux(wanted); });
}

// -- the worker --

void Runner::work() {
  while (take_commands()) {
    if (activity_ == Activity::running && Clock::now() >= next_step_) step_on();
    if (unshown_ && publisher_.due(Clock::now())) publish();
  }
}

/// Waits while there is nothing to do, then carries out what was given. False when it is time to stop.
bool Runner::take_commands() {
  std::deque<Command> commands;
  {
    std::unique_lock lock(mutex_);
    wait_for_work(lock);
    if (stopping_) return false;
    commands.swap(queue_);
  }
  for (const Command& command : commands) carry_out(command);
  if (!commands.empty()) publish();
  return true;
}

void Runner::wait_for_work(std::unique_lock<std::mutex>& lock) {
  const auto given = [this] { return stopping_ || !queue_.empty(); };
  if (activity_ != Activity::running) return given_something_.wait(lock, given);
  const Clock::time_point until = unshown_ ? std::min(next_step_, publisher_.next()) : next_step_;
  if (until > Clock::now()) given_something_.wait_until(lock, until, given);
}

void Runner::carry_out(const Command& command) {
  try {
    command();
  } catch (const InputError& error) {
    log_.mistakes(error);
  } catch (const std::exception& error) {
    log_.error("this could not be done: " + problem_of(error));
  }
  ++done_;
}

/// Begins to run, to step `goal` or, where that is negative, on and on.
void Runner::start(std::int64_t goal) {
  if (runs_.empty()) throw InputError("", "there is nothing to run yet", "create a terrain first");
  take_back_if_torn();
  goal_start_ = runs_.step_count();
  goal_ = goal;
  if (activity_ == Activity::running) return;
  if (runs_.finished()) return;
  activity_ = Activity::running;
  message_.clear();
  next_step_ = Clock::now();
  publisher_.start_rates();
}

void Runner::halt() {
  goal_ = -1;
  if (activity_ == Activity::running) activity_ = Activity::paused;
}

void Runner::step_on() {
  const Clock::time_point due = next_step_;
  step_once();
  if (speed_limit_ > 0) {
    // One step after the other at even intervals; what a slow step has lost is not caught up.
    const auto interval = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / speed_limit_));
    next_step_ = std::max(due + interval, Clock::now());
  }
  if (activity_ != Activity::running) publish();
}

void Runner::step_once() {
  try {
    if (before_step_) before_step_();
    const std::int64_t polls = runs_.step();
    publisher_.stepped(runs_, polls);
    unshown_ = true;
  } catch (const std::exception& error) {
    return fail(problem_of(error));
  }
  if (goal_ >= 0 && runs_.step_count() >= goal_) {
    activity_ = Activity::paused;
    goal_ = -1;
  }
  settle();
}

/// Makes runs anew; when that fails the runs that were there stay.
void Runner::make(const std::function<void()>& build) {
  const Activity before = activity_;
  activity_ = Activity::building;
  publish();
  try {
    build();
  } catch (...) {
    activity_ = before;
    failed_creation_ = done_ + 1;
    throw;
  }
  torn_ = false;
  publisher_.made_anew(runs_);
  ++creations_;
  activity_ = Activity::paused;
  message_.clear();
  goal_ = -1;
  settle();
}

/// Changes the runs that are there.
void Runner::edit(const std::function<void()>& change) {
  take_back_if_torn();
  change();
  publisher_.touched(runs_);
  settle_edit();
}

void Runner::settle_edit() {
  if (activity_ == Activity::failed) activity_ = Activity::paused;
  settle();
}

/// Finds out whether all runs have come to their end, or can go on again.
void Runner::settle() {
  if (runs_.finished()) {
    activity_ = Activity::finished;
    message_ = runs_.why_finished();
    goal_ = -1;
  } else if (activity_ == Activity::finished) {
    activity_ = Activity::paused;
    message_.clear();
  }
}

/// A step failed half way: what the last snapshot shows is whole, so the runs go back to it.
void Runner::fail(const std::string& what) {
  activity_ = Activity::failed;
  message_ = what;
  goal_ = -1;
  torn_ = true;
  log_.error("a step failed: " + what);
  try {
    take_back_if_torn();
  } catch (const std::exception& error) {
    log_.error("the runs cannot be taken back to the last whole step: " + problem_of(error));
  }
}

/// Until this is done no command goes on from what a failed step has left, and no snapshot shows it.
void Runner::take_back_if_torn() {
  if (!torn_) return;
  const std::shared_ptr<const Snapshot> whole = snapshot();
  RunGroup::Moment moment;
  for (const RunSnapshot& run : whole->runs) moment.push_back(std::make_shared<const sim::RunState>(run.state()));
  runs_.go_to(moment, whole->blown);
  torn_ = false;
  publisher_.touched(runs_);
  log_.information("the runs stand as they were after step " + std::to_string(whole->step()));
}

void Runner::publish() {
  auto next = std::make_shared<Snapshot>();
  next->number = ++snapshots_;
  next->activity = activity_;
  next->message = message_;
  next->speed_limit = speed_limit_;
  next->seconds_worked = std::chrono::duration<double>(runs_.worked()).count();
  next->blown = runs_.blown();
  next->goal_start = goal_start_;
  next->goal = goal_;
  next->undo_count = runs_.undo_count();
  next->redo_count = runs_.redo_count();
  next->commands_done = done_;
  next->failed_creation = failed_creation_;
  next->creations = creations_;
  unshown_ = false;
  try {
    if (torn_) {
      next->runs = snapshot()->runs;
    } else {
      publisher_.fill(*next, runs_, activity_ == Activity::running);
    }
  } catch (const std::exception& error) {  // no memory for another copy of the terrain
    activity_ = next->activity = Activity::failed;
    next->message = message_ = "the runs cannot be shown: " + problem_of(error);
    next->runs = snapshot()->runs;
    log_.error(message_);
  }
  std::shared_ptr<const Snapshot> shown = std::move(next);
  {
    const std::lock_guard lock(mutex_);
    newest_.swap(shown);
  }
  published_.notify_all();
}

}  // namespace erg::session
