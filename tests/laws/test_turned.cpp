// A turned wind on a turned scene is the turned run, a mirrored one the mirrored run. Executors work in the wind's
// frame, so quarter turns of a square grid agree to the bit, not only up to noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "world.h"

namespace erg::test {

using compute::ExecutorOptions;
using models::catalogue;
using models::ModelType;

namespace {

using Map = std::function<std::pair<int, int>(int x, int y, int side)>;

Terrain moved(const Terrain& terrain, const Map& map) {
  Terrain copy = terrain;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      const auto [to_x, to_y] = map(x, y, terrain.nx());
      copy.edit_bedrock()(to_x, to_y) = terrain.bedrock()(x, y);
      copy.edit_mobile()(to_x, to_y) = terrain.mobile()(x, y);
      for (std::size_t k = 0; k < terrain.fields().size(); ++k) {
        copy.edit_fields()[k].values(to_x, to_y) = terrain.fields()[k].values(x, y);
      }
    }
  }
  return copy;
}

struct Motion {
  std::string name;
  Map map;
  std::function<double(double)> bearing;  // of the wind after the motion
};

std::vector<Motion> motions() {
  return {{"quarter turn clockwise", [](int x, int y, int side) { return std::pair(y, side - 1 - x); },
           [](double bearing) { return bearing + 90; }},
          {"half turn", [](int x, int y, int side) { return std::pair(side - 1 - x, side - 1 - y); },
           [](double bearing) { return bearing + 180; }},
          {"mirrored east-west", [](int x, int y, int side) { return std::pair(side - 1 - x, y); },
           [](double bearing) { return -bearing; }},
          {"mirrored at the diagonal", [](int x, int y, int) { return std::pair(y, x); },
           [](double bearing) { return 90 - bearing; }}};
}

TEST(TurnedScenes, GiveTurnedRuns) {
  for (const ModelType& model : catalogue()) {
    for (const Machine& machine : machines()) {
      for (const Motion& motion : motions()) {
        for (const double bearing : {250.0, 290.0, 340.0}) {
          // Noise in the ground would not turn with it.
          World world{.model = model.info.key,
                      .extent = {48, 48},
                      .wind = {bearing, 5},
                      .settings = {{"strength", std::string("even")}}};
          Terrain terrain = world.strewn();
          raise_rocks(terrain, 12);
          Terrain turned = moved(terrain, motion.map);
          const int steps = world.moves_slabs() ? 8 : 2;
          world.run(terrain, machine.options, steps);
          world.wind.bearing = motion.bearing(bearing);
          world.run(turned, machine.options, steps);
          EXPECT_EQ(state_hash(turned), state_hash(moved(terrain, motion.map)))
              << model.info.key << ", " << machine.name << ", " << motion.name << ", from " << bearing;
        }
      }
    }
  }
}

TEST(TurnedScenes, GiveTurnedRunsWhereThePlanesAreSkewed) {
  for (const Motion& motion : motions()) {
    World world{.extent = {290, 290}, .wind = {250, 5}, .settings = {{"neighbours", std::string("8")}}};
    Terrain terrain = world.strewn();
    raise_rocks(terrain, 12);
    Terrain turned = moved(terrain, motion.map);
    const ExecutorOptions options{.name = "cpu", .threads = 2, .lines_a_thread = 1};
    world.run(terrain, options, 4);
    world.wind.bearing = motion.bearing(world.wind.bearing);
    world.run(turned, options, 4);
    EXPECT_EQ(state_hash(turned), state_hash(moved(terrain, motion.map))) << motion.name;
  }
}

/// Swings turn with the wind. (They are no mirror images of each other, so a mirrored wind swings in its own way.)
TEST(TurnedScenes, GiveTurnedRunsWhereTheWindSwings) {
  for (const Machine& machine : machines()) {
    for (const Motion& motion : motions()) {
      if (motion.name.starts_with("mirrored")) continue;
      for (const double bearing : {270.0, 310.0}) {
        World world{.model = "momiji", .extent = {48, 48}, .wind = {bearing, 5}, .spread = 12.3};
        Terrain terrain = world.strewn();
        Terrain turned = moved(terrain, motion.map);
        world.run(terrain, machine.options, 8);
        world.wind.bearing = motion.bearing(bearing);
        world.run(turned, machine.options, 8);
        EXPECT_EQ(state_hash(turned), state_hash(moved(terrain, motion.map)))
            << machine.name << ", " << motion.name << ", from " << bearing;
      }
    }
  }
}

/// A grid of one column, mirrored at the diagonal, is one of one row.
TEST(TurnedScenes, GiveTurnedRunsInOneColumn) {
  for (const ModelType& model : catalogue()) {
    for (const double bearing : {270.0, 250.0, 190.0, 0.0}) {
      World row{.model = model.info.key,
                .extent = {40, 1},
                .wind = {bearing, 5},
                .settings = {{"strength", std::string("even")}},
                .sand = 20};
      if (model.info.key == "snow_sintering") row.settings.emplace_back("time_step", 900.0);  // or little lifts
      World column = row;
      column.extent = {1, 40};
      column.wind.bearing = 90 - bearing;
      Terrain lying = row.strewn();  // keyed by the cell's number, which is the same in both
      Terrain standing = column.strewn();
      const ExecutorOptions options{.name = "cpu", .threads = 2};
      row.run(lying, options, 4);
      column.run(standing, options, 4);
      EXPECT_TRUE(std::ranges::equal(lying.mobile().cells(), standing.mobile().cells()))
          << model.info.key << ", from " << bearing;
    }
  }
}

}  // namespace
}  // namespace erg::test
