// How a rule of one cell is declared, so that host and device code share it. Forced inline on the host because the
// kernels that use it are compiled for several instruction sets: no copy may be shared between them by the linker. A
// rule only computes; an act changes counts that other threads may change at the same time.
#pragma once

#if defined(__CUDACC__)
#define ERG_CELL_ACT __host__ __device__ __forceinline__
#else
#define ERG_CELL_ACT [[gnu::always_inline]] inline
#endif
#define ERG_CELL_RULE ERG_CELL_ACT constexpr
