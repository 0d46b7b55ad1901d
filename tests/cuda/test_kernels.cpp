// The CUDA executor's kernels, run on the processor, give the same bits as the executor `cpu`: terrain, counts, ledger.
#include <gtest/gtest.h>

#include "on_cards.h"

namespace erg::test {

using compute::Executor;

namespace {

TEST(CudaKernels, GiveTheSameBitsAsThreads) { expect_same_on_cards(slab_cases()); }

TEST(CudaKernels, GiveTheSameBitsAsPlainLoops) { expect_same_as_loops(slab_cases()); }

/// Plants of every density, from none to closed, under which steeper slopes stand.
TEST(CudaKernels, GiveTheSameBitsUnderCover) {
  for (const double bearing : {270.0, 20.0}) {
    const World world{.model = "momiji", .extent = {61, 50}, .wind = {bearing, 4}, .sand = 6};
    models::Cover cover{models::CoverField(world.extent)};
    for (std::size_t cell = 0; cell < cover->size(); ++cell) {
      cover.edit()[cell] = static_cast<std::uint8_t>(cell % 7 == 0 ? 255 : mix64(cell) % 200);
    }
    const auto made = models::find_model(world.model).make(world.values());
    const auto run = [&](Executor& executor, Terrain& terrain) {
      raise_rocks(terrain, 4);
      models::SlabLaw law = dynamic_cast<const models::SlabModel&>(*made).law(terrain);
      law.neighbours = 8;
      law.bare = {1, 2};
      law.covered = {3, 5};
      law.cover = &cover;
      for (std::uint64_t step = 0; step < 6; ++step) {
        if (step == 3) cover.edit();  // executors load it anew, though nothing has changed
        models::move_slabs(executor, terrain, law, world.wind, {world.seed, step});
      }
      executor.sync_to_host(terrain);
      return state_hash(terrain);
    };
    const compute::ExecutorOptions options{.name = "cpu", .threads = 1, .sweeps = 8};
    Executor cpu(options);
    const auto cuda = emulated_executor(options, std::make_shared<Card>());
    Terrain terrain = world.strewn();
    Terrain emulated = terrain;
    const std::uint64_t start = state_hash(terrain);
    const std::uint64_t hash = run(cpu, terrain);
    EXPECT_NE(hash, start);
    EXPECT_EQ(run(*cuda, emulated), hash) << bearing;
    EXPECT_EQ(cuda->name(), "cuda");
  }
}

}  // namespace
}  // namespace erg::test
