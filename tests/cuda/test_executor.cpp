// The CUDA executor's host code against an emulated card: memory, copies, and what happens when a call fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <list>

#include "stories.h"

namespace erg::test {

using compute::Executor;
using models::Cover;
using models::CoverField;
using models::find_model;
using models::move_slabs;
using models::SlabLaw;

namespace {

World small_world() { return {.model = "bishop", .extent = {12, 9}, .boundary = Boundary::open, .inflow = 2}; }

/// Two winds, a cover that grows, the terrain looked at in between: everything that the host code does.
StoryEnd slab_story(Executor& executor) {
  const World world = small_world();
  StoryEnd end;
  end.lifts = Grid<std::int32_t>(world.extent);
  executor.count_lifts(&end.lifts);
  Terrain terrain = world.strewn();
  raise_rocks(terrain, 5);
  const auto made = find_model(world.model).make(world.values());
  Cover cover{CoverField(world.extent)};
  for (int step = 0; step < 6; ++step) {
    SlabLaw law = dynamic_cast<const models::SlabModel&>(*made).law(terrain);
    if (step % 2 == 0) cover.edit().fill(static_cast<std::uint8_t>(20 * (step / 2)));
    law.cover = &cover;
    const forcing::Forcing wind{step < 3 ? 270.0 : 10.0, 3};
    move_slabs(executor, terrain, law, wind, {world.seed, static_cast<std::uint64_t>(step)});
    if (step == 3) executor.sync_to_host(terrain);
    end.hear(executor);
  }
  end.close(executor, terrain);
  executor.count_lifts(nullptr);
  return end;
}

TEST(CudaExecutor, WhicheverCallFailsTheProcessorGoesOnFromTheSameState) {
  expect_same_whichever_call_fails(slab_story, 100);
}

TEST(CudaExecutor, SaysWhyThereIsNoDevice) {
  const auto none = std::make_shared<Card>();
  none->devices = 0;
  const auto without = emulated_executor(two_sweeps, none);
  EXPECT_EQ(without->name(), "cpu");
  EXPECT_EQ(without->take_notice(), "cuda: there is no CUDA device; computing on the processor");
  EXPECT_EQ(without->take_notice(), "");

  const auto not_built = cuda::make_cuda_executor(two_sweeps, nullptr, emulated_entry);
  EXPECT_EQ(not_built->take_notice(), "cuda: this program was built without CUDA; computing on the processor");

  const auto old_driver = std::make_shared<Card>();
  old_driver->fail_at = 0;
  old_driver->fail_kind = "count";
  const auto refused = emulated_executor(two_sweeps, old_driver);
  EXPECT_EQ(refused->take_notice(),
            "cuda: unspecified launch failure (while looking for a device); computing on the processor");
}

TEST(CudaExecutor, GoesOnOnTheProcessorWhenTheTerrainDoesNotFit) {
  const auto card = std::make_shared<Card>();
  card->memory = 1000;
  const StoryEnd ours = told_by(slab_story, card);
  expect_same(ours, told_by_cpu(slab_story), "too little memory");
  ASSERT_EQ(ours.notices.size(), 1u);
  EXPECT_NE(ours.notices[0].find("out of memory (asked for"), std::string::npos) << ours.notices[0];
  expect_all_freed(*card);
}

TEST(CudaExecutor, KeepsTheTerrainOnTheDeviceBetweenSteps) {
  World world = small_world();
  world.model = "werner";
  const auto card = std::make_shared<Card>();
  const auto executor = emulated_executor(two_sweeps, card);
  Terrain terrain = world.strewn();
  const std::uint64_t before = state_hash(terrain);
  const auto made = find_model(world.model).make(world.values());
  made->step(terrain, world.wind, {world.seed, 0}, *executor);
  const long long copies = card->of_kind["copy"];
  const long long allocated = card->of_kind["allocate"];
  for (std::uint64_t step = 1; step <= 5; ++step) made->step(terrain, world.wind, {world.seed, step}, *executor);
  EXPECT_EQ(card->of_kind["copy"], copies + 5) << "one copy a step: the counts";
  EXPECT_EQ(card->of_kind["allocate"], allocated);
  EXPECT_EQ(state_hash(terrain), before) << "stale until it is asked for";
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->of_kind["copy"], copies + 7) << "which bands have changed, and the one band that this terrain has";
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->of_kind["copy"], copies + 7) << "nothing was done since";
  EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
}

TEST(CudaExecutor, BringsBackOnlyBandsThatHaveChanged) {
  World world{.extent = {256, 64}};  // four bands of 16 rows
  const auto card = std::make_shared<Card>();
  const auto executor = emulated_executor(two_sweeps, card);
  Terrain terrain(world.extent, 1, world.quantum());
  for (int x = 0; x < 20; ++x) terrain.edit_mobile()(100 + x, 40) = 5;  // in the third
  terrain.open_ledger();
  Terrain beside = terrain;
  const auto made = find_model(world.model).make(world.values());
  made->step(terrain, world.wind, {world.seed, 0}, *executor);
  const std::size_t bytes = card->bytes_out;
  executor->sync_to_host(terrain);
  EXPECT_EQ(card->bytes_out - bytes, 4u * 4 + 256 * 16 * 4);
  world.run(beside, two_sweeps, 1);
  EXPECT_EQ(state_hash(terrain), state_hash(beside));
}

TEST(CudaExecutor, LoadsAnewWhatWasEdited) {
  const World world{.extent = {20, 20}};
  const auto cuda = emulated_executor(two_sweeps, std::make_shared<Card>());
  Executor cpu(two_sweeps);
  std::vector<std::uint64_t> hashes;
  for (Executor* executor : {cuda.get(), &cpu}) {
    Terrain terrain = world.strewn();
    world.run(terrain, *executor, 2);
    terrain.edit_mobile()(5, 5) += 30;
    world.run(terrain, *executor, 2, 2);
    hashes.push_back(state_hash(terrain));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(CudaExecutor, TakesALargerTerrainWithCoverAfterASmallerOne) {
  const auto card = std::make_shared<Card>();
  const auto cuda = emulated_executor(two_sweeps, card);
  Executor cpu(two_sweeps);
  std::list<Terrain> terrains;  // all alive, or one may come to lie where another was
  for (const Extent extent : {Extent{12, 9}, Extent{31, 20}}) {
    const Cover cover{CoverField(extent, 100)};
    std::vector<std::uint64_t> hashes;
    for (Executor* executor : {cuda.get(), &cpu}) {
      Terrain& terrain = terrains.emplace_back(World{.extent = extent}.strewn());
      SlabLaw law;
      law.cover = &cover;
      move_slabs(*executor, terrain, law, {270, 3}, {1, 0});
      executor->sync_to_host(terrain);
      hashes.push_back(state_hash(terrain));
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    const auto bytes = [](const auto& block) { return block.second; };
    // Two planes of ground, bed, the surface as shown and one on its way: a word for each cell.
    EXPECT_EQ(std::ranges::count(card->device_blocks, extent.cells() * 4, bytes), 5);
  }
}

TEST(CudaExecutor, CopiesTerrainsThatTakeSeveralPieces) {
  const auto card = std::make_shared<Card>();
  const auto device = emulated_backend(card);
  const std::size_t bytes = 2 * cuda::CudaBackend::piece_bytes + 12;
  compute::Buffer<std::byte> memory(*device, bytes);
  const auto value = [](std::size_t k) { return static_cast<std::byte>(mix64(k) & 0xff); };
  device->copy_in(memory.data(), bytes, [&](std::byte* target, std::size_t first, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) target[k] = value(first + k);
  });
  std::size_t read = 0;
  bool same = true;
  device->copy_out(memory.data(), bytes, [&](const std::byte* source, std::size_t first, std::size_t count) {
    EXPECT_EQ(first, read);
    for (std::size_t k = 0; k < count; ++k) same = same && source[k] == value(first + k);
    read += count;
  });
  EXPECT_TRUE(same);
  EXPECT_EQ(read, bytes);
}

}  // namespace
}  // namespace erg::test
