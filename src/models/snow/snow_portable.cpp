// The kernels of sintering snow for the instruction set "portable" (compiler options in src/CMakeLists.txt).
#define ERG_KERNELS kernels_portable
#include "models/snow/snow_kernels.inl"
