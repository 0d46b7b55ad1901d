#include "kernels/layer_kernels.h"

namespace erg::kernels::layer {

#define ERG_KERNEL(family, name) \
  constinit const compute::KernelOf<Plan> Kernels::name = compute::make_kernel<Plan, family::name>(#family "_" #name);
#include "kernels/layer_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::kernels::layer
