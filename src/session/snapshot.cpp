#include "session/snapshot.h"

#include <algorithm>

#include "io/config/provenance.h"
#include "sim/step_time.h"

namespace erg::session {

std::string to_string(Activity activity) {
  switch (activity) {
    case Activity::empty:
      return "empty";
    case Activity::building:
      return "building";
    case Activity::paused:
      return "paused";
    case Activity::running:
      return "running";
    case Activity::finished:
      return "finished";
    case Activity::failed:
      break;
  }
  return "failed";
}

std::string RunSnapshot::executor_text() const { return erg::io::executor_text(executor, threads); }

sim::RunState RunSnapshot::state() const { return {*terrain, step, totals}; }

double Snapshot::progress() const {
  if (goal <= goal_start) return 0;
  return std::clamp(static_cast<double>(step() - goal_start) / static_cast<double>(goal - goal_start), 0.0, 1.0);
}

double Snapshot::seconds_left() const {
  if (goal < 0 || steps_per_second <= 0) return -1;
  return static_cast<double>(std::max<std::int64_t>(0, goal - step())) / steps_per_second;
}

std::string clock_text(const sim::Config& config, std::int64_t step) {
  const std::string text = "step " + std::to_string(step);
  const double seconds = sim::step_scale(config).seconds;
  return seconds > 0 ? text + ", " + sim::world_time_text(static_cast<double>(step) * seconds) : text;
}

}  // namespace erg::session
