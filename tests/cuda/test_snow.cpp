// Sintering snow under the CUDA executor, its kernels run on the processor: the same bits as on threads, and what
// becomes of it when a call of the runtime fails.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/errors.h"
#include "models/snow/plan.h"
#include "models/snow/snow_step.h"
#include "on_cards.h"
#include "snow_cases.h"
#include "stories.h"

namespace erg::test {

using compute::Executor;
using models::find_model;
using models::SnowLayer;

namespace {

std::unique_ptr<Executor> emulated(const std::shared_ptr<Card>& card, int sweeps = 2) {
  return emulated_executor({.name = "cuda", .threads = 1, .sweeps = sweeps}, card);
}

TEST(CudaSnow, GivesTheSameBitsAsThreads) { expect_same_on_cards(snow_cases()); }

TEST(CudaSnow, GiveTheSameBitsAsPlainLoops) { expect_same_as_loops(snow_cases()); }

/// Without this the cases would prove little: snow lifts, comes in, is carried off, bonds and comes free in them, and
/// their flights cross edges.
TEST(CudaSnow, ItsCasesHaveEverythingHappen) {
  double loose = 0;
  for (const Case& scene : snow_cases()) {
    if (scene.world.extent.cells() < 100) continue;
    const auto card = std::make_shared<Card>();
    const auto executor = emulated(card, scene.sweeps);
    Terrain terrain = ground(scene);
    const models::StepReport report = scene.world.run(terrain, *executor, scene.steps);
    EXPECT_GT(report.lifts, 10) << scene.name;
    EXPECT_GT(report.travel, 20) << scene.name;
    const auto total = [&](SnowLayer layer) {
      double sum = 0;
      for (const float slabs : models::snow_layer(terrain.fields(), layer).cells()) sum += static_cast<double>(slabs);
      return sum;
    };
    EXPECT_GT(total(SnowLayer::bonded), 0) << scene.name;
    loose += total(SnowLayer::loose);
  }
  EXPECT_GT(loose, 1000);
}

/// Everything that the host code does for snow: winds from two sides, an oblique one, an edit, slabs in between, lifts
/// that are counted, strength that is shown.
StoryEnd snow_story(Executor& executor) {
  const World world{.model = "snow_sintering",
                    .extent = {9, 7},
                    .settings = {{"snowfall", 20.0}, {"start_age", 20.0}, {"hop_factor", 60.0}},
                    .sand = 12};
  StoryEnd end;
  end.lifts = Grid<std::int32_t>(world.extent);
  Terrain terrain = world.strewn();
  raise_rocks(terrain, 8);
  const auto model = find_model(world.model).make(world.values());
  model->prepare({.seed = world.seed});
  model->begin(terrain);
  const auto drift = [&](std::uint64_t step, double bearing) {
    model->step(terrain, {bearing, 16}, {world.seed, step}, executor);
    end.hear(executor);
  };
  drift(13, 270);
  executor.count_lifts(&end.lifts);
  drift(14, 250);
  drift(15, 20);  // shows strength
  executor.count_lifts(nullptr);
  executor.sync_to_host(terrain);
  terrain.edit_mobile()(3, 6) += 4;
  terrain.ledger().in += 4;
  drift(16, 20);
  models::move_slabs(executor, terrain, models::SlabLaw{}, {270, 3}, {world.seed, 17});
  drift(18, 0);
  end.close(executor, terrain);
  return end;
}

TEST(CudaSnow, WhicheverCallFailsTheProcessorGoesOnFromTheSameState) {
  expect_same_whichever_call_fails(snow_story, 300);
}

TEST(CudaSnow, KeepsTheTerrainOnTheDeviceBetweenSteps) {
  World world{.model = "snow_sintering", .extent = {20, 20}, .settings = {{"snowfall", 20.0}}, .sand = 20};
  const auto card = std::make_shared<Card>();
  const auto executor = emulated(card);
  Terrain terrain = world.strewn();
  const auto model = find_model(world.model).make(world.values());
  model->begin(terrain);
  const std::uint64_t before = state_hash(terrain);
  model->step(terrain, {270, 14}, {7, 0}, *executor);
  const long long allocated = card->of_kind["allocate"];
  const std::size_t bytes = card->bytes_out;
  model->step(terrain, {270, 14}, {7, 1}, *executor);
  EXPECT_EQ(card->of_kind["allocate"], allocated);
  EXPECT_EQ(card->bytes_out - bytes, models::snow_bounds * 4 + compute::counter_slots * kernels::step_counters * 8)
      << "bounds and counts";
  EXPECT_EQ(state_hash(terrain), before) << "stale until it is asked for";
  const std::size_t stepped = card->bytes_out;
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->bytes_out - stepped, 400u * 4 * 4) << "slabs, loose slabs, age and landing";
  EXPECT_NE(state_hash(terrain), before);
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->bytes_out - stepped, 400u * 4 * 4) << "nothing was done since";
  model->step(terrain, {270, 14}, {7, 15}, *executor);
  const std::size_t shown = card->bytes_out;
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->bytes_out - shown, 400u * 5 * 4) << "and strength, where a step has shown it";
  EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
}

/// As `cpu` does, in the same words; what was done before can still be had.
TEST(CudaSnow, RefusesSnowThatHasGrownTooHigh) {
  World world{.model = "snow_sintering", .extent = {20, 20}, .sand = 20};
  std::vector<std::string> problems;
  std::vector<std::uint64_t> hashes;
  Executor cpu({.name = "cpu", .threads = 1, .sweeps = 2});
  const auto cuda = emulated(std::make_shared<Card>());
  for (Executor* executor : {&cpu, cuda.get()}) {
    Terrain terrain = world.strewn();
    const auto model = find_model(world.model).make(world.values());
    model->begin(terrain);
    model->step(terrain, {270, 14, -10, 1e6}, {7, 0}, *executor);
    try {
      for (std::uint64_t step = 1; step < 1000; ++step) model->step(terrain, {270, 14, -10, 1e6}, {7, step}, *executor);
      ADD_FAILURE() << executor->name() << " never refused";
    } catch (const InputError& error) {
      problems.push_back(error.what());
    }
    executor->sync_to_host(terrain);
    hashes.push_back(state_hash(terrain));
  }
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[1], problems[0]);
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(cuda->name(), "cuda");
}

}  // namespace
}  // namespace erg::test
