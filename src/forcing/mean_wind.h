// How strong a wind is on the mean, and where it drives things.
#pragma once

#include <optional>

#include "forcing/wind_schedule.h"

namespace erg::forcing {

/// The mean strength over one cycle of the schedule, in its seasons' unit: each step counts alike, calms too. Exact
/// where strength does not change within a season or a season has at most 64 steps; else to about 1e-3 of its change.
double mean_strength(const WindSchedule& schedule);

/// Bearing (degrees) from which the wind drives most: of the sum over one cycle of strength times direction. Nothing
/// where the seasons all but cancel each other (the sum is less than a twentieth of what it would be were all from one
/// side).
std::optional<double> resultant_bearing(const WindSchedule& schedule);

}  // namespace erg::forcing
