// The kernels of slabs, by name.
#pragma once

#include "transport/slab_flight_kernels.h"
#include "transport/slab_layout_kernels.h"
#include "transport/slab_shadow_kernels.h"
#include "transport/slab_slide_kernels.h"

namespace erg::slab {

struct Kernels {
#define ERG_KERNEL(family, name) static const KernelOf<Plan> name;
#include "transport/slab_kernels.def"
#undef ERG_KERNEL
};

}  // namespace erg::slab
