// The kernels of slabs, by name.
#pragma once

#include "models/slab/plan.h"

namespace erg::models::slab {

// A plan's members change what it points to, never the plan.
#define ERG_KERNEL(family, name) \
  ERG_ON_DEVICE void name(const Plan& plan, compute::Items items) { const_cast<Plan&>(plan).name(items); }
#include "models/slab/slab_kernels.def"
#undef ERG_KERNEL

struct Kernels {
#define ERG_KERNEL(family, name) static const compute::KernelOf<Plan> name;
#include "models/slab/slab_kernels.def"
#undef ERG_KERNEL
};

}  // namespace erg::models::slab
