#include "session/publisher.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "kernels/shadow.h"

namespace erg::session {

using io::RunMeter;
using sim::Simulation;

namespace {

using namespace std::chrono_literals;

constexpr auto least_pause = std::chrono::microseconds(33'333);  // between two snapshots of a running run
constexpr int work_for_looking = 5;                              // a snapshot may take 1/5 of the worker's time
constexpr int work_for_numbers = 10;                             // taking numbers 1/10
constexpr int most_doublings = 6;                                // of the pause between two rows of numbers, each time
constexpr auto rate_window = 500ms;

}  // namespace

/// Memory of terrains that nobody looks at any more, to be used again: fresh pages for every snapshot of a large grid
/// would cost more than the copy.
class TerrainPool : public std::enable_shared_from_this<TerrainPool> {
 public:
  std::shared_ptr<const Terrain> copy_of(const Terrain& terrain) {
    std::unique_ptr<Terrain> copy = take();
    *copy = terrain;
    // The pool may be gone before the last snapshot is.
    return {copy.release(), [pool = weak_from_this()](const Terrain* old) {
              std::unique_ptr<Terrain> memory(const_cast<Terrain*>(old));
              if (const auto alive = pool.lock()) alive->put_back(std::move(memory));
            }};
  }

 private:
  static constexpr std::size_t most_free = 6;

  std::unique_ptr<Terrain> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Terrain>();
    std::unique_ptr<Terrain> memory = std::move(free_.back());
    free_.pop_back();
    return memory;
  }
  void put_back(std::unique_ptr<Terrain> memory) {
    const std::lock_guard lock(mutex_);
    if (free_.size() < most_free) free_.push_back(std::move(memory));
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Terrain>> free_;
};

/// What is kept of one run from snapshot to snapshot.
struct Publisher::Lane {
  explicit Lane(Simulation& simulation) : meter(simulation.totals(), simulation.step_count()) {}

  RunSnapshot shown;
  bool stale = true;               ///< the terrain is not what was shown
  std::uint64_t fields_stamp = 0;  ///< of the terrain as it was shown
  bool config_stale = true;
  RunMeter meter;
  Series series;
  bool series_stale = true;
};

Publisher::Publisher() : pool_(std::make_shared<TerrainPool>()) {}
Publisher::~Publisher() = default;

void Publisher::made_anew(RunGroup& runs) {
  pool_ = std::make_shared<TerrainPool>();  // what lies free has the size of the runs before
  lanes_.clear();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    lanes_.push_back(std::make_unique<Lane>(runs.run(i)));
    take_numbers(*lanes_.back(), runs.run(i));
  }
}

void Publisher::touched(RunGroup& runs) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = *lanes_[i];
    Simulation& simulation = runs.run(i);
    lane.stale = lane.config_stale = true;
    if (simulation.step_count() <= lane.series.last_step()) {
      lane.series.cut(simulation.step_count());
      lane.series_stale = true;
      lane.meter = RunMeter(simulation.totals(), simulation.step_count());
    }
  }
}

void Publisher::configured(RunGroup& runs) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = *lanes_[i];
    lane.config_stale = true;
    // A model that begins anew may lay fields; the ground it leaves alone.
    lane.stale = lane.stale || runs.run(i).terrain().fields_stamp() != lane.fields_stamp;
  }
}

void Publisher::stepped(RunGroup& runs, std::int64_t polls) {
  ++window_steps_;
  window_polls_ += polls;
  for (const auto& lane : lanes_) lane->stale = true;
  const Clock::time_point begin = Clock::now();
  bool taken = false;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = *lanes_[i];
    const std::int64_t step = runs.run(i).step_count();
    const bool due = lane.series.due(step);
    if (due) take_numbers(lane, runs.run(i));
    if (!due && lane.series.stride() > RunMeter::longest_look && lane.series.due(step + RunMeter::good_look)) {
      lane.meter.glance(runs.run(i));
    }
    taken = taken || due;
  }
  if (taken) space_out_numbers(begin);
}

/// Rows of numbers were taken since `begin`: from now on as seldom as is cheap enough, for on a large grid a row takes
/// as long as many steps. All runs alike, so that the rows of those that are compared are of the same steps.
void Publisher::space_out_numbers(Clock::time_point begin) {
  Clock::duration pause = begin - numbers_taken_;
  numbers_taken_ = Clock::now();
  const Clock::duration long_enough = (numbers_taken_ - begin) * work_for_numbers;
  for (int doubled = 0; doubled < most_doublings && pause < long_enough; ++doubled, pause *= 2) {
    for (const auto& lane : lanes_) lane->series.widen();
  }
}

void Publisher::take_numbers(Lane& lane, Simulation& simulation) {
  lane.series.add(lane.meter.take(simulation));
  lane.series_stale = true;
}

void Publisher::look_at(Lane& lane, Simulation& simulation) {
  RunSnapshot& view = lane.shown;
  if (lane.config_stale) view.config = std::make_shared<const sim::Config>(simulation.config());
  if (lane.series_stale) view.series = std::make_shared<const Series>(lane.series);
  if (lane.stale) {
    const Terrain& terrain = simulation.terrain();
    view.terrain = pool_->copy_of(terrain);
    view.terrain_version = next_version_++;
    lane.fields_stamp = terrain.fields_stamp();
    view.mass_now = terrain.total_mobile();
    view.shadow = nullptr;
    view.flux = nullptr;
  }
  simulation.watch_flux(flux_wanted_);  // of a run that was made anew or taken back, too
  if (!flux_wanted_) view.flux = nullptr;
  if (flux_wanted_ && view.flux == nullptr) view.flux = std::make_shared<const Field>(simulation.flux()->mean());
  if (shadow_wanted_ && view.shadow == nullptr) {
    view.shadow = std::make_shared<const Field>(kernels::shadow_field(
        *view.terrain, simulation.last_wind().bearing, simulation.model().shadow_fall(view.terrain->cell_size())));
  }
  lane.stale = lane.config_stale = lane.series_stale = false;
  view.step = simulation.step_count();
  view.last_wind = simulation.last_wind();
  view.totals = simulation.totals();
  view.executor = simulation.executor().name();
  view.threads = simulation.executor().threads();
}

void Publisher::fill(Snapshot& snapshot, RunGroup& runs, bool running) {
  const Clock::time_point begin = Clock::now();
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    // At rest the last numbers are those of what is seen.
    if (!running && lanes_[i]->series.last_step() < runs.run(i).step_count()) take_numbers(*lanes_[i], runs.run(i));
    look_at(*lanes_[i], runs.run(i));
    lanes_[i]->shown.last_stroke = runs.last_stroke(i);
    snapshot.runs.push_back(lanes_[i]->shown);
  }
  if (running) {
    update_rates(begin);
    snapshot.steps_per_second = steps_per_second_;
    snapshot.polls_per_second = polls_per_second_;
  }
  const Clock::time_point end = Clock::now();
  next_ = std::max<Clock::time_point>(begin + least_pause, end + (end - begin) * (work_for_looking - 1));
}

void Publisher::update_rates(Clock::time_point now) {
  const auto elapsed = now - window_start_;
  if (elapsed < rate_window && (steps_per_second_ > 0 || elapsed < 50ms)) return;
  const double seconds = std::chrono::duration<double>(elapsed).count();
  steps_per_second_ = static_cast<double>(window_steps_) / seconds;
  polls_per_second_ = static_cast<double>(window_polls_) / seconds;
  window_start_ = now;
  window_steps_ = window_polls_ = 0;
}

void Publisher::start_rates() {
  window_start_ = Clock::now();
  window_steps_ = window_polls_ = 0;
  steps_per_second_ = polls_per_second_ = 0;
}

void Publisher::watch_shadow(bool wanted) { shadow_wanted_ = wanted; }

void Publisher::watch_flux(bool wanted) { flux_wanted_ = wanted; }

}  // namespace erg::session
