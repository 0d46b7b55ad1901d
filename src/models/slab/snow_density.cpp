#include "models/slab/snow_density.h"

#include <cmath>

namespace erg::models {

double fresh_density_alta(double temperature) {
  if (temperature <= -15) return 50;
  return 50 + 1.7 * std::pow(temperature + 15, 1.5);
}

double fresh_density_hedstrom_pomeroy(double temperature) { return 67.92 + 51.25 * std::exp(temperature / 2.59); }

double SnowClass::density(double depth, double day) const {
  return first + (most - first) * (1 - std::exp(-by_depth * depth - by_day * day));
}

const std::array<SnowClass, 5>& snow_classes() {
  static constexpr std::array<SnowClass, 5> classes{{{"alpine", 597.5, 223.7, 0.0012, 0.0038},
                                                     {"maritime", 597.9, 257.8, 0.0010, 0.0038},
                                                     {"prairie", 594.0, 233.2, 0.0016, 0.0031},
                                                     {"tundra", 363.0, 242.5, 0.0029, 0.0049},
                                                     {"taiga", 217.0, 217.0, 0, 0}}};
  return classes;
}

}  // namespace erg::models
