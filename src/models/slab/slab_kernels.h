// The kernels of slabs, by name.
#pragma once

#include "models/slab/flight_kernels.h"
#include "models/slab/layout_kernels.h"
#include "models/slab/shadow_kernels.h"
#include "models/slab/slide_kernels.h"

namespace erg::models::slab {

struct Kernels {
#define ERG_KERNEL(family, name) static const compute::KernelOf<Plan> name;
#include "models/slab/slab_kernels.def"
#undef ERG_KERNEL
};

}  // namespace erg::models::slab
