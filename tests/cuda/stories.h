// Stories: runs in which all that happens which the host code has to deal with, on a card of which any call may fail.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../laws/world.h"
#include "cuda/cuda_backend.h"
#include "emulated_calls.h"

namespace erg::test {

inline const compute::ExecutorOptions two_sweeps{.name = "cpu", .threads = 1, .sweeps = 2};

/// What a story leaves.
struct StoryEnd {
  std::uint64_t hash = 0;
  MassLedger ledger;
  Grid<std::int32_t> lifts;  ///< from each cell, where they are counted
  std::vector<std::string> notices;
  std::string executor;

  /// Notes what the executor has to say.
  void hear(compute::Executor& machine) {
    if (const std::string notice = machine.take_notice(); !notice.empty()) notices.push_back(notice);
  }
  /// The last of it.
  void close(compute::Executor& machine, Terrain& terrain) {
    machine.sync_to_host(terrain);
    hear(machine);
    hash = state_hash(terrain);
    ledger = terrain.ledger();
    executor = machine.name();
    EXPECT_EQ(terrain.total_mobile(), ledger.expected());
  }
};

using Story = std::function<StoryEnd(compute::Executor&)>;

inline StoryEnd told_by_cpu(const Story& story) {
  compute::Executor executor(two_sweeps);
  return story(executor);
}

inline StoryEnd told_by(const Story& story, const std::shared_ptr<Card>& card) {
  const auto executor = emulated_executor(two_sweeps, card);
  return story(*executor);
}

inline void expect_all_freed(const Card& card) {
  EXPECT_EQ(card.device_bytes, 0u);
  EXPECT_TRUE(card.pinned.empty());
  EXPECT_EQ(card.handles, 0);
}

inline void expect_same(const StoryEnd& ours, const StoryEnd& theirs, const std::string& what) {
  EXPECT_EQ(ours.hash, theirs.hash) << what;
  EXPECT_EQ(ours.ledger, theirs.ledger) << what;
  EXPECT_TRUE(ours.lifts == theirs.lifts) << what;
}

/// A healthy card tells the story as threads do, without a notice. Whichever of its calls fails, the processor goes on
/// from the same state, with one notice. `stride`: up to so many calls from one that is made to fail to the next.
inline void expect_same_whichever_call_fails(const Story& story, long long least_calls, long long stride = 1) {
  const StoryEnd theirs = told_by_cpu(story);
  const auto healthy = std::make_shared<Card>();
  const StoryEnd ours = told_by(story, healthy);
  EXPECT_EQ(ours.executor, "cuda");
  EXPECT_TRUE(ours.notices.empty());
  expect_same(ours, theirs, "a healthy card");
  expect_all_freed(*healthy);
  ASSERT_GT(healthy->calls, least_calls);
  for (long long fail_at = 0; fail_at < healthy->calls; fail_at += 1 + fail_at % stride) {
    const std::string what = "call " + std::to_string(fail_at);
    const auto card = std::make_shared<Card>();
    card->fail_at = fail_at;
    const StoryEnd failed = told_by(story, card);
    expect_same(failed, theirs, what);
    // The last call of all waits for the stream before memory is freed; nothing is left to lose then.
    if (fail_at + 1 == healthy->calls) continue;
    EXPECT_EQ(failed.executor, "cpu") << what;
    ASSERT_EQ(failed.notices.size(), 1u) << what;
    EXPECT_NE(failed.notices[0].find("computing on the processor"), std::string::npos) << failed.notices[0];
    expect_all_freed(*card);
  }
}

}  // namespace erg::test
