// Painting, undo, changes in a run, failures: through the worker.
#include <gtest/gtest.h>

#include "models/slab/terrain_heights.h"
#include "session/runner.h"
#include "small_config.h"

namespace erg {

using session::Activity;
using session::BrushMaterial;
using session::Log;
using session::LogLevel;
using session::Runner;
using sim::Config;
using sim::Simulation;

namespace {

using test::small_config;

struct EditsTest : testing::Test {
  Log log;
  Runner runner{log};

  std::shared_ptr<const session::Snapshot> still() {
    runner.wait_until_still();
    return runner.snapshot();
  }
  std::uint64_t hash(std::size_t run = 0) { return state_hash(*still()->runs.at(run).terrain); }
};

TEST_F(EditsTest, PaintedSandIsBookedToTheLastSlab) {
  runner.create({small_config()});
  runner.run(3);
  const std::int64_t before = still()->runs[0].mass_now;
  runner.paint(0, {.x = 10, .y = 10, .radius = 5, .amount = 20}, 1);
  const auto painted = still();
  const session::RunSnapshot& run = painted->runs[0];
  EXPECT_GT(run.mass_now, before);
  EXPECT_EQ(run.mass_drift(), 0);
  EXPECT_EQ(run.terrain->ledger().in, run.mass_now - before);
  EXPECT_EQ(painted->undo_count, 1u);
  runner.run(10);
  EXPECT_EQ(still()->runs[0].mass_drift(), 0);
  EXPECT_EQ(still()->runs[0].mass_now, run.mass_now);
}

TEST_F(EditsTest, TakingMoreThanThereIsTakesWhatThereIs) {
  runner.create({small_config()});
  runner.paint(0, {.x = 24, .y = 20, .radius = 200, .amount = -40000}, 1);
  const auto now = still();
  EXPECT_EQ(now->runs[0].terrain->mobile()(24, 20), 0);
  EXPECT_GE(*std::ranges::min_element(now->runs[0].terrain->mobile().cells()), 0);
  EXPECT_EQ(now->runs[0].mass_drift(), 0);
}

TEST_F(EditsTest, UndoRestoresTheExactStateAndRedoTheEdit) {
  runner.create({small_config()});
  runner.run(7);
  const auto before = still();
  const std::uint64_t hash_before = hash();
  for (int stamp = 0; stamp < 4; ++stamp) runner.paint(0, {.x = 10.0 + stamp, .y = 10, .radius = 4, .amount = 9}, 1);
  const std::uint64_t hash_painted = hash();
  ASSERT_NE(hash_painted, hash_before);
  EXPECT_EQ(still()->undo_count, 1u) << "one stroke";
  runner.run(6);
  const std::uint64_t hash_later = hash();
  runner.undo();
  const auto after = still();
  EXPECT_EQ(hash(), hash_before);
  EXPECT_EQ(after->step(), 7);
  EXPECT_EQ(after->runs[0].terrain->ledger(), before->runs[0].terrain->ledger());
  EXPECT_EQ(after->runs[0].totals.polls, before->runs[0].totals.polls);
  EXPECT_EQ(after->undo_count, 0u);
  runner.redo();
  EXPECT_EQ(hash(), hash_later);
  EXPECT_EQ(still()->step(), 13);
  runner.undo();
  runner.paint(0, {.x = 30, .y = 10, .radius = 4, .amount = 9}, 2);
  EXPECT_EQ(still()->redo_count, 0u);
}

TEST_F(EditsTest, AStrokeOnALandThatRunsIsOneUndo) {
  runner.create({small_config()});
  runner.run(4);
  const std::uint64_t hash_before = hash();
  for (int stamp = 0; stamp < 5; ++stamp) {
    runner.paint(0, {.x = 8.0 + stamp, .y = 10, .radius = 4, .amount = 9}, 1);
    runner.step();
  }
  EXPECT_EQ(still()->undo_count, 1u);
  EXPECT_EQ(still()->step(), 9);
  runner.undo();
  EXPECT_EQ(hash(), hash_before);
  EXPECT_EQ(still()->step(), 4);
  runner.paint(0, {.x = 8, .y = 10, .radius = 4, .amount = 9}, 2);
  runner.paint(0, {.x = 9, .y = 10, .radius = 4, .amount = 9}, 3);
  EXPECT_EQ(still()->undo_count, 2u) << "two strokes are two";
}

TEST_F(EditsTest, TheRoseKeepsWhatHasBlownWhateverIsSetLater) {
  Config config = small_config();
  config.wind.intervals = {{.bearing = 270, .first = 5, .last = 5, .steps = 10, .curve = {}}};
  constexpr std::size_t west = 12, south = 8;
  runner.create({config});
  runner.run(6);
  EXPECT_DOUBLE_EQ(still()->blown.sums[west], 30);
  config.wind.intervals.front().bearing = 180;
  runner.change({config});
  runner.run(4);
  const auto turned = still();
  EXPECT_DOUBLE_EQ(turned->blown.sums[west], 30) << "it has blown";
  EXPECT_DOUBLE_EQ(turned->blown.sums[south], 20);
  runner.paint(0, {.x = 8, .y = 10, .radius = 4, .amount = 9}, 1);
  runner.run(3);
  EXPECT_DOUBLE_EQ(still()->blown.sums[south], 35);
  runner.undo();
  EXPECT_EQ(still()->blown, turned->blown) << "undone, it has not blown";
  runner.reset();
  EXPECT_EQ(still()->blown, session::WindRecord()) << "nothing has";
}

TEST_F(EditsTest, WhatGrowsAfterUndoIsWhatWouldHaveGrown) {
  runner.create({small_config()});
  runner.run(5);
  still();
  runner.paint(0, {.material = BrushMaterial::rock, .x = 20, .y = 20, .radius = 6, .amount = 12}, 1);
  runner.run(5);
  still();
  runner.undo();
  runner.run(5);
  Simulation straight(small_config());
  for (int step = 0; step < 10; ++step) straight.step();
  EXPECT_EQ(hash(), state_hash(straight.terrain()));
}

TEST_F(EditsTest, ResetGoesBackToTheStartAndCanBeUndone) {
  runner.create({small_config()});
  const std::uint64_t start = hash();
  runner.run(12);
  const std::uint64_t later = hash();
  const double worked = still()->seconds_worked;
  EXPECT_GT(worked, 0);
  runner.reset();
  EXPECT_EQ(still()->step(), 0);
  EXPECT_EQ(still()->seconds_worked, 0);
  EXPECT_EQ(hash(), start);
  runner.undo();
  EXPECT_EQ(still()->step(), 12);
  EXPECT_EQ(still()->seconds_worked, worked) << "it took as long as before";
  EXPECT_EQ(hash(), later);
}

TEST_F(EditsTest, AChangedParameterTakesEffectAtTheNextStep) {
  Config other = small_config();
  other.parameters.set("p_sand", 0.2);
  runner.create({small_config()});
  runner.run(4);
  still();
  runner.change({other});
  runner.run(4);
  // The same from a checkpoint, as `erg run --resume` does it.
  Simulation first(small_config());
  for (int step = 0; step < 4; ++step) first.step();
  Simulation second(other, first.state());
  for (int step = 0; step < 4; ++step) second.step();
  EXPECT_EQ(hash(), state_hash(second.terrain()));
  EXPECT_EQ(still()->runs[0].config->parameters.real("p_sand"), 0.2);
}

TEST_F(EditsTest, AChangeThatNeedsANewTerrainIsRefused) {
  for (const auto& [group, key, value] :
       std::vector<std::tuple<ParameterValues Config::*, std::string, ParameterValue>>{
           {&Config::grid, "nx", std::int64_t{64}},
           {&Config::scene, "sand", 5.0},
           {&Config::run, "seed", std::int64_t{77}},
           {&Config::parameters, "slab_height", 0.5}}) {
    Config other = small_config();
    (other.*group).set(key, value);
    runner.create({small_config()});
    log.clear();
    runner.change({other});
    EXPECT_EQ(*still()->runs[0].config, small_config()) << key;
    EXPECT_EQ(log.count(LogLevel::error), 1u) << key;
  }
}

TEST_F(EditsTest, ATerrainThatCannotBeMadeLeavesTheRunsAlone) {
  runner.create({small_config()});
  runner.run(3);
  const std::uint64_t before = hash();
  Config bad = small_config();
  bad.scene.set("kind", std::string("image"));
  bad.scene.set("image", std::string("/nowhere/at/all.png"));
  runner.create({bad});
  const auto now = still();
  EXPECT_EQ(now->activity, Activity::paused);
  EXPECT_EQ(now->failed_creation, now->commands_done);
  EXPECT_EQ(hash(), before);
  EXPECT_GE(log.count(LogLevel::error), 1u);
}

TEST(Failure, OfAStepStopsTheRunsAndKeepsTheTerrain) {
  Log log;
  int steps_left = 12;
  Runner runner(log, [&steps_left] {
    if (steps_left-- == 0) throw std::runtime_error("the device is gone");
  });
  runner.create({small_config(), small_config("serial", 8)});
  runner.play();
  runner.wait_until_still();
  const auto failed = runner.snapshot();
  ASSERT_EQ(failed->activity, Activity::failed);
  EXPECT_EQ(failed->message, "the device is gone");
  EXPECT_LE(failed->step(), 12);
  EXPECT_EQ(log.count(LogLevel::error), 1u);
  // They stand whole, and go on from there as if nothing had happened.
  runner.run(20 - failed->step());
  runner.wait_until_still();
  EXPECT_EQ(runner.snapshot()->activity, Activity::paused);
  EXPECT_EQ(runner.snapshot()->message, "");
  Simulation straight(small_config());
  for (int step = 0; step < 20; ++step) straight.step();
  EXPECT_EQ(state_hash(*runner.snapshot()->runs[0].terrain), state_hash(straight.terrain()));
  EXPECT_EQ(runner.snapshot()->runs[1].step, 20);
}

TEST_F(EditsTest, AnotherConfigShowsTheSameTerrainWithoutACopy) {
  runner.create({small_config()});
  runner.run(3);
  const auto before = still();
  Config config = small_config();
  config.parameters.set("p_sand", 0.5);
  runner.change({config});
  const auto after = still();
  EXPECT_EQ(after->runs[0].config->parameters.real("p_sand"), 0.5);
  EXPECT_EQ(after->runs[0].terrain, before->runs[0].terrain);
  EXPECT_EQ(after->runs[0].terrain_version, before->runs[0].terrain_version);
  // Taken back and changed at once, it is another terrain.
  runner.reset();
  runner.change({small_config()});
  EXPECT_NE(still()->runs[0].terrain_version, before->runs[0].terrain_version);
}

TEST_F(EditsTest, PaintingBeyondTheHighestGroundIsRefused) {
  runner.create({small_config()});
  const std::uint64_t before = hash();
  runner.paint(0, {.x = 24.5, .y = 20.5, .radius = 3, .amount = models::highest_terrain}, 1);
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(still()->undo_count, 0u);
  EXPECT_EQ(log.count(LogLevel::error), 1u);
}

TEST_F(EditsTest, AStampReachesAcrossATorusAndStopsAtAnOpenEdge) {
  for (const std::string boundary : {"torus", "open"}) {
    Config config = small_config();
    config.grid.set("boundary", boundary);
    runner.create({config});
    const auto before = still();
    runner.paint(0, {.x = 0.5, .y = 20.5, .radius = 3, .amount = 10}, 1);
    const auto after = still();
    const auto added = [&](int x) {
      return after->runs[0].terrain->mobile()(x, 20) - before->runs[0].terrain->mobile()(x, 20);
    };
    EXPECT_EQ(added(0), 10) << boundary;
    EXPECT_EQ(added(1), 8) << boundary;  // 10 (1 - 1/9)^2 = 7.9
    EXPECT_EQ(added(47), boundary == "torus" ? 8 : 0) << boundary;
  }
}

TEST_F(EditsTest, PlantsArePaintedWithinTheirRange) {
  Config config("nield_baas");
  config.grid.set("nx", std::int64_t{48});
  config.grid.set("ny", std::int64_t{40});
  runner.create({config});
  const FieldInfo info = find_field(still()->runs[0].terrain->fields(), "grass")->info;
  const std::uint64_t before = hash();
  runner.paint(
      0, {.material = BrushMaterial::field, .x = 10.5, .y = 10.5, .radius = 4, .field = info.key, .strength = 1e9}, 1);
  const auto painted = still();
  const std::vector<Field>& fields = painted->runs[0].terrain->fields();
  EXPECT_EQ(find_field(fields, "grass")->values(10, 10), static_cast<float>(info.maximum));
  EXPECT_EQ(find_field(fields, "vegetation")->values(10, 10), 1) << "their sum shows it before the next step";
  EXPECT_EQ(painted->runs[0].mass_drift(), 0);
  EXPECT_NE(hash(), before);
  runner.run(3);
  still();
  runner.undo();
  EXPECT_EQ(hash(), before);
  runner.paint(0, {.material = BrushMaterial::field, .field = "no such layer", .strength = 1}, 2);
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(log.count(LogLevel::error), 1u);
}

TEST_F(EditsTest, ComparedRunsGoByOneClock) {
  Config first = small_config("cpu", 1);
  Config second = small_config("serial", 2);
  runner.create({first, second});
  runner.run(9);
  const auto now = still();
  ASSERT_EQ(now->runs.size(), 2u);
  for (std::size_t run = 0; run < 2; ++run) {
    EXPECT_EQ(now->runs[run].step, 9);
    EXPECT_EQ(now->runs[run].series->last_step(), 9) << "the numbers at rest are those of what is seen";
    Simulation alone(run == 0 ? first : second);
    for (int step = 0; step < 9; ++step) alone.step();
    EXPECT_EQ(hash(run), state_hash(alone.terrain()));
  }
}

TEST_F(EditsTest, ComparedRunsNeedOneWindAndAtMostFour) {
  Config other = small_config();
  other.wind = forcing::WindSchedule::constant(180, 5);
  runner.create({small_config(), other});
  EXPECT_FALSE(still()->has_runs());
  runner.create(std::vector<Config>(5, small_config()));
  EXPECT_FALSE(still()->has_runs());
  EXPECT_EQ(log.count(LogLevel::error), 2u);
}

}  // namespace
}  // namespace erg
