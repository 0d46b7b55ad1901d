// The kernel of showers: one thread, one cell.
#pragma once

#include <cstdint>

#include "compute/kernel.h"

namespace erg::rain {

/// What it reads and writes.
struct Plan {
  std::int32_t nx = 0;
  std::int32_t ny = 0;
  bool torus = true;
  std::int32_t drying = 0;  ///< what a cell loses of its moisture in a step
  std::int32_t x = 0;       ///< the middle of the shower
  std::int32_t y = 0;
  std::int32_t radius = -1;          ///< cells; less than 0: no shower
  std::int32_t* moisture = nullptr;  ///< 255 is wet through
};

struct Kernels {
#define ERG_KERNEL(family, name) static const compute::KernelOf<Plan> name;
#include "rain_kernels.def"
#undef ERG_KERNEL
};

/// Cells from one column (or row) to another, the shorter way round a torus.
ERG_ON_DEVICE std::int32_t distance(std::int32_t a, std::int32_t b, std::int32_t count, bool torus) {
  const std::int32_t apart = a < b ? b - a : a - b;
  return torus && count - apart < apart ? count - apart : apart;
}

/// Dries the ground, and wets it where the shower falls.
ERG_ON_DEVICE void wet(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.nx * plan.ny) {
    const std::int32_t dx = distance(cell % plan.nx, plan.x, plan.nx, plan.torus);
    const std::int32_t dy = distance(cell / plan.nx, plan.y, plan.ny, plan.torus);
    const std::int32_t left = plan.moisture[cell] - plan.drying;
    const bool rains = plan.radius >= 0 && dx * dx + dy * dy <= plan.radius * plan.radius;
    plan.moisture[cell] = rains ? 255 : left > 0 ? left : 0;
  }
}

}  // namespace erg::rain
