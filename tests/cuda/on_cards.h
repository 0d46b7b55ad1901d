// Cases on emulated cards.
#pragma once

#include <memory>
#include <vector>

#include "cases.h"
#include "emulated_calls.h"

namespace erg::test {

/// Kernels as plain loops on two threads of the processor, instead of what a family does there else, give the bits of
/// `cpu`.
inline void expect_same_as_loops(const std::vector<Case>& scenes) {
  for (const Case& scene : scenes) {
    compute::Executor executor(scene.options(), std::make_unique<compute::CpuBackend>(2));
    expect_same_as_threads(scene, executor, "cpu");
  }
}

/// Blocks and threads of the kernels come in two orders, on one thread and on two, in blocks of two sizes; each gives
/// the bits of `cpu`.
inline void expect_same_on_cards(const std::vector<Case>& scenes) {
  for (const Case& scene : scenes) {
    for (const std::uint64_t shuffle : {1u, 2u}) {
      const auto card = std::make_shared<Card>();
      card->shuffle = shuffle;
      card->threads = static_cast<int>(shuffle);
      card->block = shuffle == 1 ? 64 : 33;
      const auto executor = emulated_executor(scene.options(), card);
      expect_same_as_threads(scene, *executor);
    }
  }
}

}  // namespace erg::test
