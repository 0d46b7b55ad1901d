// The kernels of all models as CUDA has them. Which there are, the build finds: every *_kernels.def.
#include <kernel_headers.inc>
#include "sim/cuda_entries.h"

namespace erg::sim {
namespace {

// Each family of kernels has a namespace of its own in one of these; the lists name it alone.
using namespace kernels;
using namespace models;

__device__ inline compute::Items items_of_thread() {
  return {static_cast<std::int32_t>(blockIdx.x * blockDim.x + threadIdx.x),
          static_cast<std::int32_t>(gridDim.x * blockDim.x), INT32_MAX};
}

#define ERG_KERNEL(family, name) \
  __global__ void family##_##name(family::Plan plan) { family::name(plan, items_of_thread()); }
#include <kernel_lists.inc>
#undef ERG_KERNEL

}  // namespace

const void* cuda_entry(const compute::Kernel& kernel) {
#define ERG_KERNEL(family, name) \
  if (&kernel == &family::Kernels::name) return reinterpret_cast<const void*>(family##_##name);
#include <kernel_lists.inc>
#undef ERG_KERNEL
  return nullptr;
}

}  // namespace erg::sim
