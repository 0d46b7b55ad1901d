#include "kernels/terrain_order.h"

#include "forcing/wind_frame.h"

namespace erg {

TerrainOrder terrain_order(const WindFrame& frame) { return {frame.width, frame.origin, frame.step_u, frame.step_v}; }

}  // namespace erg
