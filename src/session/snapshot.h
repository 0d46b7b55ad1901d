// What the window reads: the runs as they stood at one moment. A snapshot never changes once it is published, so it can
// be drawn from without any lock while the worker steps on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "compute/executor.h"
#include "core/terrain.h"
#include "forcing/wind_schedule.h"
#include "session/series.h"
#include "session/wind_cycle.h"
#include "sim/config.h"
#include "sim/simulation.h"

namespace erg::session {

/// What the worker is doing.
enum class Activity {
  empty,     ///< nothing has been created yet
  building,  ///< a terrain is being made
  paused,
  running,
  finished,  ///< nothing can move any more in any run; `message` says why
  failed     ///< a step failed; `message` says how. The runs stand as the last snapshot before showed them
};

/// "paused", "running" ...
std::string to_string(Activity activity);

/// One run as it stands. Never null: config, terrain, series.
struct RunSnapshot {
  std::shared_ptr<const sim::Config> config;
  std::shared_ptr<const Terrain> terrain;
  /// Differs whenever the terrain differs, over all runs and snapshots of a Runner; never 0. For TerrainView::version.
  std::uint64_t terrain_version = 0;
  /// Where the wind's shadow lies (1 dark), under the last wind; null unless Runner::watch_shadow asks for it.
  std::shared_ptr<const Field> shadow;
  /// Lifts from each cell a step (FluxWatch::mean); null unless Runner::watch_flux asks for it.
  std::shared_ptr<const Field> flux;
  std::shared_ptr<const Series> series;  ///< the run's numbers over time
  std::int64_t step = 0;                 ///< steps done
  forcing::Forcing last_wind;            ///< of the last step done
  models::StepReport totals;             ///< since step 0
  std::int64_t mass_now = 0;             ///< quanta on the ground, counted
  std::string executor;                  ///< "cpu"
  int threads = 1;
  /// Number of the last stroke of the brush on it since it was made or reset; 0: none.
  std::uint64_t last_stroke = 0;

  /// Quanta on the ground beyond what the ledger says: 0, always.
  std::int64_t mass_drift() const { return mass_now - terrain->ledger().expected(); }
  /// "cpu, 2 threads"
  std::string executor_text() const;
  /// What a checkpoint of this moment holds.
  sim::RunState state() const;
};

/// Everything at one moment.
struct Snapshot {
  std::uint64_t number = 0;  ///< grows with each snapshot
  Activity activity = Activity::empty;
  std::string message;            ///< why it is finished or failed; else empty
  std::vector<RunSnapshot> runs;  ///< none before the first create; two to four when comparing
  double steps_per_second = 0;    ///< measured over the last second or so; 0 unless running
  double polls_per_second = 0;    ///< the same, of all runs together
  WindRecord blown;               ///< the wind of all steps up to here, as it blew (RunGroup::blown)
  double seconds_worked = 0;      ///< s of steps that led to what stands here now (RunGroup::worked)
  double speed_limit = 0;         ///< steps a second that were asked for; 0: unlimited
  std::int64_t goal_start = 0;    ///< step at which "run N steps" began
  std::int64_t goal = -1;         ///< step at which it pauses; -1: none
  std::size_t undo_count = 0;     ///< how many edits can be undone
  std::size_t redo_count = 0;
  std::uint64_t commands_done = 0;    ///< commands carried out, see Runner::commands_given
  std::uint64_t failed_creation = 0;  ///< number of the last create or resume, among all commands, that went wrong
  std::uint64_t creations = 0;        ///< grows whenever there are other runs: create, resume

  bool has_runs() const { return !runs.empty(); }
  /// Steps done (all runs go by one clock); 0 when there are none.
  std::int64_t step() const { return runs.empty() ? 0 : runs.front().step; }
  /// How far "run N steps" is, 0 to 1; 0 when there is no goal.
  double progress() const;
  /// Seconds until the goal at the present rate; negative when unknown.
  double seconds_left() const;
};

/// The clock in words: "step 1240", and what that means where the model says so ("step 1240, 15.5 years").
std::string clock_text(const sim::Config& config, std::int64_t step);

}  // namespace erg::session
