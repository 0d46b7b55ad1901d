#include "models/slab/sweep.h"

namespace erg::models {

using compute::InstructionSet;

namespace kernels_portable {
extern const SweepKernels<std::uint8_t> narrow_kernels;
extern const SweepKernels<std::uint16_t> wide_kernels;
}  // namespace kernels_portable
#if defined(__x86_64__)
namespace kernels_avx2 {
extern const SweepKernels<std::uint8_t> narrow_kernels;
extern const SweepKernels<std::uint16_t> wide_kernels;
}  // namespace kernels_avx2
namespace kernels_avx512 {
extern const SweepKernels<std::uint8_t> narrow_kernels;
extern const SweepKernels<std::uint16_t> wide_kernels;
}  // namespace kernels_avx512
#endif

template <>
const SweepKernels<std::uint8_t>& sweep_kernels<std::uint8_t>(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return kernels_avx512::narrow_kernels;
  if (set == InstructionSet::avx2) return kernels_avx2::narrow_kernels;
#endif
  (void)set;
  return kernels_portable::narrow_kernels;
}

template <>
const SweepKernels<std::uint16_t>& sweep_kernels<std::uint16_t>(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return kernels_avx512::wide_kernels;
  if (set == InstructionSet::avx2) return kernels_avx2::wide_kernels;
#endif
  (void)set;
  return kernels_portable::wide_kernels;
}

}  // namespace erg::models
