// Grains under the CUDA executor, its kernels run on the processor: the same bits as on threads, and what becomes of
// them when a call of the runtime fails.
#include <gtest/gtest.h>

#include <algorithm>

#include "grain_cases.h"
#include "models/grains/grains.h"
#include "on_cards.h"
#include "stories.h"

namespace erg::test {

using compute::Executor;
using models::bonded_field;
using models::grain_binding;
using models::GrainModel;

namespace {

TEST(CudaGrains, GiveTheSameBitsAsThreads) { expect_same_on_cards(grain_cases()); }

/// High ground far upwind of low ground, so that shadows are looked for over many rows.
TEST(CudaGrains, SeeTheSameShadowsBehindATower) {
  for (const double bearing : {270.0, 255.0, 40.0}) {
    const World world{.model = "grains", .extent = {260, 20}, .wind = {bearing, 6}, .sand = 3};
    Case scene{"a tower, bearing " + std::to_string(bearing), world, 0, 1};
    if (bearing == 40) std::swap(scene.world.extent.nx, scene.world.extent.ny);
    scene.rocks = 1900;  // 47 cells high: a shadow of 177 cells
    const auto executor = emulated_executor({.name = "cuda", .threads = 1}, std::make_shared<Card>());
    expect_same_as_threads(scene, *executor);
  }
}

/// Everything that the host code does for grains: winds from two sides, snow that bonds, an open edge, a picture of the
/// grains' ways, an edit, and slabs in between.
StoryEnd grain_story(Executor& executor) {
  const World world{.model = "grains",
                    .extent = {9, 7},
                    .boundary = Boundary::open,
                    .inflow = 1,
                    .settings = {{"sub_steps", std::int64_t{2}}, {"bonding_time", 4.0}, {"settling", 0.1}},
                    .sand = 9};
  StoryEnd end;
  Terrain terrain = world.strewn();
  GrainModel model(grain_binding().read(world.values()));
  model.begin(terrain);
  std::uint64_t ways = 0;
  const auto fly = [&](std::uint64_t step, double bearing) {
    model.keep_trajectories(step == 1 ? 5 : 0);
    model.step(terrain, {bearing, 9}, {world.seed, step}, executor);
    for (const Trajectory& path : model.trajectories()) ways = mix64(ways ^ path.size());
    end.hear(executor);
  };
  fly(0, 270);
  fly(1, 10);
  executor.sync_to_host(terrain);
  terrain.edit_mobile()(3, 3) += 4;
  terrain.ledger().in += 4;
  fly(2, 10);
  models::move_slabs(executor, terrain, models::SlabLaw{}, {270, 3}, {world.seed, 3});
  fly(4, 270);
  end.close(executor, terrain);
  end.hash ^= ways;
  return end;
}

TEST(CudaGrains, WhicheverCallFailsTheProcessorGoesOnFromTheSameState) {
  expect_same_whichever_call_fails(grain_story, 300, 3);
}

TEST(CudaGrains, KeepTheTerrainOnTheDeviceBetweenSteps) {
  const World world{.model = "grains", .extent = {20, 20}, .sand = 20};
  const auto card = std::make_shared<Card>();
  const auto executor = emulated_executor({.name = "cuda", .threads = 1}, card);
  Terrain terrain = world.strewn();
  GrainModel model(grain_binding().read(world.values()));
  model.begin(terrain);
  const std::uint64_t before = state_hash(terrain);
  model.step(terrain, {270, 9}, {7, 0}, *executor);
  const long long allocated = card->of_kind["allocate"];
  const std::size_t bytes = card->bytes_out;
  model.step(terrain, {270, 9}, {7, 1}, *executor);
  EXPECT_EQ(card->of_kind["allocate"], allocated);
  // What was counted, and for each pass of slides whether anything slid.
  const std::size_t counted = std::size_t{compute::counter_slots} * sizeof(models::GrainCounters);
  EXPECT_GE(card->bytes_out - bytes, counted + 4 * 4);
  EXPECT_LE(card->bytes_out - bytes, counted + 4 * 8 * 4);
  EXPECT_EQ(state_hash(terrain), before) << "stale until it is asked for";
  const std::size_t stepped = card->bytes_out;
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->bytes_out - stepped, 400u * 4) << "sand never bonds: the mobile layer alone";
  EXPECT_NE(state_hash(terrain), before);
  EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
}

/// An edit may leave parts of bonded grains, or some where no sand lies: both vanish in the next step.
TEST(CudaGrains, CutBondedGrainsThatCannotBeAsThreadsDo) {
  const World world{.model = "grains", .extent = {20, 20}, .sand = 20};
  const auto hash_on = [&](Executor& executor) {
    Terrain terrain = world.strewn();
    GrainModel model(grain_binding().read(world.values()));
    model.begin(terrain);
    find_field(terrain.edit_fields(), bonded_field)->values[7] = 0.5f;
    model.step(terrain, {270, 9}, {7, 0}, executor);
    executor.sync_to_host(terrain);
    EXPECT_EQ(find_field(terrain.fields(), bonded_field)->values[7], 0);
    return state_hash(terrain);
  };
  Executor cpu({.name = "cpu", .threads = 1});
  const auto cuda = emulated_executor({.name = "cuda", .threads = 1}, std::make_shared<Card>());
  EXPECT_EQ(hash_on(*cuda), hash_on(cpu));
}

TEST(CudaGrains, HaveTheirTerrainBroughtBackNowAndThen) {
  const World world{.model = "grains", .extent = {6, 5}, .settings = {{"sub_steps", std::int64_t{1}}}, .sand = 9};
  const auto executor = emulated_executor({.name = "cuda", .threads = 1}, std::make_shared<Card>());
  Terrain terrain = world.strewn();
  GrainModel model(grain_binding().read(world.values()));
  model.begin(terrain);
  const std::uint64_t before = state_hash(terrain);
  std::uint64_t step = 0;
  while (step < 400 && state_hash(terrain) == before) model.step(terrain, {270, 8}, {7, step++}, *executor);
  EXPECT_EQ(step, 256u) << "so that the processor never has more than these to do again";
}

}  // namespace
}  // namespace erg::test
