// The same seed gives the same bits: on any number of threads, with any instruction set, however the run is cut.
#include <gtest/gtest.h>

#include <numeric>

#include "sim/make_executor.h"
#include "world.h"

namespace erg::test {

using compute::ExecutorOptions;
using compute::InstructionSet;
using sim::make_executor;

namespace {

struct Case {
  std::string name;
  World world;
  bool rocks = false;
  int steps = 25;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const models::ModelType& model : models::catalogue()) {
    const std::string key = model.info.key;
    if (!World{.model = key}.moves_slabs()) continue;  // test_grains.cpp
    all.push_back({key, {.model = key, .extent = {150, 90}}});
    all.push_back({key + " oblique", {.model = key, .extent = {90, 150}, .wind = {237, 4.5}}});
    all.push_back(
        {key + " oblique, wide enough for blocks of columns",
         {.model = key, .extent = {270, 330}, .wind = {150, 4.5}, .settings = {{"neighbours", std::string("8")}}},
         true,
         5});
    all.push_back({key + " straight, each thread in columns of its own",
                   {.model = key, .extent = {60, 270}, .settings = {{"neighbours", std::string("8")}}},
                   true,
                   5});
    all.push_back({key + " swinging about an axis and about a diagonal",
                   {.model = key,
                    .extent = {270, 310},
                    .wind = {key == "werner" ? 225.0 : 270.0, 5},
                    .settings = {{"neighbours", std::string("8")}},
                    .spread = 20},
                   true,
                   6});
    all.push_back({key + " rocks", {.model = key, .extent = {131, 77}, .wind = {250, 6}}, true});
    all.push_back(
        {key + " nonrepeated",
         {.model = key, .extent = {77, 131}, .wind = {20, 5}, .settings = {{"polling", std::string("nonrepeated")}}}});
    all.push_back({key + " open, 8 neighbours",
                   {.model = key,
                    .extent = {100, 70},
                    .boundary = Boundary::open,
                    .inflow = 3,
                    .wind = {290, 5},
                    .settings = {{"neighbours", std::string("8")}}}});
    all.push_back(
        {key + " forced", {.model = key, .extent = {64, 64}, .settings = {{"forced_erosion", true}}, .sand = 1}});
    all.push_back(
        {key + " hardly stays",  // crowds the 8-bit lanes
         {.model = key, .extent = {64, 64}, .wind = {270, 1}, .settings = {{"p_sand", 0.002}, {"p_bare", 0.002}}},
         false,
         4});
  }
  return all;
}

std::uint64_t hash_of(const Case& scene, ExecutorOptions options) {
  Terrain terrain = scene.world.strewn();
  if (scene.rocks) raise_rocks(terrain, 15);
  scene.world.run(terrain, options, scene.steps);
  return state_hash(terrain);
}

TEST(SameBits, OnAnyNumberOfThreads) {
  for (const Case& scene : cases()) {
    const std::uint64_t one = hash_of(scene, {.name = "cpu", .threads = 1});
    for (const int threads : {2, 3, 8}) {
      EXPECT_EQ(hash_of(scene, {.name = "cpu", .threads = threads, .lines_a_thread = 1}), one)
          << scene.name << ", " << threads << " threads";
    }
  }
}

TEST(SameBits, WithEveryInstructionSet) {
  for (const Case& scene : cases()) {
    const std::uint64_t best = hash_of(scene, {.name = "cpu", .threads = 2, .lines_a_thread = 1});
    for (const InstructionSet set : {InstructionSet::portable, InstructionSet::avx2}) {
      if (set > compute::best_instruction_set()) continue;
      EXPECT_EQ(hash_of(scene, {.name = "cpu", .threads = 2, .instructions = set, .lines_a_thread = 1}), best)
          << scene.name << ", " << to_string(set);
    }
  }
}

TEST(SameBits, InARunCutInTwo) {
  for (const Case& scene : cases()) {
    for (const std::string executor : {"serial", "cpu"}) {
      const ExecutorOptions options{.name = executor, .threads = 2, .lines_a_thread = 1};
      Terrain terrain = scene.world.strewn();
      if (scene.rocks) raise_rocks(terrain, 15);
      const int half = scene.steps / 2;
      scene.world.run(terrain, options, half);
      scene.world.run(terrain, options, scene.steps - half, half);  // on an executor that knows nothing of the first
      EXPECT_EQ(state_hash(terrain), hash_of(scene, options)) << scene.name << ", " << executor;
    }
  }
}

/// An executor that keeps its planes under a swinging wind beside one that lays them from the terrain each step.
TEST(SameBits, WhereAWindSwings) {
  for (const Extent extent : {Extent{60, 48}, Extent{300, 280}}) {
    for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
      for (const double bearing : {270.0, 0.0, 130.0}) {
        const World world{
            .model = "nield_baas", .extent = extent, .boundary = boundary, .wind = {bearing, 5}, .spread = 15};
        for (const int threads : {1, 3}) {
          const ExecutorOptions options{.name = "cpu", .threads = threads, .lines_a_thread = 1};
          Terrain kept = world.strewn();
          raise_rocks(kept, 15);
          Terrain anew = kept;
          world.run(kept, options, 6);
          for (int step = 0; step < 6; ++step) world.run(anew, options, 1, step);
          EXPECT_EQ(state_hash(kept), state_hash(anew)) << extent.nx << " cells, " << bearing << ", " << threads;
        }
      }
    }
  }
}

/// The slabs lifted from each cell in a short run of a case, and what the run came to.
struct Counted {
  Grid<std::int32_t> lifts;
  std::uint64_t hash = 0;
};
Counted counted(const Case& scene, const ExecutorOptions& options, bool wanted = true) {
  constexpr int steps = 3;
  Terrain terrain = scene.world.strewn();
  if (scene.rocks) raise_rocks(terrain, 15);
  Counted result{Grid<std::int32_t>(scene.world.extent)};
  const auto executor = make_executor(options);
  if (wanted) executor->count_lifts(&result.lifts);
  const models::StepReport report = scene.world.run(terrain, *executor, steps);
  result.hash = state_hash(terrain);
  if (!wanted) return result;
  const auto counts = result.lifts.cells();
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), report.lifts)
      << scene.name << ", " << options.name;
  EXPECT_GT(report.lifts, 0) << scene.name;
  return result;
}

TEST(SameBits, CountingLiftsChangesNothingAndCountsThemAllOnAnyNumberOfThreads) {
  for (const Case& scene : cases()) {
    counted(scene, {.name = "serial"});
    const Counted one = counted(scene, {.name = "cpu", .threads = 1});
    const Counted three = counted(scene, {.name = "cpu", .threads = 3, .lines_a_thread = 1});
    EXPECT_TRUE(one.lifts == three.lifts) << scene.name;
    EXPECT_EQ(one.hash, three.hash) << scene.name;
    EXPECT_EQ(one.hash, counted(scene, {.name = "cpu", .threads = 3, .lines_a_thread = 1}, false).hash) << scene.name;
  }
}

TEST(SameBits, APollOfEachCellLiftsASlabFromEach) {
  // Werner lifts in the shadow too, so on deep sand each cell gives one slab when it is polled.
  const World world{.extent = {70, 50}, .wind = {250, 5}, .settings = {{"polling", std::string("nonrepeated")}}};
  for (const Machine& machine : machines()) {
    Terrain terrain(world.extent, 1, world.quantum());
    std::ranges::fill(terrain.edit_mobile().cells(), 30);
    terrain.open_ledger();
    Grid<std::int32_t> lifts(world.extent);
    const auto executor = make_executor(machine.options);
    executor->count_lifts(&lifts);
    world.run(terrain, *executor, 2);
    EXPECT_EQ(std::ranges::count(lifts.cells(), 2), 70 * 50) << machine.name;
    executor->count_lifts(nullptr);
    world.run(terrain, *executor, 1);
    EXPECT_EQ(std::ranges::count(lifts.cells(), 2), 70 * 50) << machine.name << ": no longer counted";
  }
}

TEST(SameBits, AnotherSeedOrStepGivesOthers) {
  World world;
  Terrain terrain = world.strewn();
  Terrain other = terrain;
  Terrain later = terrain;
  const ExecutorOptions options{.name = "cpu", .threads = 1};
  world.run(terrain, options, 3);
  world.run(later, options, 3, 1);
  world.seed += 1;
  world.run(other, options, 3);
  EXPECT_NE(state_hash(terrain), state_hash(other));
  EXPECT_NE(state_hash(terrain), state_hash(later));
}

}  // namespace
}  // namespace erg::test
