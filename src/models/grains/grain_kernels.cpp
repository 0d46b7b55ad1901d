#include "models/grains/grain_kernels.h"

namespace erg::grain {

#define ERG_KERNEL(family, name) \
  constinit const KernelOf<Plan> Kernels::name = make_kernel<Plan, family::name>(#family "_" #name);
#include "models/grains/grain_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::grain
