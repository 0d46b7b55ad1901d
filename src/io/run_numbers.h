// The numbers that a run is described by over time, declared once: the CSV of `erg run` and the plots of the window.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace erg {

/// One number of a run.
struct RunNumber {
  std::string key;  ///< the column's name in CSV
  std::string label;
  std::string unit;
  std::string meaning;
};

/// All of them; the first is the step.
const std::vector<RunNumber>& run_numbers();

/// Takes the numbers of one run, again and again.
class RunMeter {
 public:
  /// Starts from where the run stands.
  explicit RunMeter(const StepReport& totals, std::int64_t step) : last_totals_(totals), last_step_(step) {}

  /// The numbers now, in the order of run_numbers(). Lifts, polls and flux are those since the last taking.
  std::vector<double> take(Simulation& simulation);

 private:
  StepReport last_totals_;
  std::int64_t last_step_ = 0;
};

}  // namespace erg
