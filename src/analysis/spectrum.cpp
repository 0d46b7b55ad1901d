#include "analysis/spectrum.h"

#include <cmath>

#include "core/units.h"

namespace erg::analysis {

SpectrumNumbers measure_spectrum(const CoarseSurface& surface, const ShareWork& share) {
  const Spectrum2D spectrum = transform(surface, share);
  double power_sum = 0;
  double wave_number_sum = 0;
  double cosine = 0;  // of twice the wave vector's angle: an axis has no sign
  double sine = 0;
  const Grid<std::complex<double>>& values = spectrum.values;
  for (int y = 0; y < values.ny(); ++y) {
    const double ky = signed_frequency(y, values.ny()) / (values.ny() * surface.cells_y);
    for (int x = 0; x < values.nx(); ++x) {
      if (x == 0 && y == 0) continue;
      const double kx = x / (spectrum.nx * surface.cells_x);
      const double power = spectrum.weight(x) * std::norm(values(x, y));
      const double square = kx * kx + ky * ky;
      power_sum += power;
      wave_number_sum += power * std::sqrt(square);
      cosine += power * (kx * kx - ky * ky) / square;
      // At half the sampling rate both signs of a frequency are one, which leans to no side.
      if (2 * y != values.ny()) sine += power * 2 * kx * ky / square;
    }
  }
  // Rounding leaves a trace of power on a flat surface: 1e-20 square quanta a cell is none.
  const auto cells = static_cast<double>(surface.heights.size());
  if (power_sum <= 1e-20 * cells * cells) return {};
  // The wave vector's angle counts from east, counter-clockwise; crests lie across it, and a bearing counts clockwise
  // from north: 90 - (angle + 90).
  const double crest = -degrees(0.5 * std::atan2(sine, cosine));
  const double folded = crest < 0 ? crest + 180 : crest;
  SpectrumNumbers numbers{
      power_sum / wave_number_sum, std::hypot(cosine, sine) / power_sum, folded >= 180 ? 0 : folded + 0.0, {}};
  if (numbers.alignment >= least_alignment) numbers.crest_bearing = numbers.axis;
  return numbers;
}

}  // namespace erg::analysis
