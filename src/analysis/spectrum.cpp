#include "analysis/spectrum.h"

#include <cmath>

#include "core/units.h"

namespace erg::analysis {

SpectrumNumbers measure_spectrum(const CoarseSurface& surface) {
  const Spectrum2D spectrum = transform(surface);
  double power_sum = 0;
  double wave_number_sum = 0;
  double cosine = 0;  // of twice the wave vector's angle: an axis has no sign
  double sine = 0;
  for (int y = 0; y < spectrum.ny(); ++y) {
    const double ky = signed_frequency(y, spectrum.ny()) / (spectrum.ny() * surface.cells_y);
    for (int x = 0; x < spectrum.nx(); ++x) {
      if (x == 0 && y == 0) continue;
      const double kx = signed_frequency(x, spectrum.nx()) / (spectrum.nx() * surface.cells_x);
      const double power = std::norm(spectrum(x, y));
      const double square = kx * kx + ky * ky;
      power_sum += power;
      wave_number_sum += power * std::sqrt(square);
      cosine += power * (kx * kx - ky * ky) / square;
      sine += power * 2 * kx * ky / square;
    }
  }
  // Rounding leaves a trace of power on a flat surface: 1e-20 square quanta a cell is none.
  const auto cells = static_cast<double>(spectrum.size());
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
