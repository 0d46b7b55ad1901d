// The kernels of sintering snow for the instruction set "avx512" (compiler options in src/CMakeLists.txt).
#define ERG_KERNELS kernels_avx512
#include "models/snow/snow_kernels.inl"
