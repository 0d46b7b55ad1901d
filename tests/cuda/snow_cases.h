// Runs of sintering snow that the CUDA executor has to do exactly as `cpu` does, each with something of its own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases.h"

namespace erg::test {

inline std::vector<Case> snow_cases() {
  // Metres of snow, loose and bonded, in a wind that lifts both and carries some of it off; hops of some cells.
  const auto drifting = [](Extent extent, double bearing) {
    World world{.model = "snow_sintering", .extent = extent, .wind = {bearing, 14}, .sand = 40};
    world.settings = {{"start_age", 30.0},    {"snowfall", 5.0},      {"suspension_wind", 10.0}, {"hop_factor", 60.0},
                      {"smooth_radius", 2.0}, {"around_radius", 5.0}, {"time_step", 900.0},      {"bonding_time", 4.0}};
    return world;
  };
  const auto with = [](World world, const char* key, ParameterValue value) {
    std::erase_if(world.settings, [&](const auto& setting) { return setting.first == key; });
    world.settings.emplace_back(key, value);
    return world;
  };
  const auto open = [](World world) {
    world.boundary = Boundary::open;
    world.inflow = 0.7;
    return world;
  };
  const auto crowded = [](World world) {  // thousands of slabs come down in one cell at the same time
    world.inflow = 40000;
    return world;
  };
  const auto pattern = [&](World world, const char* name) {
    return with(std::move(world), "strength", std::string(name));
  };
  // The fewer slabs lift, the longer a step has to be.
  const auto longer = [&](World world, double seconds) { return with(std::move(world), "time_step", seconds); };
  const auto hopping = [&](World world, double factor) {
    return longer(with(std::move(world), "hop_factor", factor), 10000.0);
  };
  const auto tall = [&](World world, double slab) {
    return longer(with(std::move(world), "slab_height", slab), 80000.0);
  };
  // A gale every other step.
  const auto scene = [](const char* name, World world, std::int32_t rocks = 0, int steps = 4, int sweeps = 8,
                        std::vector<double> bearings = {}) {
    if (bearings.empty()) bearings = {world.wind.bearing};
    Case made{name, std::move(world), rocks, steps, sweeps};
    for (int step = 0; step < steps; ++step) {
      const double bearing = bearings[static_cast<std::size_t>(step) % bearings.size()];
      made.winds.push_back({bearing, step % 2 == 0 ? 14.0 : 19.0});
    }
    return made;
  };
  return {
      scene("straight", drifting({70, 45}, 270), 0, 18),  // long enough to show its strength
      scene("from the north, rocks", drifting({45, 70}, 0), 90),
      scene("oblique", drifting({70, 101}, 237)),
      scene("oblique, rocks, layers", pattern(drifting({67, 41}, 250), "layers"), 60),
      scene("diagonal, both, K 16", pattern(drifting({50, 50}, 135), "both"), 0, 3, 16),
      scene("even, K 2", pattern(drifting({37, 66}, 180), "even"), 300, 4, 2),
      scene("open", open(drifting({64, 40}, 90))),
      scene("open, oblique, rocks", open(drifting({41, 67}, 20)), 60),
      scene("open, oblique, wide, K 4", open(drifting({90, 33}, 310)), 0, 4, 4),
      scene("open, crowds, K 2", crowded(open(with(drifting({5, 12}, 270), "hop_factor", 20.0))), 0, 1, 2),
      scene("no rocks in the way", with(drifting({40, 40}, 200), "obstacles", false), 200),
      scene("no snowfall, no drift off", with(with(drifting({48, 33}, 300), "snowfall", 0.0), "suspension", 0.0)),
      scene("steep", with(tall(drifting({33, 31}, 260), 0.6), "repose_angle", 20.0), 0, 3),
      scene("hops longer than the grid", hopping(drifting({16, 13}, 225), 600.0)),
      scene("the same along the axis", hopping(drifting({9, 14}, 270), 900.0)),
      scene("the same, open", open(hopping(drifting({9, 14}, 290), 900.0))),
      scene("one row", drifting({40, 1}, 230)),
      scene("one column", drifting({1, 40}, 270)),
      scene("one column, open", open(drifting({1, 40}, 190))),
      scene("two by three", drifting({2, 3}, 200)),
      scene("one cell", drifting({1, 1}, 250)),
      scene("turning wind", drifting({31, 44}, 270), 50, 5, 8, {270, 250, 180, 20, 95}),
      scene("long shadows", with(tall(drifting({130, 9}, 255), 0.1), "shadow_angle", 7.0), 150, 3),
      scene("long shadows, open", open(with(tall(drifting({9, 130}, 10), 0.1), "shadow_angle", 7.0)), 150, 3),
  };
}

}  // namespace erg::test
