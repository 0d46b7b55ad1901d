#include "kernels/terrain_order.h"

#include "forcing/wind_frame.h"

namespace erg::kernels {

TerrainOrder terrain_order(const forcing::WindFrame& frame) {
  return {frame.width, frame.origin, frame.step_u, frame.step_v};
}

}  // namespace erg::kernels
