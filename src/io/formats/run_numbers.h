// The numbers that a run is described by over time, declared once: the CSV of `erg run` and the plots of the window.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/migration.h"
#include "sim/simulation.h"

namespace erg::io {

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
  explicit RunMeter(const models::StepReport& totals, std::int64_t step) : last_totals_(totals), last_step_(step) {}

  /// The numbers now, in the order of run_numbers(); not-a-number for what is not known. Lifts, polls and flux are
  /// those since the last taking, migration that since the last taking or glance, if that is at most `longest_look`
  /// steps ago: after more, dunes may stand where others stood before.
  std::vector<double> take(sim::Simulation& simulation);
  /// Takes note of where the dunes stand, for the migration in the next numbers.
  void glance(sim::Simulation& simulation);
  /// Steps before a taking at which a glance is best, where none was taken since: dunes have moved some cells.
  static constexpr std::int64_t good_look = 10;
  static constexpr std::int64_t longest_look = 32;

 private:
  void look(sim::Simulation& simulation);

  models::StepReport last_totals_;
  analysis::MigrationTracker migration_;
  std::int64_t last_look_ = 0;
  std::int64_t last_step_ = 0;
};

}  // namespace erg::io
