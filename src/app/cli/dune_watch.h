// Measures the dunes of a run at moments of its course, and follows them on.
#pragma once

#include <cstdint>
#include <optional>

#include "analysis/dune_tracker.h"
#include "io/formats/dune_numbers.h"
#include "sim/simulation.h"

namespace erg::app {

/// How dunes are found and followed.
struct DuneWatchOptions {
  std::optional<std::int32_t> least;     ///< DuneRule::least; none: the usual rule's
  std::optional<std::int64_t> smallest;  ///< DuneRule::smallest; none: the usual one
  std::optional<double>
      bearing;               ///< along which wind dunes are measured; none: WindSchedule's resultant, or the last wind
  std::int64_t follow = 20;  ///< steps over which dunes are followed for their speed; 0: not
};

/// Watches one run, which must outlive it.
class DuneWatch {
 public:
  DuneWatch(sim::Simulation& simulation, DuneWatchOptions options) : simulation_(simulation), options_(options) {}

  /// The dunes as the run stands. Then takes the run `follow` steps on, to see how each of them moves.
  io::MeasuredDunes measure();
  /// One step of the run, with an eye on which dune is which.
  void step();

 private:
  double bearing() const;
  analysis::DuneOutlines outlines();
  io::MeasuredDunes as_it_is();

  sim::Simulation& simulation_;
  DuneWatchOptions options_;
  analysis::DuneTracker tracker_;
  bool looked_ = false;
};

}  // namespace erg::app
