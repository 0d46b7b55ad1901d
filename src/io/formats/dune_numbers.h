// The numbers that dunes are described by, declared once: the tables of `erg measure`.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/dune_outlines.h"
#include "analysis/dune_tracker.h"
#include "analysis/spectrum.h"
#include "io/formats/run_numbers.h"

namespace erg::io {

/// One dune of a moment, and how it moves on from there.
struct MeasuredDune {
  std::int64_t number = 0;  ///< stays with the dune from moment to moment
  analysis::Dune dune;
  analysis::DuneWay way;   ///< m, over so many steps:
  std::int64_t steps = 0;  ///< 0: it was not followed, or lost in the next steps (it merged, split or left)
};

/// The dunes of a run at one moment.
struct MeasuredDunes {
  std::int64_t step = 0;
  double days = 0;                  ///< not-a-number where steps have no time of their own
  double days_a_step = 0;           ///< likewise
  double cell_size = 0;             ///< m
  double bearing = 0;               ///< degrees: of the wind along which dunes are measured
  analysis::DuneOutlines outlines;  ///< its dunes are those below
  double sand_share = 0;            ///< of the mobile layer: what lies within outlines, over the rule's base
  double crest_spacing = 0;         ///< m; see analysis/crests.h; 0 where no line meets two crests
  analysis::SpectrumNumbers spectrum;
  std::vector<MeasuredDune> dunes;
};

/// The numbers of one dune; the first three are step, days and the dune's number.
const std::vector<RunNumber>& dune_numbers();
/// Their values, not-a-number for what a dune does not have.
std::vector<double> dune_row(const MeasuredDunes& moment, const MeasuredDune& dune);

/// The numbers of all dunes of a moment together; the first two are step and days. Means and standard deviations (with
/// n - 1) are over those dunes that have the number.
const std::vector<RunNumber>& field_numbers();
std::vector<double> field_row(const MeasuredDunes& moment);

}  // namespace erg::io
