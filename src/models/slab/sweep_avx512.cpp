// The engine's kernels for the instruction set "avx512" (compiler options in src/CMakeLists.txt).
#define ERG_KERNELS kernels_avx512
#include "models/slab/sweep_kernels.inl"
