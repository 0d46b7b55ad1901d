#include "core/stamp.h"

#include <atomic>

namespace erg {

std::uint64_t Stamp::next() noexcept {
  static std::atomic<std::uint64_t> last{0};
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

}  // namespace erg
