// On a machine with a graphics card: the same bits as `cpu`. Skipped, with the reason, on others.
#include <gtest/gtest.h>

#include "cases.h"
#include "cuda/cuda_backend.h"
#include "grain_cases.h"
#include "sim/cuda_entries.h"
#include "snow_cases.h"

namespace erg::test {

using cuda::cuda_api;
using cuda::make_cuda_executor;

namespace {

/// Skipped where no device works. One that fails later, in a test, fails it: the executor then is no longer "cuda".
class CudaDevice : public testing::Test {
 protected:
  void SetUp() override {
    const auto executor = make_cuda_executor({.name = "cuda", .threads = 1}, cuda_api(), sim::cuda_entry);
    if (executor->name() != "cuda") GTEST_SKIP() << executor->take_notice();
  }
};

TEST_F(CudaDevice, GivesTheSameBitsAsThreads) {
  for (const Case& scene : slab_cases()) {
    const auto executor = make_cuda_executor(scene.options(), cuda_api(), sim::cuda_entry);
    expect_same_as_threads(scene, *executor);
  }
}

TEST_F(CudaDevice, GivesTheSameBitsOnDevelopedDunes) {
  for (const models::ModelType& model : models::catalogue()) {
    if (!World{.model = model.info.key}.moves_slabs()) continue;
    for (const double bearing : {270.0, 240.0, 225.0}) {
      const Case scene{model.info.key, {.model = model.info.key, .extent = {700, 520}, .wind = {bearing, 5}}, 0, 60};
      const auto executor = make_cuda_executor(scene.options(), cuda_api(), sim::cuda_entry);
      expect_same_as_threads(scene, *executor);
    }
  }
}

TEST_F(CudaDevice, GivesTheSameBitsForGrains) {
  std::vector<Case> scenes = grain_cases();
  scenes.push_back({"large", {.model = "grains", .extent = {517, 390}, .wind = {240, 7}, .sand = 40}, 1000, 8});
  for (const Case& scene : scenes) {
    const auto executor = make_cuda_executor(scene.options(), cuda_api(), sim::cuda_entry);
    expect_same_as_threads(scene, *executor);
  }
}

TEST_F(CudaDevice, GivesTheSameBitsForSnow) {
  std::vector<Case> scenes = snow_cases();
  for (const double bearing : {270.0, 240.0}) {
    Case large = scenes.front();
    large.name = "large, bearing " + std::to_string(bearing);
    large.world.extent = {700, 520};
    for (forcing::Forcing& wind : large.winds) wind.bearing = bearing;
    large.rocks = 60;
    large.steps = 40;
    scenes.push_back(large);
  }
  for (const Case& scene : scenes) {
    const auto executor = make_cuda_executor(scene.options(), cuda_api(), sim::cuda_entry);
    expect_same_as_threads(scene, *executor);
  }
}

}  // namespace
}  // namespace erg::test
