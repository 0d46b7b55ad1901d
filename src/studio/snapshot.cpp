#include "studio/snapshot.h"

#include <algorithm>
#include <cstdio>

#include "io/provenance.h"

namespace erg {

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

std::string RunSnapshot::executor_text() const { return erg::executor_text(executor, threads); }

RunState RunSnapshot::state() const { return {*terrain, step, totals}; }

double Snapshot::progress() const {
  if (goal <= goal_start) return 0;
  return std::clamp(static_cast<double>(step() - goal_start) / static_cast<double>(goal - goal_start), 0.0, 1.0);
}

double Snapshot::seconds_left() const {
  if (goal < 0 || steps_per_second <= 0) return -1;
  return static_cast<double>(std::max<std::int64_t>(0, goal - step())) / steps_per_second;
}

std::string clock_text(const Config& config, std::int64_t step) {
  std::string text = "step " + std::to_string(step);
  const auto add = [&text](const char* form, double amount) {
    char words[48];
    std::snprintf(words, sizeof words, form, amount);
    text += words;
  };
  const auto steps = static_cast<double>(step);
  const ModelInfo& model = find_model(config.model).info;
  if (!model.steps_a_year.empty()) {
    add(", year %.1f", steps / static_cast<double>(config.parameters.integer(model.steps_a_year)));
  }
  if (!model.seconds_a_step.empty()) add(", %.1f h", steps * config.parameters.real(model.seconds_a_step) / 3600);
  return text;
}

}  // namespace erg
