#include "forcing/mean_wind.h"

#include <algorithm>
#include <cmath>

#include "forcing/bearing.h"

namespace erg::forcing {
namespace {

constexpr std::int64_t most_samples = 64;

double mean_of(const WindInterval& season) {
  if (season.first == season.last) return season.first;
  const std::int64_t samples = std::clamp<std::int64_t>(season.steps, 1, most_samples);
  double sum = 0;
  for (std::int64_t sample = 0; sample < samples; ++sample) {
    const double time = samples == season.steps ? static_cast<double>(sample) / std::max(1.0, samples - 1.0)
                                                : (static_cast<double>(sample) + 0.5) / static_cast<double>(samples);
    sum += std::lerp(season.first, season.last, season.curve.at(time));
  }
  const double mean = sum / static_cast<double>(samples);
  if (samples == season.steps) return mean;
  // The steps reach both ends of the curve, so the ends count half a step more than in its integral.
  const auto steps = static_cast<double>(season.steps);
  return (mean * (steps - 1) + (season.first + season.last) / 2) / steps;
}

}  // namespace

double mean_strength(const WindSchedule& schedule) {
  double sum = 0;
  for (const WindInterval& season : schedule.intervals) sum += mean_of(season) * static_cast<double>(season.steps);
  return sum / static_cast<double>(schedule.cycle());
}

std::optional<double> resultant_bearing(const WindSchedule& schedule) {
  if (schedule.intervals.size() == 1) return schedule.intervals.front().bearing;
  Direction drift;
  double whole = 0;
  for (const WindInterval& season : schedule.intervals) {
    const double weight = mean_of(season) * static_cast<double>(season.steps);
    const Direction toward = downwind(season.bearing);
    drift.x += weight * toward.x;
    drift.y += weight * toward.y;
    whole += weight;
  }
  if (std::hypot(drift.x, drift.y) < 0.05 * whole || !(whole > 0)) return std::nullopt;
  return bearing_of(drift);
}

}  // namespace erg::forcing
