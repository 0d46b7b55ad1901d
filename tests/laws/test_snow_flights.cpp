// The parallel flights of sintering snow: the same bits everywhere, exact mass, and the reference's statistics.
#include <gtest/gtest.h>

#include <cmath>

#include "models/snow/snow_solver.h"
#include "sim/make_executor.h"
#include "sim/simulation.h"
#include "world.h"

namespace erg::test {

using compute::InstructionSet;
using models::SnowLaw;

namespace {

/// Snow of half a metre with loose and bonded cells, in a wind that lifts both.
World drifting(double bearing, Boundary boundary = Boundary::torus) {
  World world{.model = "snow_sintering", .extent = {150, 71}, .boundary = boundary, .wind = {bearing, 5}, .sand = 40};
  world.settings = {{"start_age", 30.0}, {"snowfall", 30.0}, {"suspension_wind", 10.0}};
  if (boundary == Boundary::open) world.inflow = 0.4;
  return world;
}

TEST(SnowFlights, GiveTheSameBitsForAnyNumberOfThreads) {
  for (const double bearing : {270.0, 243.0, 0.0, 160.0}) {
    for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
      const World world = drifting(bearing, boundary);
      std::uint64_t expected = 0;
      for (const int threads : {1, 2, 3, 8}) {
        Terrain terrain = world.strewn();
        raise_rocks(terrain, 60);
        world.run(terrain, {.name = "cpu", .threads = threads, .sweeps = 8}, 6);
        if (threads == 1) expected = state_hash(terrain);
        EXPECT_EQ(state_hash(terrain), expected) << bearing << " deg, " << threads << " threads";
      }
    }
  }
}

/// A law with a bit of everything, made without the model.
SnowLaw rough_law() {
  SnowLaw law;
  law.lift_scale = 60;
  law.hop_cells = 30;
  law.clearance_16 = 40;
  law.entrainment = 0.02f;
  law.suspension = 0.05f;
  law.bonding = 0.02f;
  law.wind = 14;
  for (int k = 0; k <= 8 * models::OctaveTable::octaves; ++k) {
    law.age_threshold.values[k] = 0.01f * static_cast<float>(k - 120);
    law.hop.values[k] = 0.001f * static_cast<float>(k);
    law.hardening.values[k] = 0.5f + 0.01f * static_cast<float>(k);
  }
  for (int k = 0; k <= 256; ++k) law.strength_table[k] = 0.4f + 0.01f * static_cast<float>(k);
  return law;
}

std::uint64_t hash_after_steps(InstructionSet instructions, const std::string& executor_name) {
  const World world = drifting(250);
  Terrain terrain = world.strewn();
  raise_rocks(terrain, 60);
  std::vector<Field>& fields = terrain.edit_fields();
  for (const char* key : {"loose", "bonded", "age", "landed", "strength"}) {
    FieldInfo info;
    info.key = key;
    fields.push_back({info, Grid<float>(terrain.extent())});
  }
  for (std::size_t cell = 0; cell < terrain.mobile().size(); ++cell) {
    const std::int32_t loose =
        std::min(terrain.mobile()[cell] * static_cast<int>(cell % 3) / 2, terrain.mobile()[cell]);
    models::snow_layer(fields, models::SnowLayer::bonded)[cell] = static_cast<float>(terrain.mobile()[cell] - loose);
  }
  models::SnowStep snow{.law = rough_law(), .radii = {3, 10}, .shadow_fall = 5, .shows_strength = true};
  const auto executor =
      sim::make_executor({.name = executor_name, .threads = 2, .sweeps = 4, .instructions = instructions});
  for (std::uint64_t step = 0; step < 5; ++step) {
    snow.law.now += snow.law.step_hours;
    models::drift_snow(*executor, terrain, snow, {250, 14}, {3, step});
  }
  EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
  return state_hash(terrain);
}

TEST(SnowFlights, GiveTheSameBitsOnEveryInstructionSet) {
  for (const std::string executor : {"serial", "cpu"}) {
    const std::uint64_t expected = hash_after_steps(InstructionSet::portable, executor);
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
      if (set > compute::best_instruction_set()) continue;
      EXPECT_EQ(hash_after_steps(set, executor), expected) << executor << " " << to_string(set);
    }
  }
}

TEST(SnowFlights, KeepTheMass) {
  for (const Extent extent : {Extent{150, 71}, Extent{16, 130}, Extent{3, 5}, Extent{1, 64}, Extent{1, 1}}) {
    for (const double bearing : {270.0, 225.0, 7.0}) {
      for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
        World world = drifting(bearing, boundary);
        world.extent = extent;
        world.settings.emplace_back("hop_factor", 200.0);  // hops longer than some of these grids
        Terrain terrain = world.strewn();
        world.run(terrain, {.name = "cpu", .threads = 2, .sweeps = 8}, 5);
        EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected()) << extent.nx << " x " << extent.ny;
        for (const std::int32_t slabs : terrain.mobile().cells()) EXPECT_GE(slabs, 0);
        for (std::size_t cell = 0; cell < extent.cells(); ++cell) {
          EXPECT_GE(terrain.fields()[0].values[cell], 0) << "loose";
          EXPECT_GE(terrain.fields()[1].values[cell], 0) << "bonded";
        }
      }
    }
  }
}

/// Slabs that lie on top of walls after a drift.
std::int64_t on_walls(const std::string& executor, bool obstacles) {
  World world = drifting(270);
  world.settings = {{"snowfall", 0.0}, {"repose_angle", 80.0}, {"obstacles", obstacles}};
  Terrain terrain = world.strewn();
  raise_rocks(terrain, 2000);
  world.run(terrain, {.name = executor, .threads = 2, .sweeps = 8}, 10);
  std::int64_t slabs = 0;
  for (std::size_t cell = 0; cell < terrain.mobile().size(); ++cell) {
    if (terrain.bedrock()[cell] == 2000) slabs += terrain.mobile()[cell];
  }
  return slabs;
}

TEST(SnowFlights, StopBeforeWalls) {
  for (const std::string executor : {"serial", "cpu"}) {
    EXPECT_EQ(on_walls(executor, true), 0) << executor;
    EXPECT_GT(on_walls(executor, false), 0) << executor << ": or drift comes down on them";
  }
}

/// What has drifted and bonded, per cell.
struct Account {
  double lifts;
  double travel;
  double out;
  double bonded;
};

/// Loose snow in a fresh wind, or bonded snow in a gale.
Account account(const std::string& executor, bool gale, int bearing) {
  sim::Config config("snow_sintering");
  const std::string hours = gale ? "60" : "0";
  const std::string wind = gale ? "22" : "16";
  for (const std::string& setting :
       {std::string("grid.nx=192"), std::string("grid.ny=160"), std::string("grid.cell_size=0.1"),
        std::string("scene.sand=60"), std::string("run.sweeps=8"), "run.executor=" + executor,
        "parameters.start_age=" + hours, "wind.strength=" + wind, "wind.bearing=" + std::to_string(bearing)}) {
    sim::set_from_text(config, setting);
  }
  sim::Simulation simulation(config);
  for (int step = 0; step < 25; ++step) simulation.step();
  const models::StepReport& report = simulation.totals();
  const Terrain& terrain = simulation.terrain();
  const auto cells = static_cast<double>(terrain.extent().cells());
  double bonded = 0;
  for (const float slabs : find_field(terrain.fields(), "bonded")->values.cells()) bonded += static_cast<double>(slabs);
  return {static_cast<double>(report.lifts) / cells, report.travel / cells,
          static_cast<double>(report.slabs_out) / cells, bonded / cells};
}

TEST(SnowFlights, DriftAsOneSlabAtATime) {
  for (const int bearing : {270, 240}) {
    for (const bool gale : {false, true}) {
      const Account one = account("serial", gale, bearing);
      const Account all = account("cpu", gale, bearing);
      const auto alike = [&](double mine, double reference, double tolerance, const char* what) {
        ASSERT_GT(reference, 0) << what;
        EXPECT_NEAR(mine / reference, 1, tolerance) << what << ", " << bearing << " deg, gale " << gale;
      };
      // Oblique lines, which hold for a step, spread what comes down a little less: about 3% fewer lifts in a gale.
      alike(all.lifts, one.lifts, 0.06, "lifts");
      alike(all.travel, one.travel, 0.03, "travel");
      alike(all.out, one.out, 0.08, "carried off");
      alike(all.bonded, one.bonded, 0.03, "bonded");
    }
  }
}

}  // namespace
}  // namespace erg::test
