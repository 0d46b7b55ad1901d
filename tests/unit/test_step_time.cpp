#include "sim/step_time.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "sim/simulation.h"

namespace erg {

using forcing::WindInterval;
using forcing::WindSchedule;
using sim::Config;
using sim::days_after;
using sim::step_scale;
using sim::world_time_text;

namespace {

TEST(StepTime, OfSlabModelsFollowsFromTheSandThatPasses) {
  for (const char* model : {"werner", "momiji", "bishop"}) {
    Config config(model);
    const models::StepScale scale = step_scale(config);
    EXPECT_NEAR(scale.flux, 5 / 0.6 / 3, 1e-9) << "5 cells over .6, slabs of a third of a metre, cells of 1 m";
    EXPECT_NEAR(scale.seconds, scale.flux / 50 * seconds_a_year, 1e-3);
    config.parameters.set("sand_flux", 100.0);
    EXPECT_NEAR(step_scale(config).seconds, scale.seconds / 2, 1e-3) << "twice the sand, half the time";
    config.parameters.set("slab_height", 0.1);
    config.grid.set("cell_size", 2.0);
    config.wind = WindSchedule::constant(0, 10);
    config.parameters.set("p_sand", 0.3);
    EXPECT_NEAR(step_scale(config).flux, 10 / 0.3 * 0.1 * 2, 1e-9);
    config.parameters.set("p_sand", 0.0);
    EXPECT_EQ(step_scale(config).seconds, 0) << "sand that never rests says nothing";
  }
}

TEST(StepTime, IsThatOfTheSandThatReallyPasses) {
  for (const char* model : {"werner", "momiji", "bishop"}) {
    for (const char* executor : {"serial", "cpu"}) {
      Config config(model);
      config.grid.set("nx", std::int64_t{128});
      config.grid.set("ny", std::int64_t{128});
      config.scene.set("sand", 20.0);
      config.parameters.set("shadow_angle", 80.0);  // the flux leaves shadows out, which rubble has from the first step
      config.run.set("executor", std::string(executor));
      config.run.set("threads", std::int64_t{1});
      sim::Simulation simulation(config);
      const double slabs = simulation.step().travel / (128 * 128);  // past a cell
      EXPECT_NEAR(slabs / 3, step_scale(config).flux, 0.04 * step_scale(config).flux) << model << " " << executor;
    }
  }
}

TEST(StepTime, IsWhatTheModelSays) {
  EXPECT_EQ(step_scale(Config("grains")).seconds, 0);
  EXPECT_TRUE(std::isnan(days_after(Config("grains"), 7)));
  EXPECT_EQ(days_after(Config("snow_packing"), 7), 7);
  Config plants("nield_baas");
  plants.parameters.set("steps_per_year", std::int64_t{80});
  EXPECT_NEAR(days_after(plants, 40), 365.25 / 2, 1e-9);
  EXPECT_GT(step_scale(plants).flux, 0) << "what passes in a step is known too";
  Config snow("snow_sintering");
  snow.parameters.set("time_step", 60.0);
  EXPECT_EQ(step_scale(snow).seconds, 60);
}

TEST(StepTime, BelongsToTheMeanStrengthOfSeasons) {
  Config config("werner");
  WindInterval strong{.bearing = 270, .first = 8, .last = 8, .steps = 10, .curve = {}};
  WindInterval weak{.bearing = 90, .first = 2, .last = 2, .steps = 10, .curve = {}};
  config.wind = WindSchedule{{strong, weak}};
  EXPECT_NEAR(step_scale(config).seconds, step_scale(Config("werner")).seconds, 1e-6) << "5 on the mean";
}

TEST(StepTime, IsExplainedInWords) {
  EXPECT_EQ(world_time_text(40), "40 s");
  EXPECT_EQ(world_time_text(5400), "1.5 h");
  EXPECT_EQ(world_time_text(20.29 * seconds_a_day), "20.3 days");
  EXPECT_EQ(world_time_text(2.4 * seconds_a_year), "2.4 years");
  EXPECT_EQ(explain(Config("werner")).back(),
            "a step is 20.3 days (18.0 a year); in it 2.78 m² pass over flat sand, 50 m² a year");
  for (const std::string& line : explain(Config("grains"))) EXPECT_FALSE(line.starts_with("a step is")) << line;
}

}  // namespace
}  // namespace erg
