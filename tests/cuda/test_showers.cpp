// The model of docs/add-a-model.md that brings a kernel: the same ground on every executor, and on a device that fails.
#include <gtest/gtest.h>

#include "on_cards.h"
#include "showers.h"
#include "stories.h"

namespace erg::test {

using compute::Executor;

namespace {

/// In the catalogue while a test runs it; one test program never forgets a model.
void add_showers() {
  static const bool added = [] {
    models::add_model(showers());
    return true;
  }();
  static_cast<void>(added);
}

World rainy(double chance = 0.5) {
  add_showers();
  return {.model = "showers",
          .extent = {40, 33},
          .wind = {250, 4},
          .settings = {{"shower_chance", chance}, {"shower_radius", 9.0}, {"drying_steps", 6.0}}};
}

TEST(Showers, WetTheSameGroundOnEveryExecutor) {
  const World world = rainy();
  const auto moisture = [&](Executor& executor) {
    Terrain terrain = world.strewn();
    world.run(terrain, executor, 5);
    return terrain.fields().front().values;
  };
  Executor serial({.name = "serial"});
  const Grid<float> wet = moisture(serial);
  EXPECT_GT(std::ranges::max(wet.cells()), 0) << "or there is nothing to compare";
  EXPECT_EQ(std::ranges::min(wet.cells()), 0) << "showers do not wet all of the ground";
  Executor threads({.name = "cpu", .threads = 3});
  EXPECT_TRUE(moisture(threads) == wet);
  EXPECT_TRUE(moisture(*emulated_executor({.name = "cuda", .threads = 1}, std::make_shared<Card>())) == wet);
}

TEST(Showers, MoveTheSameSlabsOnADevice) {
  const Case scene{"showers", rainy(), 0, 5};
  expect_same_on_cards({scene});
  expect_same_as_loops({scene});
}

TEST(Showers, HoldSandThatWouldBlowOtherwise) {
  const auto lifts = [](const World& world) {
    Terrain terrain = world.strewn();
    return world.run(terrain, {.name = "cpu", .threads = 1}, 10).lifts;
  };
  EXPECT_LT(lifts(rainy(1)), 0.9 * static_cast<double>(lifts(rainy(0))));
}

TEST(Showers, GoOnWhicheverCallFails) {
  const Story story = [](Executor& executor) {
    const World world = rainy(1);
    StoryEnd end;
    Terrain terrain = world.strewn();
    const auto model = models::find_model(world.model).make(world.values());
    model->begin(terrain);
    for (std::uint64_t step = 0; step < 3; ++step) {
      model->step(terrain, world.wind, {world.seed, step}, executor);
      end.hear(executor);
    }
    end.close(executor, terrain);
    return end;
  };
  expect_same_whichever_call_fails(story, 50, 5);
}

}  // namespace
}  // namespace erg::test
