// What a run's steps stand for in the world: days, years, and the sand that they carry.
#pragma once

#include <string>
#include <vector>

#include "models/model.h"
#include "sim/config.h"

namespace erg::sim {

/// What a step of this config stands for: by its model, cells and the mean strength of its wind over the cycle. All
/// steps stand for the same time; in a season that is stronger than the mean, more sand moves in it.
models::StepScale step_scale(const Config& config);

/// Days of the world after so many steps; not-a-number where steps have no time of their own.
double days_after(const Config& config, std::int64_t steps);

/// A time in words: "40 s", "1.5 h", "20.3 days", "2.4 years".
std::string world_time_text(double seconds);

/// What the config's values mean, in words for people: in slabs and cells (ModelType::explain), and what a step is.
std::vector<std::string> explain(const Config& config);

}  // namespace erg::sim
