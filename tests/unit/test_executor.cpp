#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "compute/executor.h"
#include "compute/work_queue.h"
#include "sim/make_executor.h"
#include "sim/simulation.h"

namespace erg {

using compute::WorkQueue;
using sim::FluxWatch;
using sim::make_executor;
using sim::Simulation;

namespace {

TEST(Executor, PiecesCoverEachItemOnceOnAnyNumberOfThreads) {
  for (const char* name : {"serial", "cpu"}) {
    for (const int threads : {1, 2, 3, 8}) {
      const auto executor = make_executor({.name = name, .threads = threads});
      for (const int items : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(items));
        executor->parallel_for(items, [&](std::int64_t begin, std::int64_t end) {
          for (std::int64_t k = begin; k < end; ++k) ++visits[static_cast<std::size_t>(k)];
        });
        for (const auto& count : visits) EXPECT_EQ(count, 1) << name << ", " << threads << " threads";
      }
    }
  }
}

TEST(Executor, WorkQueueIsDoneOnceWhoeverTakesIt) {
  for (const int threads : {1, 2, 3, 8}) {
    const auto executor = make_executor({.name = "cpu", .threads = threads});
    for (const int items : {0, 1, 7, 5000}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(items));
      const auto visit = [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k) ++visits[static_cast<std::size_t>(k)];
      };
      WorkQueue work(items, threads);
      executor->parallel_for(threads, [&](std::int64_t first, std::int64_t last) {
        for (auto member = static_cast<int>(first); member < last; ++member) work.take_chunks(member, visit);
      });
      for (const auto& count : visits) EXPECT_EQ(count, 1) << items << " items, " << threads << " threads";
    }
  }
  // One member alone does the others' shares too.
  int done = 0;
  WorkQueue alone(100, 4);
  alone.take_chunks(2, [&done](std::int64_t begin, std::int64_t end) { done += static_cast<int>(end - begin); });
  EXPECT_EQ(done, 100);
}

TEST(Flux, IsTheMeanOfTwentyStepsOrOfThoseThereAre) {
  FluxWatch watch({2, 1});
  EXPECT_EQ(watch.mean().values[0], 0);
  for (int step = 1; step <= 4; ++step) {
    watch.counts()[0] += 3;
    watch.stepped();
  }
  EXPECT_EQ(watch.mean().values[0], 3);
  watch.counts()[1] += 40;
  for (int step = 5; step <= FluxWatch::steps_of_mean; ++step) watch.stepped();
  EXPECT_FLOAT_EQ(watch.mean().values[0], 0.6f);
  EXPECT_EQ(watch.mean().values[1], 2);
  watch.counts()[0] += 100;
  watch.stepped();
  EXPECT_FLOAT_EQ(watch.mean().values[0], 0.6f) << "until twenty more are done";
}

TEST(Flux, OfARunIsWhatItsStepsLifted) {
  for (const std::string model : {"momiji", "snow_sintering", "grains"}) {
    sim::Config config(model);
    config.grid.set("nx", std::int64_t{32});
    config.grid.set("ny", std::int64_t{24});
    if (model == "grains") config.grid.set("cell_size", 0.01);
    if (model != "momiji") sim::set_from_text(config, "wind.strength=14");
    Simulation plain(config);
    Simulation watched(config);
    watched.watch_flux(true);
    std::int64_t lifts = 0;
    for (int step = 0; step < 3; ++step) {
      plain.step();
      lifts += watched.step().lifts;
    }
    double sum = 0;
    const Field mean = watched.flux()->mean();
    for (const float value : mean.values.cells()) sum += value;
    EXPECT_GT(lifts, 0) << model;
    EXPECT_NEAR(3 * sum, static_cast<double>(lifts), 1e-3 * static_cast<double>(lifts)) << model;
    EXPECT_EQ(state_hash(watched.terrain()), state_hash(plain.terrain())) << model;
    EXPECT_EQ(plain.flux(), nullptr);
  }
}

}  // namespace
}  // namespace erg
