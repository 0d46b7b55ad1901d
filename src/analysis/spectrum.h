// What the spectrum of a surface says: how far apart its crests are and which way they run.
#pragma once

#include "analysis/fourier.h"

namespace erg {

/// What measure_spectrum() finds.
struct SpectrumNumbers {
  /// Mean wavelength in cells, of the whole two-dimensional spectrum: sum of P / sum of P |k|, with P the power and |k|
  /// the wave number in cycles per cell. 0 for a flat surface.
  double wavelength = 0;
  /// The axis along which crests run, degrees clockwise from north, in [0, 180): 0 is north-south. From the doubled
  /// angle of all wave vectors, weighted by power. 0 for a flat surface.
  double crest_bearing = 0;
  /// How far all crests run one way: 1 for a single train of waves, 0 for no preferred direction.
  double alignment = 0;
};

/// Of the surface without its mean; one with open edges is faded out toward them (see transform).
SpectrumNumbers measure_spectrum(const CoarseSurface& surface);

}  // namespace erg
