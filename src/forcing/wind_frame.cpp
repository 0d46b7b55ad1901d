#include "forcing/wind_frame.h"

#include <cmath>
#include <numbers>

#include "core/units.h"

namespace erg::forcing {

WindFrame wind_frame(Extent extent, double bearing) {
  const double east = -std::sin(radians(bearing));
  const double north = -std::cos(radians(bearing));
  const bool along_x = std::abs(east) >= std::abs(north) - 1e-12;
  const double along = along_x ? east : north;
  // A component that is only the rounding error of sin or cos must not choose a side.
  const double across_raw = along_x ? north : east;
  const double across = std::abs(across_raw) < 1e-12 ? 0 : across_raw;

  WindFrame frame;
  const std::ptrdiff_t nx = extent.nx;
  const std::ptrdiff_t x_step = 1;
  const std::ptrdiff_t y_step = nx;
  frame.length = along_x ? extent.nx : extent.ny;
  frame.width = along_x ? extent.ny : extent.nx;
  frame.step_v = along_x ? x_step : y_step;
  frame.step_u = along_x ? y_step : x_step;
  if (along < 0) {
    frame.origin += frame.step_v * (frame.length - 1);
    frame.step_v = -frame.step_v;
  }
  if (across < 0) {
    frame.origin += frame.step_u * (frame.width - 1);
    frame.step_u = -frame.step_u;
  }
  // Quantised to 2^-24 so that a last bit of the platform's sine cannot reach the dunes.
  frame.tangent = std::round(std::min(1.0, std::abs(across / along)) * 0x1p24) * 0x1p-24;
  frame.cosine = 1 / std::sqrt(1 + frame.tangent * frame.tangent);
  return frame;
}

}  // namespace erg::forcing
