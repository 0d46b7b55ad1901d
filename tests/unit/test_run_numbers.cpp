// The numbers of a run over time.
#include "io/formats/run_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace erg {

using io::RunMeter;
using sim::Simulation;

namespace {

/// One number of a row, by its key.
double number(const std::vector<double>& row, const std::string& key) {
  const auto& numbers = io::run_numbers();
  const auto place =
      std::find_if(numbers.begin(), numbers.end(), [&](const io::RunNumber& one) { return one.key == key; });
  return row.at(static_cast<std::size_t>(place - numbers.begin()));
}

Simulation barchan(double bearing) {
  sim::Config config("momiji");
  for (const char* setting :
       {"nx=96", "ny=96", "scene.kind=cone", "sand=0", "scene.height=8", "executor=cpu", "threads=1"}) {
    sim::set_from_text(config, setting);
  }
  config.wind = forcing::WindSchedule::constant(bearing, 5);
  Simulation simulation(config);
  for (int step = 0; step < 60; ++step) simulation.step();
  return simulation;
}

TEST(RunNumbers, TellHowFastDunesMigrateSinceTheLastLook) {
  for (const double bearing : {270.0, 180.0}) {
    Simulation simulation = barchan(bearing);
    RunMeter meter(simulation.totals(), simulation.step_count());
    EXPECT_TRUE(std::isnan(number(meter.take(simulation), "migration_x"))) << "nothing to compare with";
    for (int step = 0; step < 10; ++step) simulation.step();
    const std::vector<double> soon = meter.take(simulation);
    const char* along = bearing == 270 ? "migration_x" : "migration_y";
    const char* across = bearing == 270 ? "migration_y" : "migration_x";
    EXPECT_GT(number(soon, along), 0.1);
    EXPECT_LT(number(soon, along), 2);
    EXPECT_LT(std::abs(number(soon, across)), 0.1);
    for (int step = 0; step < 50; ++step) simulation.step();
    EXPECT_TRUE(std::isnan(number(meter.take(simulation), along))) << "too long ago";
    for (int step = 0; step < 50; ++step) simulation.step();
    meter.glance(simulation);
    for (std::int64_t step = 0; step < RunMeter::good_look; ++step) simulation.step();
    EXPECT_NEAR(number(meter.take(simulation), along), number(soon, along), 0.25) << "since the glance";
  }
}

TEST(RunNumbers, HaveACrestBearingOnlyWithAlignment) {
  Simulation simulation = barchan(270);
  RunMeter meter(simulation.totals(), simulation.step_count());
  const std::vector<double> row = meter.take(simulation);
  EXPECT_LT(number(row, "alignment"), 0.4) << "a round heap";
  EXPECT_TRUE(std::isnan(number(row, "crest_bearing")));
  Grid<std::int32_t>& mobile = simulation.edit_terrain().edit_mobile();
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) mobile(x, y) = x % 24;
  }
  simulation.book_edit();
  const std::vector<double> ridges = meter.take(simulation);
  EXPECT_GT(number(ridges, "alignment"), 0.9);
  EXPECT_NEAR(std::remainder(number(ridges, "crest_bearing"), 180), 0, 1);
  EXPECT_NEAR(number(ridges, "crest_spacing"), 24, 0.5);
  EXPECT_NEAR(number(ridges, "days"), 60 * 20.29, 1);
}

}  // namespace
}  // namespace erg
