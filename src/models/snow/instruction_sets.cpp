#include "models/snow/snow_planes.h"

namespace erg::models {

using compute::InstructionSet;

namespace kernels_portable {
extern const SnowKernels snow_kernels;
}
#if defined(__x86_64__)
namespace kernels_avx2 {
extern const SnowKernels snow_kernels;
}
namespace kernels_avx512 {
extern const SnowKernels snow_kernels;
}
#endif

const SnowKernels& snow_kernels(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return kernels_avx512::snow_kernels;
  if (set == InstructionSet::avx2) return kernels_avx2::snow_kernels;
#endif
  (void)set;
  return kernels_portable::snow_kernels;
}

}  // namespace erg::models
