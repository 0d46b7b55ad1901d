// A vector whose first element starts a cache line, so that vector loads of rows never straddle two and threads that
// work on neighbouring parts do not share one.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace erg::compute {

/// Bytes that a processor's cache takes in at once.
inline constexpr std::size_t cache_line = 64;

/// Allocates memory that starts a cache line.
template <typename T>
struct CacheAligned {
  using value_type = T;
  CacheAligned() = default;
  template <typename Other>
  CacheAligned(const CacheAligned<Other>&) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{cache_line}));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete (memory, std::align_val_t{cache_line}); }
  bool operator==(const CacheAligned&) const { return true; }
};

template <typename T>
using AlignedVector = std::vector<T, CacheAligned<T>>;

}  // namespace erg::compute
