// A step that fails on a thread of the executor's is a failed step like any other: the worker says so and goes on.
#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>

#include "models/slab/slab_model.h"
#include "session/runner.h"
#include "small_config.h"

namespace erg {

using models::SlabModel;
using models::StepReport;
using session::Activity;
using sim::Config;

namespace {

using test::small_config;

std::atomic<bool> step_fails{false};
std::atomic<bool> begin_fails{false};

/// Werner's model on a machine whose memory gives out: half way through a step, on the last thread of the executor.
class Faulty : public SlabModel {
 public:
  explicit Faulty(const models::SlabValues& values) : SlabModel({}, values) {}

  void begin(Terrain& terrain) override {
    if (begin_fails) throw std::runtime_error("no memory to begin with");
    SlabModel::begin(terrain);
  }
  StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) override {
    const StepReport report = SlabModel::step(terrain, wind, key, executor);
    if (!step_fails) return report;
    executor.sync_to_host(terrain);
    terrain.edit_mobile().fill(1);  // what it leaves is nothing to go on from
    executor.parallel_for(1000, [](std::int64_t, std::int64_t end) {
      if (end == 1000) throw std::bad_alloc();
    });
    return report;
  }
};

Config faulty_config() {
  static const bool added = [] {
    models::ModelType type = models::slab_model_type({.key = "faulty", .title = "Faulty"}, {});
    type.make = [](const ParameterValues& values) {
      return std::make_unique<Faulty>(models::slab_binding({}).read(values));
    };
    models::add_model(std::move(type));
    return true;
  }();
  static_cast<void>(added);
  Config config = small_config();
  sim::change_model(config, "faulty");
  return config;
}

struct FailuresTest : testing::Test {
  FailuresTest() { step_fails = begin_fails = false; }

  std::shared_ptr<const session::Snapshot> still() {
    runner.wait_until_still();
    return runner.snapshot();
  }
  /// Runs eight steps, and has the ninth fail.
  void fail_after_eight() {
    runner.create({config});
    runner.run(8);
    still();
    step_fails = true;
    runner.run(4);
    still();
    step_fails = false;
  }
  std::uint64_t straight_hash(int steps) const {
    sim::Simulation simulation(config);
    for (int step = 0; step < steps; ++step) simulation.step();
    return state_hash(simulation.terrain());
  }

  const Config config = faulty_config();
  session::Log log;
  session::Runner runner{log};
};

TEST_F(FailuresTest, OfAThreadOfTheExecutorTakeTheRunsBackToTheLastWholeStep) {
  fail_after_eight();
  EXPECT_EQ(still()->activity, Activity::failed);
  EXPECT_NE(still()->message.find("memory"), std::string::npos) << still()->message;
  EXPECT_EQ(still()->step(), 8);
  EXPECT_EQ(state_hash(*still()->runs[0].terrain), straight_hash(8));
  runner.run(4);
  EXPECT_EQ(still()->activity, Activity::paused);
  EXPECT_EQ(state_hash(*still()->runs[0].terrain), straight_hash(12));
}

TEST_F(FailuresTest, ThatCannotBeTakenBackAtOnceAreNeitherShownNorGoneOnFrom) {
  const std::uint64_t whole = straight_hash(8);
  runner.create({config});
  runner.run(8);
  still();
  step_fails = begin_fails = true;
  runner.run(4);
  EXPECT_EQ(still()->activity, Activity::failed);
  EXPECT_EQ(still()->step(), 8);
  EXPECT_EQ(state_hash(*still()->runs[0].terrain), whole);
  // Every way on asks for whole runs first.
  log.clear();
  runner.step();
  runner.paint(0, {.x = 4, .y = 4, .radius = 2, .amount = 3}, 1);
  runner.change({config});
  EXPECT_EQ(state_hash(*still()->runs[0].terrain), whole);
  EXPECT_EQ(log.count(session::LogLevel::error), 3u) << log.text();
  // As soon as they can be had, it goes on.
  step_fails = begin_fails = false;
  runner.run(4);
  EXPECT_EQ(still()->activity, Activity::paused);
  EXPECT_EQ(state_hash(*still()->runs[0].terrain), straight_hash(12));
}

}  // namespace
}  // namespace erg
