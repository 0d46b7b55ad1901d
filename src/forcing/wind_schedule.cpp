#include "forcing/wind_schedule.h"

#include <cmath>
#include <utility>

#include "core/random.h"

namespace erg::forcing {

WindSchedule WindSchedule::constant(double bearing, double strength) {
  WindInterval season;
  season.bearing = bearing;
  season.first = strength;
  season.last = strength;
  return WindSchedule{{season}};
}

bool WindSchedule::is_constant() const {
  return intervals.size() == 1 && intervals.front().first == intervals.front().last;
}

std::int64_t WindSchedule::cycle() const {
  std::int64_t steps = 0;
  for (const WindInterval& season : intervals) steps += season.steps;
  return steps;
}

Forcing WindSchedule::wind_at(std::int64_t step, const std::uint64_t* seed) const {
  const std::int64_t returns = step / cycle();
  std::int64_t rest = step % cycle();
  auto season = intervals.begin();
  while (rest >= season->steps) {
    rest -= season->steps;
    ++season;
  }
  const double time = season->steps > 1 ? static_cast<double>(rest) / static_cast<double>(season->steps - 1) : 0.0;
  Forcing now{season->bearing, std::lerp(season->first, season->last, season->curve.at(time))};
  for (const Channel& channel : channels()) {
    if (channel.of_interval != nullptr) now.*channel.now = (*season).*channel.of_interval;
  }
  if (seed == nullptr || season->spread <= 0) return now;
  const std::int64_t blown = returns * season->steps + rest;
  const auto number = static_cast<std::size_t>(season - intervals.begin());
  now.swing = wind_swing(season->spread, number, *seed, blown / season->hold);
  now.bearing = fold_bearing(season->bearing + now.swing);
  return now;
}

std::array<double, draws_a_round> wind_swings(double spread) {
  // Of the upper half. Literals: the same bits whatever the library's functions.
  constexpr std::array<double, draws_a_round / 2> quantiles{0.0816, 0.2468, 0.4185, 0.6026,
                                                            0.8079, 1.0509, 1.3714, 1.9382};
  std::array<double, draws_a_round> swings{};
  for (std::size_t k = 0; k < quantiles.size(); ++k) {
    // In parts of a degree that add to any whole bearing without rounding: a turned wind swings alike.
    const double swing = std::round(spread * quantiles[k] * 0x1p20) * 0x1p-20;
    swings[quantiles.size() + k] = swing;
    swings[quantiles.size() - 1 - k] = -swing;
  }
  return swings;
}

double wind_swing(double spread, std::size_t season, std::uint64_t seed, std::int64_t draw) {
  constexpr std::uint64_t word_of_swings = 0x77696e64;
  std::array<double, draws_a_round> swings = wind_swings(spread);
  const auto place = static_cast<std::uint64_t>(draw);
  std::uint64_t word = random_word({seed, place / draws_a_round}, 0, season, word_of_swings);
  for (std::size_t last = swings.size() - 1; last > 0; --last) {
    word = mix64(word);
    std::swap(swings[last], swings[((word >> 32) * (last + 1)) >> 32]);
  }
  return swings[place % draws_a_round];
}

}  // namespace erg::forcing
