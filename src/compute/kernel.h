// Kernels: work of which one thread does one item (a cell, an edge, a grain, a line), on every back end from one
// source.
//
// A kernel is a plain function of a plan, which is a plain struct handed over by value, and of the items that one
// thread does. Threads meet only in integer atomics: no shared memory, no barriers, so their order decides nothing. On
// the processor a kernel is a loop over all items; on a card it is an entry with a thread for each. A family of models
// lists its kernels once, in X_kernels.def beside their source, one line `ERG_KERNEL(family, name)` each; handles,
// loops and entries are made from that list. So a back end knows kernels by their handles, and never a model.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/cell_rule.h"

#if defined(__CUDACC__)
#define ERG_ON_DEVICE __host__ __device__ inline
#else
#define ERG_ON_DEVICE inline
#endif

// NOLINTBEGIN(bugprone-macro-parentheses): `item` is a name that is declared
/// Each item below `count` that this thread does, within a kernel whose items are called `items`.
#define EACH_ITEM(item, count)                                                                                         \
  for (std::int32_t item = items.first, item##_end = items.below(static_cast<std::int32_t>(count)); item < item##_end; \
       item += items.stride)
// NOLINTEND(bugprone-macro-parentheses)

namespace erg::compute {

/// The items that one thread does: `first` and every `stride` from there on, before `end`. All items of a launch are
/// below 2^29: whole divisions of 32 bits cost a card a fraction of those of 64.
struct Items {
  std::int32_t first = 0;
  std::int32_t stride = 1;
  std::int32_t end = INT32_MAX;

  ERG_CELL_RULE std::int32_t below(std::int32_t count) const { return count < end ? count : end; }
};

/// How a kernel is named where it is launched.
struct Kernel {
  const char* name;  ///< "slab_lift"
  /// The kernel on the processor: what one thread does of a launch with this plan.
  void (*run)(const void* plan, Items items);
  std::size_t plan_bytes;
};

/// A kernel that takes this kind of plan.
template <typename Plan>
struct KernelOf : Kernel {};

namespace detail {

template <typename Plan, void (*function)(const Plan&, Items)>
void run_kernel(const void* plan, Items items) {
  function(*static_cast<const Plan*>(plan), items);
}

}  // namespace detail

/// The handle of a kernel.
template <typename Plan, void (*function)(const Plan&, Items)>
constexpr KernelOf<Plan> make_kernel(const char* name) {
  return {{name, detail::run_kernel<Plan, function>, sizeof(Plan)}};
}

// --- integer atomics, relaxed; each returns what was there before ---

template <typename T>
ERG_ON_DEVICE T atomic_add(T* place, T value) {
#if defined(__CUDA_ARCH__)
  return atomicAdd(place, value);
#else
  return std::atomic_ref<T>(*place).fetch_add(value, std::memory_order_relaxed);
#endif
}

template <typename T>
ERG_ON_DEVICE T atomic_exchange(T* place, T value) {
#if defined(__CUDA_ARCH__)
  return atomicExch(place, value);
#else
  return std::atomic_ref<T>(*place).exchange(value, std::memory_order_relaxed);
#endif
}

template <typename T>
ERG_ON_DEVICE T atomic_read(T* place) {
#if defined(__CUDA_ARCH__)
  return *static_cast<volatile T*>(place);
#else
  return std::atomic_ref<T>(*place).load(std::memory_order_relaxed);
#endif
}

/// Raises a bound that many threads share. Most find it high enough already and only look.
ERG_ON_DEVICE void raise(std::uint32_t* bound, std::uint32_t value) {
#if defined(__CUDA_ARCH__)
  if (*static_cast<volatile std::uint32_t*>(bound) < value) atomicMax(bound, value);
#else
  std::atomic_ref<std::uint32_t> word(*bound);
  std::uint32_t seen = word.load(std::memory_order_relaxed);
  while (seen < value && !word.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
#endif
}

// --- counters ---

/// What kernels count. Threads spread over `counter_slots` sets of words, so that they seldom wait for each other.
using CounterWord = unsigned long long;  // the type that CUDA's atomics take; sums are signed and wrap
inline constexpr int counter_slots = 256;

/// What one thread has counted; added to the launch's words once, when it is done.
template <int words>
struct Counters {
  std::int64_t of[words] = {};

  ERG_ON_DEVICE void add_to(CounterWord* all, Items items) const {
    CounterWord* slot = all + (items.first % counter_slots) * words;
    for (int k = 0; k < words; ++k) {
      if (of[k] != 0) atomic_add(slot + k, static_cast<CounterWord>(of[k]));
    }
  }
};

}  // namespace erg::compute
