// Surfaces made ready for Fourier analysis, and the two-dimensional transform itself.
#pragma once

#include <complex>

#include "core/grid.h"
#include "core/terrain.h"

namespace erg::analysis {

/// Which height of the terrain is meant.
enum class Layer {
  surface,  ///< bedrock + mobile
  mobile    ///< the mobile layer's thickness
};

/// Heights for analysis, in quanta: the terrain itself, or block means of a large one.
struct CoarseSurface {
  Grid<double> heights;
  double cells_x = 1;    ///< cells of the terrain in one block, eastward
  double cells_y = 1;    ///< the same northward
  bool periodic = true;  ///< true on a torus
};

/// The means of a layer over equal (if need be fractional) blocks, `blocks` of them on each side, at most one a cell.
/// The mean of the whole is kept exactly.
CoarseSurface coarse_surface(const Terrain& terrain, Layer layer, Extent blocks);

/// The same with at most 1024 blocks a side: fine enough for spacing and motion of whole dunes.
CoarseSurface coarse_surface(const Terrain& terrain, Layer layer);

using Spectrum2D = Grid<std::complex<double>>;

/// The discrete Fourier transform of any extent, unscaled: sum of h exp(-2 pi i (ax/nx + by/ny)). Frequency (a, b)
/// stands at cell (a, b), negative frequencies wrapped to the far end. The mean is removed first; a surface that is not
/// periodic is faded out toward its edges (Hann window) so that they do not count as steps.
Spectrum2D transform(const CoarseSurface& surface);

/// The real part of the inverse transform, scaled so that it undoes `transform`.
Grid<double> transform_back(Spectrum2D spectrum);

/// The signed frequency of cell `index` of `count`, in cycles per `count`: 0, 1, ..., -2, -1.
inline int signed_frequency(int index, int count) { return index <= count / 2 ? index : index - count; }

}  // namespace erg::analysis
