#include "kernels/layer_kernels.h"

namespace erg::layer {

#define ERG_KERNEL(family, name) \
  constinit const KernelOf<Plan> Kernels::name = make_kernel<Plan, family::name>(#family "_" #name);
#include "kernels/layer_kernels.def"
#undef ERG_KERNEL

}  // namespace erg::layer
