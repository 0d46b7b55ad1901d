// Work whose items last unequally long, shared out so that no thread of a pool waits long for another.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "compute/aligned_vector.h"

namespace erg::compute {

/// Items [0, items). Each member has a share of its own, so that it works where it worked before, and takes it in
/// chunks that get smaller and smaller; once that is done it helps the others with theirs.
class WorkQueue {
 public:
  WorkQueue(std::int64_t items, int members) : shares_(static_cast<std::size_t>(members)) {
    for (int member = 0; member < members; ++member) {
      Share& share = shares_[static_cast<std::size_t>(member)];
      share.next.store(items * member / members, std::memory_order_relaxed);
      share.end = items * (member + 1) / members;
    }
  }

  /// Calls work(begin, end) for chunks until none is left: for each member of the pool, each on its own thread or one
  /// after the other.
  template <typename Work>
  void take_chunks(int member, const Work& work) {
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      Share& share = shares_[(static_cast<std::size_t>(member) + k) % shares_.size()];
      for (;;) {
        const std::int64_t left = share.end - share.next.load(std::memory_order_relaxed);
        if (left <= 0) break;
        const std::int64_t chunk = std::max<std::int64_t>(1, left / part_of_the_rest);
        const std::int64_t begin = share.next.fetch_add(chunk, std::memory_order_relaxed);
        if (begin < share.end) work(begin, std::min(begin + chunk, share.end));
      }
    }
  }

 private:
  static constexpr std::int64_t part_of_the_rest = 8;

  struct alignas(cache_line) Share {
    std::atomic<std::int64_t> next{0};
    std::int64_t end = 0;
  };
  std::vector<Share> shares_;
};

}  // namespace erg::compute
