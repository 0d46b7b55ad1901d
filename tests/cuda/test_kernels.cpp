// The CUDA executor's kernels, run on the processor, give the same bits as the executor `cpu`: terrain, counts, ledger.
#include <gtest/gtest.h>

#include "cases.h"
#include "emulated_calls.h"

namespace erg::test {
namespace {

TEST(CudaKernels, GiveTheSameBitsAsThreads) {
  for (const Case& scene : cases()) {
    for (const std::uint64_t shuffle : {1u, 2u}) {
      const auto card = std::make_shared<Card>();
      card->shuffle = shuffle;
      card->threads = static_cast<int>(shuffle);
      card->block = shuffle == 1 ? 64 : 33;
      CudaExecutor executor(scene.options(), std::make_unique<EmulatedCalls>(card));
      expect_same_as_threads(scene, executor);
    }
  }
}

}  // namespace
}  // namespace erg::test
