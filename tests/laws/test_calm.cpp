// A wind of strength 0 is a calm: time passes, and the wind moves nothing.
#include <gtest/gtest.h>

#include "models/model.h"
#include "sim/simulation.h"

namespace erg {

using forcing::WindInterval;
using models::catalogue;
using models::ModelType;
using sim::Config;
using sim::set_from_text;
using sim::Simulation;

namespace {

Config small(const std::string& model, const std::string& executor) {
  Config config(model);
  for (const char* value : {"nx=32", "ny=24", "run.seed=3", "run.threads=2"}) set_from_text(config, value);
  set_from_text(config, "run.executor=" + executor);
  return config;
}

TEST(Calm, MovesNothingInAnyModel) {
  for (const ModelType& type : catalogue()) {
    for (const char* executor : {"serial", "cpu"}) {
      SCOPED_TRACE(type.info.key + ", " + executor);
      Config config = small(type.info.key, executor);
      set_from_text(config, "wind.strength=0");
      Simulation still(config);
      const std::int64_t before = still.terrain().total_mobile();
      for (int step = 0; step < 5; ++step) still.step();
      EXPECT_EQ(still.step_count(), 5);
      EXPECT_FALSE(still.finished()) << still.totals().why_finished;
      EXPECT_EQ(still.totals().lifts, 0);
      EXPECT_EQ(still.totals().travel, 0);
      EXPECT_EQ(still.terrain().total_mobile(), before);
      EXPECT_EQ(still.terrain().ledger().expected(), before);
    }
  }
}

TEST(Calm, IsASeasonBetweenWinds) {
  for (const ModelType& type : catalogue()) {
    for (const char* executor : {"serial", "cpu"}) {
      SCOPED_TRACE(type.info.key + ", " + executor);
      Config config = small(type.info.key, executor);
      WindInterval wind = config.wind.intervals.front();
      wind.steps = 4;
      WindInterval calm = wind;
      calm.first = calm.last = 0;
      config.wind.intervals = {calm, wind, calm};
      Simulation run(config);
      for (int step = 0; step < 4; ++step) run.step();
      EXPECT_EQ(run.totals().lifts, 0);
      for (int step = 0; step < 4; ++step) run.step();
      const std::int64_t lifted = run.totals().lifts;
      EXPECT_GT(lifted, 0) << "the control";
      for (int step = 0; step < 4; ++step) run.step();
      EXPECT_EQ(run.totals().lifts, lifted);
    }
  }
}

}  // namespace
}  // namespace erg
