#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <tuple>

#include "io/config/config_file.h"

namespace erg {

using io::read_config;
using sim::Config;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> presets() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ERG_SOURCE_DIR) / "cfg")) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  return paths;
}

Config thesis(const std::string& name) {
  return read_config(fs::path(ERG_SOURCE_DIR) / "cfg/thesis" / (name + ".json"));
}

TEST(Presets, AllLoadAndSayWhatTheyShow) {
  ASSERT_GE(presets().size(), 25u);
  std::set<std::string> titles;
  for (const fs::path& path : presets()) {
    SCOPED_TRACE(path.string());
    const Config config = read_config(path);
    EXPECT_FALSE(config.title.empty());
    EXPECT_TRUE(config.description.ends_with('.')) << "a sentence";
    EXPECT_TRUE(titles.insert(config.title).second) << "two presets have this title";
    EXPECT_EQ(io::parse_config(io::config_text(config), "saved"), config);
  }
}

TEST(Presets, TheDefaultIsABarchanField) {
  const Config config = read_config(fs::path(ERG_SOURCE_DIR) / "cfg/barchans.json");
  EXPECT_EQ(config.model, "momiji");
  EXPECT_EQ(config.grid.integer("nx"), 512);
  EXPECT_EQ(config.grid.integer("ny"), 512);
  EXPECT_EQ(config.scene.real("sand"), 3);
}

struct PublishedRun {
  const char* name;
  const char* model;
  int side;
  double sand;
  double strength;
  double repose;
  int steps;
  std::vector<double> bearings;
  int season;
};

// Cimbura 2022, tables 6.1 to 6.3 and the text beside them.
TEST(Presets, PublishedRunsHaveThePrintedSettings) {
  const std::vector<double> all_sides{270, 0, 90, 180};
  const std::vector<PublishedRun> runs{
      {"werner_barchans", "werner", 256, 3, 5, 30, 1000, {270}, 1},
      {"werner_transverse", "werner", 256, 10, 5, 30, 1000, {270}, 1},
      {"werner_star", "werner", 256, 10, 5, 30, 640, all_sides, 80},
      {"werner_linear", "werner", 256, 10, 5, 30, 1000, {270, 90}, 100},
      {"momiji_barchans", "momiji", 256, 3, 5, 33.7, 1000, {270}, 1},
      {"momiji_transverse", "momiji", 256, 10, 5, 33.7, 10000, {270}, 1},
      {"momiji_star", "momiji", 256, 10, 5, 33.7, 320, all_sides, 40},
      {"momiji_barchans_1024", "momiji", 1024, 3, 5, 33.7, 1000, {270}, 1},
      {"bishop_barchans", "bishop", 256, 3, 3, 33.7, 1500, {270}, 1},
      {"bishop_repose_30", "bishop", 256, 3, 3, 30, 500, {270}, 1},
      {"bishop_repose_33_7", "bishop", 256, 3, 3, 33.7, 500, {270}, 1},
      {"bishop_barchans_700", "bishop", 256, 3, 3, 33.7, 700, {270}, 1},
      {"momiji_slow_wind", "momiji", 256, 3, 2, 33.7, 1000, {270}, 1},
      {"momiji_star_slow", "momiji", 256, 10, 1, 33.7, 1600, all_sides, 40},
  };
  for (const PublishedRun& run : runs) {
    SCOPED_TRACE(run.name);
    const Config config = thesis(run.name);
    EXPECT_EQ(config.model, run.model);
    EXPECT_EQ(config.grid.integer("nx"), run.side);
    EXPECT_EQ(config.grid.integer("ny"), run.side);
    EXPECT_EQ(config.grid.real("cell_size"), 1.0);
    EXPECT_EQ(config.grid.text("boundary"), "torus");
    EXPECT_EQ(config.scene.text("kind"), "flat");
    EXPECT_EQ(config.scene.real("sand"), run.sand);
    EXPECT_EQ(config.parameters.real("slab_height"), 1.0 / 3);
    EXPECT_EQ(config.parameters.real("repose_angle"), run.repose);
    EXPECT_EQ(config.parameters.real("shadow_angle"), 15);
    EXPECT_EQ(config.parameters.real("p_sand"), 0.6);
    EXPECT_EQ(config.parameters.real("p_bare"), 0.4);
    EXPECT_EQ(config.parameters.text("polling"), "repeated");
    EXPECT_FALSE(config.parameters.boolean("forced_erosion"));
    if (config.parameters.find("linear") != nullptr) {
      EXPECT_EQ(config.parameters.real("linear"), 0.4);
      EXPECT_EQ(config.parameters.real("quadratic"), 0.002);
    }
    EXPECT_EQ(config.run.integer("steps"), run.steps);
    ASSERT_EQ(config.wind.intervals.size(), run.bearings.size());
    for (std::size_t i = 0; i < run.bearings.size(); ++i) {
      EXPECT_EQ(config.wind.intervals[i],
                (forcing::WindInterval{run.bearings[i], run.strength, run.strength, run.season, {}}));
    }
  }
}

TEST(Presets, SzaboHasThreeWindsAndFourGrounds) {
  const auto szabo = [](const std::string& name) {
    return read_config(fs::path(ERG_SOURCE_DIR) / "cfg/szabo2019" / (name + ".json"));
  };
  for (const auto& [name, kind, wind] : {std::tuple{"ripples_10", "flat", 10},
                                         {"ripples_12", "flat", 12},
                                         {"ripples_15", "flat", 15},
                                         {"hump", "hump", 10},
                                         {"dune", "dune", 10},
                                         {"valley", "valley", 10}}) {
    SCOPED_TRACE(name);
    const Config config = szabo(name);
    EXPECT_EQ(config.model, "grains");
    EXPECT_EQ(config.grid.integer("nx"), 256);
    EXPECT_EQ(config.grid.integer("ny"), 256);
    EXPECT_EQ(config.scene.text("kind"), kind);
    EXPECT_EQ(config.scene.real("sand"), 500);
    EXPECT_EQ(config.wind, forcing::WindSchedule::constant(270, wind));
  }
}

TEST(Presets, SnowThatThawsFollowsThePrintedRamp) {
  const Config config = thesis("snow_thaw");
  EXPECT_EQ(config.model, "snow_packing");
  EXPECT_EQ(config.wind.intervals.at(0).bearing, 270);
  EXPECT_LT(config.wind.intervals[0].first, config.wind.intervals[0].last);
}

TEST(Presets, ForcedWernerRunHasItsOwnProbabilities) {
  const Config config = thesis("werner_barchans_forced");
  EXPECT_EQ(config.parameters.real("p_sand"), 0.4);
  EXPECT_EQ(config.parameters.real("p_bare"), 0.9);
  EXPECT_TRUE(config.parameters.boolean("forced_erosion"));
  EXPECT_EQ(config.run.integer("steps"), 500);
}

TEST(Presets, RocksStopSandAndInOneRunDoNot) {
  EXPECT_EQ(thesis("momiji_rocks").scene.text("kind"), "rocks");
  EXPECT_TRUE(thesis("momiji_rocks").parameters.boolean("obstacles"));
  EXPECT_FALSE(thesis("momiji_rocks_crossed").parameters.boolean("obstacles"));
}

}  // namespace
}  // namespace erg
