#include "wind/regime.h"

#include <cmath>

namespace erg {

Regime Regime::constant(double bearing, double strength) {
  Season season;
  season.bearing = bearing;
  season.first = strength;
  season.last = strength;
  return Regime{{season}};
}

bool Regime::is_constant() const { return seasons.size() == 1 && seasons.front().first == seasons.front().last; }

std::int64_t Regime::cycle() const {
  std::int64_t steps = 0;
  for (const Season& season : seasons) steps += season.steps;
  return steps;
}

WindNow Regime::at(std::int64_t step) const {
  std::int64_t rest = step % cycle();
  auto season = seasons.begin();
  while (rest >= season->steps) {
    rest -= season->steps;
    ++season;
  }
  const double time = season->steps > 1 ? static_cast<double>(rest) / static_cast<double>(season->steps - 1) : 0.0;
  WindNow now{season->bearing, std::lerp(season->first, season->last, season->curve.at(time))};
  now.snowfall = season->snowfall;
  return now;
}

}  // namespace erg
