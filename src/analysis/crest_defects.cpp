#include "analysis/crest_defects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.h"

namespace erg::analysis {
namespace {

/// The phase of the waves near wave number `wanted` (cycles per cell) that face the wind.
Grid<double> wave_phase(const CoarseSurface& surface, double bearing, double wanted) {
  Spectrum2D real = transform(surface);
  Spectrum2D imaginary = real;
  const double toward_x = -std::sin(radians(bearing));
  const double toward_y = -std::cos(radians(bearing));
  for (int y = 0; y < real.values.ny(); ++y) {
    const double ky = signed_frequency(y, real.values.ny()) / (real.values.ny() * surface.cells_y);
    for (int x = 0; x < real.values.nx(); ++x) {
      const double kx = x / (real.nx * surface.cells_x);
      const double octaves = std::log2(std::max(std::hypot(kx, ky), 1e-12) / wanted);
      const double share = std::abs(octaves) < 1 ? std::pow(std::cos(octaves * std::numbers::pi / 2), 2) : 0;
      const double facing = kx * toward_x + ky * toward_y;
      // Of a frequency and its conjugate one faces the wind; their mean is real, and so is that turned by a quarter.
      real.values(x, y) *= facing != 0 ? share / 2 : 0;
      imaginary.values(x, y) *= std::complex<double>(0, facing > 0 ? -share / 2 : facing < 0 ? share / 2 : 0);
    }
  }
  Grid<double> phase = transform_back(std::move(real));
  const Grid<double> beside = transform_back(std::move(imaginary));
  for (std::size_t cell = 0; cell < phase.size(); ++cell) phase[cell] = std::atan2(beside[cell], phase[cell]);
  return phase;
}

}  // namespace

int count_crest_defects(const CoarseSurface& surface, double bearing, double spacing) {
  if (surface.heights.empty() || !(spacing > 0)) return 0;
  const Grid<double> phase = wave_phase(surface, bearing, 1 / spacing);
  const int last_x = surface.periodic ? phase.nx() : phase.nx() - 1;
  const int last_y = surface.periodic ? phase.ny() : phase.ny() - 1;
  const auto turn = [](double from, double to) { return std::remainder(to - from, 2 * std::numbers::pi); };
  int defects = 0;
  for (int y = 0; y < last_y; ++y) {
    for (int x = 0; x < last_x; ++x) {
      const double corners[] = {phase.wrapped(x, y), phase.wrapped(x + 1, y), phase.wrapped(x + 1, y + 1),
                                phase.wrapped(x, y + 1)};
      const double around = turn(corners[0], corners[1]) + turn(corners[1], corners[2]) + turn(corners[2], corners[3]) +
                            turn(corners[3], corners[0]);
      if (std::abs(around) > std::numbers::pi) ++defects;
    }
  }
  return defects;
}

}  // namespace erg::analysis
