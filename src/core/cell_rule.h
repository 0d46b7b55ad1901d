// How a rule of one cell is declared, so that host and device code share it. Forced inline on the host because the
// kernels that use it are compiled for several instruction sets: no copy may be shared between them by the linker.
#pragma once

#if defined(__CUDACC__)
#define ERG_CELL_RULE __host__ __device__ __forceinline__ constexpr
#else
#define ERG_CELL_RULE [[gnu::always_inline]] inline constexpr
#endif
