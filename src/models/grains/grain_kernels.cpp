#include "models/grains/grain_kernels.h"

namespace erg::models::grain {

#define ERG_KERNEL(family, name) \
  constinit const compute::KernelOf<Plan> Kernels::name = compute::make_kernel<Plan, family::name>(#family "_" #name);
#include "models/grains/grain_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::models::grain
