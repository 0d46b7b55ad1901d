// The runs themselves, one to four, stepped together and edited with exact undo. No thread of its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "io/checkpoint/checkpoint.h"
#include "session/brush.h"
#include "session/wind_cycle.h"
#include "sim/simulation.h"

namespace erg::session {

/// The most runs that are compared at once.
inline constexpr std::size_t most_runs = 4;

/// Runs under one wind and one clock. When a function throws, everything is as it was before.
class RunGroup {
 public:
  /// The runs' states at one moment.
  using Moment = std::vector<std::shared_ptr<const sim::RunState>>;
  using Duration = std::chrono::steady_clock::duration;

  bool empty() const { return runs_.empty(); }
  std::size_t size() const { return runs_.size(); }
  sim::Simulation& run(std::size_t index) { return *runs_[index]; }
  std::int64_t step_count() const { return empty() ? 0 : runs_.front()->step_count(); }
  /// Nothing can move any more in any run.
  bool finished() const;
  /// Why, of the first run.
  std::string why_finished() const;

  /// New terrains for these configs. Throws InputError: none or too many, winds that differ, whatever a scene lacks.
  /// `notes`, where given, gets what is worth telling of pictures.
  void create(const std::vector<sim::Config>& configs, std::vector<std::string>* notes = nullptr);
  /// Goes on from saved states. Throws InputError as create does, and for clocks that differ.
  void resume(std::vector<io::Saved> saved);
  /// Back to where the runs were when created or resumed, under the configs of now; can be undone.
  void reset();
  /// Exactly this moment again, under the configs of now: after a failure, or on undo. `blown`: until then.
  void go_to(const Moment& moment, const WindRecord& blown);
  /// What go_to needs.
  Moment moment() const;

  /// One time step of every run that is not finished; their clocks stay together. Returns the polls of all.
  std::int64_t step();
  /// How long the steps took that led from what was created or resumed to what stands here now.
  Duration worked() const { return worked_; }
  /// The wind of all steps that led to what stands here now, as it blew, whatever is set by now.
  const WindRecord& blown() const { return blown_; }
  /// Other configs from the next step on, as many as there are runs. Throws InputError.
  void change(const std::vector<sim::Config>& configs);
  /// A stamp on one run, booked in its ledger. Throws InputError.
  void paint(std::size_t run, const BrushStamp& stamp, std::uint64_t stroke);

  /// Number of the last stroke on this run since it was created or reset; 0: none.
  std::uint64_t last_stroke(std::size_t run) const;
  std::size_t undo_count() const { return undo_.size(); }
  std::size_t redo_count() const { return redo_.size(); }
  /// Back to exactly what was before the last stroke or reset: terrain, account, clock, what was worked for it. What
  /// the runs are set to stays. False when there is none.
  bool undo();
  /// Takes the last undo back. False when there is none.
  bool redo();

 private:
  struct Edit {
    std::uint64_t stroke = 0;  ///< 0: a reset
    std::size_t run = 0;       ///< that was painted
    Duration worked{};
    WindRecord blown;
    Moment state;
  };
  void remember(std::uint64_t stroke, std::size_t run);
  void forget_edits();
  bool swap_with(std::deque<Edit>& from, std::deque<Edit>& to);
  void take(std::vector<std::unique_ptr<sim::Simulation>> runs);

  std::vector<std::unique_ptr<sim::Simulation>> runs_;
  Moment context_;
  WindRecord blown_before_;  ///< before that
  Duration worked_{};
  WindRecord blown_;
  std::deque<Edit> undo_;
  std::deque<Edit> redo_;
};

}  // namespace erg::session
