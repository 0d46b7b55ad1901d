// A simulation with a stop-watch and an eye on its dunes: where the numbers of `--stats`, `bench` and `validate` come
// from.
#pragma once

#include <cstdint>
#include <string>

#include "analysis/migration.h"
#include "analysis/morphometry.h"
#include "analysis/spectrum.h"
#include "sim/simulation.h"

namespace erg::app {

/// The numbers of a run, after its last step. Heights in slabs, lengths in cells, bearings in degrees.
struct RunStatistics {
  analysis::Morphometry shape;
  double shadow_fraction = 0;          ///< share of cells in the shadow of the last wind
  analysis::SpectrumNumbers spectrum;  ///< of the surface
  double crest_spacing = 0;            ///< cells, along the last wind; see analysis/crests.h
  analysis::Shift migration;           ///< cells a step over the last part of the run; 0 for a flat surface
  double flux = 0;            ///< slabs per step that pass one cell of a line across the wind, mean since step 0
  models::StepReport totals;  ///< since step 0
  std::vector<models::Diagnostic> diagnostics;  ///< the model's own
  MassLedger ledger;
  std::int64_t mass_now = 0;    ///< slabs on the grid, counted
  std::uint64_t hash = 0;       ///< state_hash
  double seconds = 0;           ///< spent in steps, since this program took up the run
  double polls_per_second = 0;  ///< over the same steps
};

/// Takes a simulation from where it stands to step `last_step`.
class MeasuredRun {
 public:
  /// `watch_migration`: look at the pattern every few steps over the last quarter of the whole run (at most its last
  /// 500 steps), which costs a Fourier transform each time.
  MeasuredRun(sim::Simulation& simulation, std::int64_t last_step, bool watch_migration = true);

  /// True when the last step is done or nothing can move any more.
  bool finished() const { return simulation_.step_count() >= last_step_ || simulation_.finished(); }
  /// One time step, timed.
  models::StepReport step();
  /// All steps that are left.
  void finish();

  /// Polls since this object was made.
  std::int64_t polls() const { return polls_; }
  /// The numbers as the run stands.
  RunStatistics statistics();

 private:
  void observe();

  sim::Simulation& simulation_;
  std::int64_t last_step_;
  bool watch_migration_;
  std::int64_t watch_from_ = 0;
  std::int64_t watch_every_ = 1;
  analysis::MigrationTracker migration_;
  std::int64_t polls_ = 0;
  double seconds_ = 0;
};

/// One JSON object, as `--stats` writes it.
std::string statistics_json(sim::Simulation& simulation, const RunStatistics& statistics);

}  // namespace erg::app
