#include "models/snow/snow_kernels.h"

namespace erg::snow {

#define ERG_KERNEL(family, name) \
  constinit const KernelOf<Plan> Kernels::name = make_kernel<Plan, family::name>(#family "_" #name);
#include "models/snow/snow_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::snow
