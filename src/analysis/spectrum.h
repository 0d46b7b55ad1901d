// What the spectrum of a surface says: how far apart its crests are and which way they run.
#pragma once

#include <optional>

#include "analysis/fourier.h"

namespace erg::analysis {

/// What measure_spectrum() finds.
struct SpectrumNumbers {
  /// Mean wavelength in cells, of the whole two-dimensional spectrum: sum of P / sum of P |k|, with P the power and |k|
  /// the wave number in cycles per cell. 0 for a flat surface.
  double wavelength = 0;
  /// How far all crests run one way: 1 for a single train of waves, 0 for no preferred direction. The length of the
  /// mean of (cos 2a, sin 2a) over all wave vectors, a their angle, weighted by power.
  double alignment = 0;
  /// The axis along which crests run, degrees clockwise from north, in [0, 180): 0 is north-south. Across half the
  /// angle of that mean. Where alignment is low it is chance; 0 for a flat surface.
  double axis = 0;
  /// The same, and nothing where the alignment is less than `least_alignment`.
  std::optional<double> crest_bearing;
};
/// Fields of single barchans have alignments of 0.04 to 0.37 and bearings that are off by any angle; transverse and
/// linear dunes have 0.43 to 0.67, sand ripples 0.72.
inline constexpr double least_alignment = 0.4;

/// Of the surface without its mean; one with open edges is faded out toward them (see transform).
SpectrumNumbers measure_spectrum(const CoarseSurface& surface, const ShareWork& share = do_alone);

}  // namespace erg::analysis
