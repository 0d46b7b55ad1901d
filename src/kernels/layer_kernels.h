// Kernels that turn a layer of 32-bit words between the terrain's order and the frame's: one thread, one cell.
#pragma once

#include <cstdint>

#include "compute/kernel.h"
#include "kernels/terrain_order.h"

namespace erg::kernels::layer {

struct Plan {
  TerrainOrder order;
  std::int32_t cells = 0;
  std::int32_t* staged = nullptr;  ///< in the terrain's order
  std::int32_t* layer = nullptr;   ///< in the frame's
};

struct Kernels {
#define ERG_KERNEL(family, name) static const compute::KernelOf<Plan> name;
#include "kernels/layer_kernels.def"
#undef ERG_KERNEL
};

/// From the terrain's order into the frame's.
ERG_ON_DEVICE void scatter(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells) plan.layer[cell] = plan.staged[plan.order.place(cell)];
}

/// The same way back.
ERG_ON_DEVICE void gather(const Plan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cells) plan.staged[plan.order.place(cell)] = plan.layer[cell];
}

}  // namespace erg::kernels::layer
