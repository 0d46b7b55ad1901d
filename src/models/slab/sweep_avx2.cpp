// The engine's kernels for the instruction set "avx2" (compiler options in src/CMakeLists.txt).
#define ERG_KERNELS kernels_avx2
#include "models/slab/sweep_kernels.inl"
