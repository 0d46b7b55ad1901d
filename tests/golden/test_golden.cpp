// The promise "the same seed gives the same dunes everywhere", held against hashes written down once: in Debug and
// Release, on any number of threads. A change of rules changes them; then say so in CHANGELOG.md and write the new ones
// here.
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "sim/simulation.h"

namespace erg {

using sim::set_from_text;

namespace {

struct Golden {
  std::string name;
  std::vector<std::string> settings;
  std::string serial;
  std::string cpu;
  int steps = 40;
};

std::vector<Golden> golden_runs() {
  return {
      {"werner", {"model=werner"}, "baa628cda055260e", "37e56da2db1050c9"},
      {"momiji", {"model=momiji"}, "6437c44d90990c50", "b3fe28a86d5aea3c"},
      {"bishop", {"model=bishop"}, "a148c554bc3fad65", "d69525b1eaf44e6c"},
      {"oblique", {"model=momiji", "wind.bearing=243"}, "ba2dec72a8ddaf8a", "3193fc0640cb9e52"},
      {"nonrepeated", {"model=werner", "parameters.polling=nonrepeated"}, "5e36aaa81f2b1408", "be296b396d053120"},
      {"forced", {"model=werner", "parameters.forced_erosion=true"}, "3be1317944196d12", "32454dd8ded01334"},
      {"swinging", {"model=momiji", "wind.spread=10"}, "e759031664bf684b", "6806b0b81b8d1636"},
      {"short hops", {"model=werner", "wind.strength=0.6", "wind.bearing=250"}, "26b9044f21723434", "b8b21c2ef7f2072e"},
      {"rocks", {"model=momiji", "scene.kind=rocks", "wind.bearing=280"}, "632ac49183c4a02b", "e894818973286e9d"},
      {"open",
       {"model=werner", "grid.boundary=open", "grid.inflow=3", "parameters.neighbours=8"},
       "bb18bff29a4ffcb3",
       "60755298a3b484a6"},
      {"nield_baas",
       {"model=nield_baas", "parameters.steps_per_year=10", "parameters.spreading=true"},
       "7b3cf6708da8868b",
       "fff4b1be5358d0a3"},
      {"snow_packing", {"model=snow_packing", "wind.strength=12"}, "abc1dd1dc3271383", "09e60403fb47633a"},
      {"snow_sintering",
       {"model=snow_sintering", "grid.cell_size=0.1", "scene.sand=40", "wind.strength=16", "wind.bearing=243",
        "parameters.start_age=6", "parameters.snowfall=20"},
       "38073d49174c6264",
       "716ecccc42048267"},
      {"uneven", {"model=bishop", "scene.kind=uneven", "scene.height=6"}, "3a8dc4e0c7e8850d", "61cbb83ffe452b6c"},
      {"grains",
       {"model=grains", "grid.cell_size=0.01", "scene.sand=60", "wind.strength=10", "wind.bearing=255"},
       "ec7adcae8a752b82",
       "ec7adcae8a752b82",
       4},
  };
}

std::string hash_after(const Golden& golden, const std::string& executor, int threads) {
  sim::Config config;
  set_from_text(config, "wind.spread=0");
  for (const std::string& setting : golden.settings) set_from_text(config, setting);
  for (const std::string& setting : {std::string("grid.nx=96"), std::string("grid.ny=80"), std::string("run.seed=42"),
                                     "run.executor=" + executor, "run.threads=" + std::to_string(threads)}) {
    set_from_text(config, setting);
  }
  sim::Simulation simulation(config);
  for (int step = 0; step < golden.steps; ++step) simulation.step();
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << state_hash(simulation.terrain());
  return text.str();
}

TEST(Golden, SerialRuns) {
  for (const Golden& golden : golden_runs()) EXPECT_EQ(hash_after(golden, "serial", 1), golden.serial) << golden.name;
}

TEST(Golden, CpuRunsOnAnyNumberOfThreads) {
  for (const Golden& golden : golden_runs()) {
    for (const int threads : {1, 2, 3, 8}) {
      EXPECT_EQ(hash_after(golden, "cpu", threads), golden.cpu) << golden.name << ", " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace erg
