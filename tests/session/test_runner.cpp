// The worker: commands in order, snapshots whole, the same bits as a run without a window.
#include <gtest/gtest.h>

#include <thread>

#include "session/runner.h"
#include "small_config.h"

namespace erg {

using session::Activity;
using session::Runner;

namespace {

using test::small_config;

/// The state after so many steps without any worker.
std::uint64_t straight_hash(const sim::Config& config, int steps) {
  sim::Simulation simulation(config);
  for (int step = 0; step < steps; ++step) simulation.step();
  return state_hash(simulation.terrain());
}

std::uint64_t hash_of(const Runner& runner, std::size_t run = 0) {
  return state_hash(*runner.snapshot()->runs.at(run).terrain);
}

struct RunnerTest : testing::Test {
  session::Log log;
  Runner runner{log};
};

TEST_F(RunnerTest, IsEmptyAtFirst) {
  EXPECT_EQ(runner.snapshot()->activity, Activity::empty);
  EXPECT_FALSE(runner.snapshot()->has_runs());
  runner.play();
  runner.wait_for_commands();
  EXPECT_EQ(runner.snapshot()->activity, Activity::empty);
  EXPECT_EQ(log.count(session::LogLevel::error), 1u);
}

TEST_F(RunnerTest, NStepsAreNSingleStepsAreAStraightRun) {
  const std::uint64_t expected = straight_hash(small_config(), 24);
  runner.create({small_config()});
  runner.run(24);
  runner.wait_until_still();
  EXPECT_EQ(runner.snapshot()->step(), 24);
  EXPECT_EQ(runner.snapshot()->activity, Activity::paused);
  EXPECT_EQ(hash_of(runner), expected);
  runner.create({small_config()});
  for (int step = 0; step < 24; ++step) runner.step();
  runner.wait_until_still();
  EXPECT_EQ(runner.snapshot()->step(), 24);
  EXPECT_EQ(hash_of(runner), expected);
}

TEST_F(RunnerTest, PausingOnTheWayChangesNoBit) {
  runner.create({small_config()});
  for (int stop = 0; stop < 6; ++stop) {
    runner.play();
    while (runner.snapshot()->step() < 5 * (stop + 1)) std::this_thread::yield();
    runner.pause();
    runner.wait_until_still();
  }
  const auto steps = static_cast<int>(runner.snapshot()->step());
  EXPECT_EQ(hash_of(runner), straight_hash(small_config(), steps)) << steps << " steps";
}

TEST_F(RunnerTest, CommandsAreCarriedOutInOrder) {
  runner.create({small_config("cpu", 1)});
  runner.run(5);
  runner.create({small_config("cpu", 2)});
  runner.step();
  runner.step();
  runner.wait_until_still();
  EXPECT_EQ(runner.snapshot()->step(), 2);
  EXPECT_EQ(hash_of(runner), straight_hash(small_config("cpu", 2), 2));
  EXPECT_EQ(runner.snapshot()->creations, 2u);
}

TEST_F(RunnerTest, SnapshotsAreNeverTorn) {
  runner.create({small_config(), small_config("cpu", 9)});
  runner.play();
  std::int64_t last_step = -1;
  std::uint64_t last_number = 0;
  for (int seen = 0; seen < 20;) {
    const auto now = runner.snapshot();
    if (now->number == last_number) {
      std::this_thread::yield();
      continue;
    }
    ++seen;
    ASSERT_GT(now->number, last_number);
    last_number = now->number;
    for (const session::RunSnapshot& run : now->runs) {
      ASSERT_EQ(run.step, now->step());
      ASSERT_EQ(run.terrain->total_mobile(), run.mass_now);
      ASSERT_EQ(run.mass_drift(), 0);
    }
    if (now->has_runs()) {
      ASSERT_GE(now->step(), last_step);
      last_step = now->step();
    }
  }
}

TEST_F(RunnerTest, AHeldSnapshotStaysAsItWas) {
  runner.create({small_config()});
  runner.run(3);
  runner.wait_until_still();
  const auto held = runner.snapshot();
  const std::uint64_t before = state_hash(*held->runs[0].terrain);
  runner.run(40);
  runner.wait_until_still();
  EXPECT_EQ(state_hash(*held->runs[0].terrain), before);
  EXPECT_NE(hash_of(runner), before);
}

}  // namespace
}  // namespace erg
