#include "models/slab/slab_kernels.h"

namespace erg::slab {

#define ERG_KERNEL(family, name) \
  constinit const KernelOf<Plan> Kernels::name = make_kernel<Plan, family::name>(#family "_" #name);
#include "models/slab/slab_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::slab
