// How fast a pattern moves: the shift that fits each surface best to the one before it.
#pragma once

#include <cstdint>
#include <optional>

#include "analysis/fourier.h"

namespace erg::analysis {

/// A displacement in cells, or a velocity in cells a step; x east, y north.
struct Shift {
  double x = 0;
  double y = 0;
};

/// The shift of `later` against `earlier`, in cells, at the peak of their cross-correlation, found to a fraction of a
/// cell by a quadratic surface through the peak's neighbourhood. Where several shifts fit equally (waves without end),
/// the smallest. Nothing where either surface is flat or their extents differ. Between the two the pattern should move
/// less than half its spacing.
std::optional<Shift> pattern_shift(const CoarseSurface& earlier, const CoarseSurface& later);

/// Watches a pattern over a run and tells its mean velocity.
class MigrationTracker {
 public:
  /// Takes note of the surface after `step` steps; steps must grow. A change of extent starts anew.
  void observe(std::int64_t step, const CoarseSurface& surface, const ShareWork& share = do_alone);
  /// Forgets everything, for example after an edit.
  void restart() { *this = MigrationTracker(); }
  /// Counts velocity anew from the last observation.
  void start_anew();
  /// Steps between the first and the last observation that have a measured shift.
  std::int64_t steps() const { return steps_; }
  /// Mean velocity over those steps, cells a step; nothing before two observations of a surface that is not flat.
  std::optional<Shift> velocity() const;

 private:
  Spectrum2D last_;
  std::int64_t last_step_ = 0;
  std::int64_t steps_ = 0;
  Shift travelled_;
};

}  // namespace erg::analysis
