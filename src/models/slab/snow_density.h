// How dense snow is: when it falls, and after days on the ground.
#pragma once

#include <array>
#include <string_view>

namespace erg::models {

/// Density of fresh snow, kg/m3. `temperature` in deg C.
/// Alta: 50 + 1.7 (T + 15)^1.5 above -15 deg C, else 50 (LaChapelle 1961 in Anderson 1976).
double fresh_density_alta(double temperature);
/// The same as 67.92 + 51.25 exp(T / 2.59) (Hedstrom & Pomeroy 1998).
double fresh_density_hedstrom_pomeroy(double temperature);

/// A class of seasonal snow: rho = (most - first) (1 - exp(-by_depth h - by_day day)) + first (Sturm et al. 2010).
struct SnowClass {
  std::string_view key;
  double most;      ///< kg/m3
  double first;     ///< kg/m3
  double by_depth;  ///< 1/cm
  double by_day;    ///< 1/day

  /// Density in kg/m3 of snow of this depth (cm) on this day of the winter.
  double density(double depth, double day) const;
};
/// All of them.
const std::array<SnowClass, 5>& snow_classes();

}  // namespace erg::models
