// Linear dunes: long ridges along the mean of two winds far apart, where one wind makes ridges across it.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/dune_outlines.h"
#include "analysis/spectrum.h"
#include "configured.h"
#include "sim/simulation.h"

namespace erg {

using analysis::coarse_surface;
using analysis::Layer;
using analysis::measure_spectrum;
using analysis::SpectrumNumbers;
using forcing::WindInterval;
using sim::Simulation;

namespace {

Simulation momiji_under(const std::vector<WindInterval>& seasons) {
  sim::Config config = test::configured("momiji", {"grid.nx=256", "grid.ny=160", "scene.sand=8", "run.executor=cpu"});
  config.wind.intervals = seasons;
  Simulation simulation(config);
  for (int step = 0; step < 1500; ++step) simulation.step();
  return simulation;
}

TEST(LinearDunes, RunAlongTheMeanOfTwoWindsAndAreLong) {
  WindInterval one{210, 5, 5, 5, {}};
  WindInterval other{330, 5, 5, 5, {}};
  one.spread = other.spread = 10;
  Simulation simulation = momiji_under({one, other});
  const SpectrumNumbers crests = measure_spectrum(coarse_surface(simulation.terrain(), Layer::surface));
  ASSERT_TRUE(crests.crest_bearing);
  EXPECT_NEAR(*crests.crest_bearing, 90, 10);
  EXPECT_GT(crests.alignment, 0.7);
  EXPECT_GE(analysis::find_dunes(simulation.terrain(), 270).endless, 1) << "a ridge longer than the terrain";
}

TEST(LinearDunes, OneWindMakesNone) {
  WindInterval one{270, 5, 5, 5, {}};
  one.spread = 10;
  Simulation simulation = momiji_under({one});
  const SpectrumNumbers crests = measure_spectrum(coarse_surface(simulation.terrain(), Layer::surface));
  ASSERT_TRUE(crests.crest_bearing);
  EXPECT_GT(std::abs(*crests.crest_bearing - 90), 60) << "ridges across the wind";
}

}  // namespace
}  // namespace erg
