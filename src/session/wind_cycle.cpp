#include "session/wind_cycle.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace erg::session {

using forcing::WindInterval;
using forcing::WindSchedule;

namespace {

/// The summed strength of a season's steps [first, last); exact up to `most_samples` steps, sampled evenly beyond.
double summed_strength(const WindInterval& season, std::int64_t first, std::int64_t last) {
  constexpr std::int64_t most_samples = 512;
  const std::int64_t steps = last - first;
  if (steps <= 0) return 0;
  const WindSchedule alone{{season}};
  const std::int64_t samples = std::min(steps, most_samples);
  double sum = 0;
  for (std::int64_t i = 0; i < samples; ++i) sum += alone.at(first + (2 * i + 1) * steps / (2 * samples)).strength;
  return sum * static_cast<double>(steps) / static_cast<double>(samples);
}

/// The sector, of so many, that a bearing lies in.
std::size_t sector_of(double bearing, std::size_t sectors) {
  const double width = 360.0 / static_cast<double>(sectors);
  return static_cast<std::size_t>(std::floor(fold_bearing(bearing) / width + 0.5)) % sectors;
}

/// Adds what blows in steps [0, until) of one cycle.
void add_part(const WindSchedule& schedule, std::int64_t until, double weight, std::vector<double>& sums) {
  for (const WindInterval& season : schedule.intervals) {
    const std::int64_t last = std::clamp<std::int64_t>(until, 0, season.steps);
    const double part = weight * summed_strength(season, 0, last) / forcing::draws_a_round;
    for (const double swing : forcing::wind_swings(season.spread))
      sums[sector_of(season.bearing + swing, sums.size())] += part;
    until -= last;
  }
}

/// The sums over steps [0, until) of the run.
std::vector<double> sums_until(const WindSchedule& schedule, std::int64_t until, std::size_t sectors) {
  std::vector<double> sums(sectors, 0.0);
  const std::int64_t cycle = schedule.cycle();
  if (until >= cycle) add_part(schedule, cycle, static_cast<double>(until / cycle), sums);
  add_part(schedule, until % cycle, 1, sums);
  return sums;
}

}  // namespace

std::size_t WindCycle::season_at(std::int64_t step) const {
  const auto after = std::ranges::upper_bound(season_starts, position(step));
  return static_cast<std::size_t>(after - season_starts.begin()) - 1;
}

WindCycle sample_cycle(const WindSchedule& schedule, std::size_t samples) {
  WindCycle cycle;
  cycle.length = schedule.cycle();
  std::int64_t start = 0;
  for (const WindInterval& season : schedule.intervals) {
    cycle.season_starts.push_back(start);
    start += season.steps;
  }
  samples = std::max<std::size_t>(samples, 2);
  for (std::size_t i = 0; i < samples; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(samples - 1);
    const auto step = static_cast<std::int64_t>(std::llround(part * static_cast<double>(cycle.length - 1)));
    cycle.steps.push_back(step);
    cycle.strengths.push_back(schedule.at(step).strength);
  }
  return cycle;
}

WindRose wind_rose(const WindSchedule& schedule, std::int64_t now, std::int64_t end, std::size_t sectors) {
  sectors = std::max<std::size_t>(sectors, 4);
  now = std::max<std::int64_t>(now, 0);
  WindRose rose{sums_until(schedule, now, sectors), sums_until(schedule, std::max(now, end), sectors)};
  for (std::size_t i = 0; i < sectors; ++i) rose.to_blow[i] = std::max(0.0, rose.to_blow[i] - rose.blown[i]);
  return rose;
}

void WindRecord::add(const forcing::Forcing& wind) { sums[sector_of(wind.bearing, sectors)] += wind.strength; }

WindRecord WindRecord::of(const WindSchedule& schedule, std::int64_t steps) {
  WindRecord record;
  std::ranges::copy(wind_rose(schedule, steps, steps, sectors).blown, record.sums.begin());
  return record;
}

}  // namespace erg::session
