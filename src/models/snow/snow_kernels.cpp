#include "models/snow/snow_kernels.h"

namespace erg::models::snow {

#define ERG_KERNEL(family, name) \
  constinit const compute::KernelOf<Plan> Kernels::name = compute::make_kernel<Plan, family::name>(#family "_" #name);
#include "models/snow/snow_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::models::snow
