// Work that may be done by several threads, for code that knows none.
#pragma once

#include <cstdint>
#include <functional>

namespace erg {

/// A part of some work: the items from `begin` to before `end`.
using PartOfWork = std::function<void(std::int64_t begin, std::int64_t end)>;

/// Has `part` called for ranges that together make up all items below `items`, side by side or one after the other, and
/// returns when all is done. Whoever hands work over sees to it that neither order nor cut changes what comes of it.
using ShareWork = std::function<void(std::int64_t items, const PartOfWork& part)>;

/// All on the caller's thread.
inline void do_alone(std::int64_t items, const PartOfWork& part) {
  if (items > 0) part(0, items);
}

}  // namespace erg
