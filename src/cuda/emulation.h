// The words of CUDA for an ordinary C++ compiler, so that tests can run the kernels on the processor: a kernel is then
// a function, and who calls it sets the thread's place first. nvcc never sees this file.
//
// Kernels that are to run this way use no shared memory, no barriers and no warp functions: one thread does one thing,
// and threads meet only in integer atomics.
#pragma once

#include <atomic>

// Names that are CUDA's. NOLINTBEGIN(readability-identifier-naming,bugprone-reserved-identifier)
#define __global__ inline
#define __device__

namespace erg {

struct EmulatedIndex {
  unsigned x = 0;
};
inline thread_local EmulatedIndex threadIdx;
inline thread_local EmulatedIndex blockIdx;
inline thread_local EmulatedIndex blockDim;
inline thread_local EmulatedIndex gridDim;

template <typename T>
T atomicAdd(T* place, T value) {
  return std::atomic_ref<T>(*place).fetch_add(value, std::memory_order_relaxed);
}

template <typename T>
T atomicExch(T* place, T value) {
  return std::atomic_ref<T>(*place).exchange(value, std::memory_order_relaxed);
}

template <typename T>
T atomicMax(T* place, T value) {
  std::atomic_ref<T> word(*place);
  T old = word.load(std::memory_order_relaxed);
  while (old < value && !word.compare_exchange_weak(old, value, std::memory_order_relaxed)) {
  }
  return old;
}

}  // namespace erg
// NOLINTEND(readability-identifier-naming,bugprone-reserved-identifier)
