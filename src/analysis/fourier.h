// Surfaces made ready for Fourier analysis, and the two-dimensional transform itself.
#pragma once

#include <complex>

#include "core/grid.h"
#include "core/share_work.h"
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

/// The same with at most `most` blocks a side: 1024 are fine enough for spacing and motion of whole dunes, fewer do for
/// where dunes stand.
CoarseSurface coarse_surface(const Terrain& terrain, Layer layer, int most = 1024);

/// The spectrum of a surface of `nx` x values.ny() real heights. Frequency (a, b) stands at cell (a, b), a from 0 to
/// nx / 2, negative b wrapped to the far end; that of (-a, -b) is its conjugate, so those with negative a are left out.
struct Spectrum2D {
  Grid<std::complex<double>> values;
  int nx = 0;

  /// How many frequencies of the whole spectrum a value of this column stands for: itself, or its conjugate too.
  double weight(int column) const { return column == 0 || 2 * column == nx ? 1 : 2; }
};

/// The discrete Fourier transform of any extent, unscaled: sum of h exp(-2 pi i (ax/nx + by/ny)). The mean is removed
/// first; a surface that is not periodic is faded out toward its edges (Hann window) so that they do not count as
/// steps.
Spectrum2D transform(const CoarseSurface& surface, const ShareWork& share = do_alone);

/// The inverse transform, scaled so that it undoes `transform`.
Grid<double> transform_back(Spectrum2D spectrum, const ShareWork& share = do_alone);

/// The signed frequency of cell `index` of `count`, in cycles per `count`: 0, 1, ..., -2, -1.
inline int signed_frequency(int index, int count) { return index <= count / 2 ? index : index - count; }

}  // namespace erg::analysis
