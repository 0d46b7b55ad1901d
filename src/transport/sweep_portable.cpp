// The engine's kernels for the instruction set "portable" (compiler options in src/CMakeLists.txt).
#define ERG_KERNELS kernels_portable
#include "transport/sweep_kernels.inl"
