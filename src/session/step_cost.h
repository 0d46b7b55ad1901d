// How long a step of a setup takes on this machine, found out before its terrain is made.
#pragma once

#include <future>
#include <optional>

#include "sim/config.h"

namespace erg::session {

/// How many times more cells a terrain has for each thread than the one that is measured.
double times_the_measured_terrain(const sim::Config& config);

/// Seconds that a step of this config takes here: measured on a terrain of at most 64 x 64 cells, times
/// times_the_measured_terrain. None where such a terrain cannot be made. Takes some hundredths of a second
/// for the slowest models.
std::optional<double> measure_step(const sim::Config& config);

/// Measures in the background what was asked for last.
class StepCost {
 public:
  /// Seconds a step of this config takes; none until that is known. Ask once a frame.
  std::optional<double> of(const sim::Config& config);

 private:
  std::future<std::optional<double>> measuring_;
  std::optional<sim::Config> measured_;  ///< or being measured
  std::optional<double> seconds_;
};

}  // namespace erg::session
