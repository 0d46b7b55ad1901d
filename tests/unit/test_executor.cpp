#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "transport/executor.h"

namespace erg {
namespace {

TEST(Executor, PiecesCoverEachItemOnceOnAnyNumberOfThreads) {
  for (const char* name : {"serial", "cpu"}) {
    for (const int threads : {1, 2, 3, 8}) {
      const auto executor = make_executor({.name = name, .threads = threads});
      for (const int items : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(items));
        executor->for_pieces(items, [&](std::int64_t begin, std::int64_t end) {
          for (std::int64_t k = begin; k < end; ++k) ++visits[static_cast<std::size_t>(k)];
        });
        for (const auto& count : visits) EXPECT_EQ(count, 1) << name << ", " << threads << " threads";
      }
    }
  }
}

}  // namespace
}  // namespace erg
