// The kernels of sintering snow for the instruction set "avx2" (compiler options in src/CMakeLists.txt).
#define ERG_KERNELS kernels_avx2
#include "models/snow/snow_kernels.inl"
