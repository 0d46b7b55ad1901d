// A calm is a wind of strength 0: time passes, and nothing moves.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/simulation.h"
#include "world.h"

namespace erg::test {
namespace {

/// Material that moved in three steps on a bed without slopes.
StepReport moved(const std::string& model, const std::string& executor, double strength, bool& unchanged) {
  Config config(model);
  for (const std::string& setting :
       {std::string("grid.nx=32"), std::string("grid.ny=24"), "run.executor=" + executor}) {
    set_from_text(config, setting);
  }
  config.wind = Regime::constant(250, strength);
  Simulation simulation(config);
  const Grid<std::int32_t> before = simulation.terrain().mobile();
  for (int step = 0; step < 3; ++step) simulation.step();
  unchanged = std::ranges::equal(before.cells(), simulation.terrain().mobile().cells());
  return simulation.totals();
}

TEST(Calm, NothingMovesInAnyModel) {
  for (const ModelType& model : catalogue()) {
    for (const std::string executor : {"serial", "cpu"}) {
      bool unchanged = false;
      EXPECT_EQ(moved(model.info.key, executor, 0, unchanged).travel, 0) << model.info.key << ", " << executor;
      EXPECT_TRUE(unchanged) << model.info.key << ", " << executor;
      moved(model.info.key, executor, 15, unchanged);
      EXPECT_FALSE(unchanged) << "the control: " << model.info.key << ", " << executor;
    }
  }
}

}  // namespace
}  // namespace erg::test
