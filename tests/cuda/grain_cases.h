// Runs of grains that the CUDA executor has to do exactly as `cpu` does, each with something of its own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases.h"

namespace erg::test {

inline std::vector<Case> grain_cases() {
  const std::vector<std::pair<std::string, ParameterValue>> snow{
      {"bonding_time", 3.0}, {"settling", 0.02}, {"abrasion", 0.3}, {"grain_density", 917.0}};
  const std::vector<std::pair<std::string, ParameterValue>> plants{{"plants", std::int64_t{4}}, {"plant_height", 0.05}};
  const auto scene = [](const char* name, World world, std::int32_t rocks = 0, int steps = 2) {
    world.model = "grains";
    return Case{name, std::move(world), rocks, steps};
  };
  return {
      scene("straight", {.extent = {50, 37}, .sand = 20}, 0, 3),
      scene("oblique, rocks", {.extent = {37, 50}, .wind = {237, 6}, .sand = 20}, 300),
      scene("from the north, open",
            {.extent = {41, 33}, .boundary = Boundary::open, .inflow = 3, .wind = {10, 6}, .sand = 20}),
      scene("oblique, open, rocks",
            {.extent = {33, 70}, .boundary = Boundary::open, .inflow = 2, .wind = {130, 5}, .sand = 10}, 600),
      scene("plants", {.extent = {40, 45}, .wind = {20, 5}, .settings = plants, .sand = 20}),
      scene("snow", {.extent = {35, 34}, .wind = {200, 6}, .settings = snow, .sand = 8}, 0, 4),
      scene("sizes, one poll", {.extent = {31, 40},
                                .wind = {250, 5},
                                .settings = {{"diameter_spread", 0.4}, {"sub_steps", std::int64_t{1}}},
                                .sand = 20}),
      scene("steep", {.extent = {30, 33}, .wind = {300, 1}, .sand = 400}),
      scene("cut off", {.extent = {24, 24}, .settings = {{"longest_flight", 0.1}}, .sand = 20}),
      scene("one row", {.extent = {40, 1}, .wind = {230, 5}, .sand = 20}),
      scene("one column", {.extent = {1, 40}, .wind = {270, 5}, .sand = 20}),
      scene("two by three", {.extent = {2, 3}, .wind = {200, 5}, .sand = 20}),
  };
}

}  // namespace erg::test
