// `erg run` as a person uses it: numbers, hashes, files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include "program.h"

namespace erg::test {
namespace {

constexpr int cells = 48 * 32;

TEST(Run, StatisticsHoldEveryKeyWithItsMeaning) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(40));
  const Ended ended = run_erg(folder, {"run", config, "--stats", "stats.json", "--threads", "2", "--executor", "cpu"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const nlohmann::json stats = read_json(folder.file("stats.json"));

  EXPECT_EQ(stats.at("model"), "momiji");
  EXPECT_EQ(stats.at("steps"), 40);
  EXPECT_EQ(stats.at("seed"), 7);
  EXPECT_EQ(stats.at("executor"), "cpu");
  EXPECT_EQ(stats.at("threads"), 2);
  // Three slabs a cell on a torus: none is lost.
  EXPECT_EQ(stats.at("mass_start"), 3 * cells);
  EXPECT_EQ(stats.at("mass_now"), 3 * cells);
  EXPECT_EQ(stats.at("mass_in"), 0);
  EXPECT_EQ(stats.at("mass_out"), 0);
  EXPECT_DOUBLE_EQ(stats.at("mean_slabs"), 3.0);
  EXPECT_GT(stats.at("max_slabs"), 3);
  EXPECT_GT(stats.at("sd_slabs"), 0.5);
  for (const char* share : {"bare_fraction", "shadow_fraction"}) {
    EXPECT_GT(stats.at(share), 0) << share;
    EXPECT_LT(stats.at(share), 1) << share;
  }
  // A step polls as many cells as the grid has, give or take the chance of repeated polling, and not every poll lifts.
  EXPECT_NEAR(stats.at("polls").get<double>(), 40.0 * cells, 0.05 * 40 * cells);
  EXPECT_GT(stats.at("lifts"), 0);
  EXPECT_LE(stats.at("lifts"), stats.at("polls"));
  // A slab flies some hops of about five cells; at most every poll of every step lifts one.
  const double travel = stats.at("flux").get<double>() * cells * 40 / stats.at("lifts").get<double>();
  EXPECT_GT(travel, 4);
  EXPECT_LT(travel, 20);
  EXPECT_GT(stats.at("migration_x"), 0);
  EXPECT_GE(stats.at("wavelength"), 2);
  EXPECT_LE(stats.at("wavelength"), 48);
  EXPECT_GT(stats.at("crest_spacing"), 2);
  EXPECT_LT(stats.at("crest_spacing"), 96);
  EXPECT_GE(stats.at("alignment"), 0);
  EXPECT_LE(stats.at("alignment"), 1);
  EXPECT_EQ(stats.at("crest_bearing").is_null(), stats.at("alignment") < 0.4) << "no bearing without alignment";
  // Five cells a hop over .6, slabs of a third of a metre, and 50 m2 a year.
  EXPECT_NEAR(stats.at("days_a_step").get<double>(), 5 / 0.6 / 3 / 50 * 365.25, 1e-6);
  EXPECT_NEAR(stats.at("days").get<double>(), 40 * stats.at("days_a_step").get<double>(), 1e-6);
  EXPECT_TRUE(std::isfinite(stats.at("migration_y").get<double>()));
  EXPECT_EQ(stats.at("state_hash").get<std::string>().size(), 16u);
  EXPECT_NEAR(stats.at("polls_per_second").get<double>() * stats.at("seconds").get<double>(),
              stats.at("polls").get<double>(), 1.0);
}

TEST(Run, StatisticsSayWhatTheyAreMeasuredInAndOfWhatRun) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(10));
  ASSERT_EQ(run_erg(folder, {"run", config, "--set", "wind.bearing=300", "--stats", "a.json", "--quiet"}).exit_code, 0);
  const nlohmann::json stats = read_json(folder.file("a.json"));
  const nlohmann::json& units = stats.at("units");
  for (const auto& [key, value] : stats.items()) {
    if (!value.is_number() || key == "seed") continue;
    EXPECT_TRUE(units.contains(key)) << key << " has no unit";
  }
  EXPECT_EQ(units.at("flux"), "slabs/step");
  EXPECT_EQ(units.at("crest_bearing"), "deg") << "whether there is one or not";
  EXPECT_EQ(stats.at("config").at("wind").at("bearing"), 300);
  // The config, taken out, is the run.
  folder.write("again.json", stats.at("config").dump());
  ASSERT_EQ(run_erg(folder, {"run", "again.json", "--stats", "b.json", "--quiet"}).exit_code, 0);
  EXPECT_EQ(read_json(folder.file("b.json")).at("state_hash"), stats.at("state_hash"));
}

TEST(Run, HashDoesNotDependOnThreads) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(25));
  const auto hash = [&](const std::string& threads) {
    const Ended ended =
        run_erg(folder, {"run", config, "--executor", "cpu", "--threads", threads, "--hash", "--quiet"});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    EXPECT_EQ(ended.output.size(), 17u) << "the hash and a line end, nothing else";
    return ended.output;
  };
  const std::string one = hash("1");
  EXPECT_EQ(hash("2"), one);
  EXPECT_EQ(hash("3"), one);
  const Ended other = run_erg(folder, {"run", config, "--executor", "cpu", "--seed", "8", "--hash", "--quiet"});
  EXPECT_NE(other.output, one) << "another seed gives other dunes";
}

class RunOn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Executors, RunOn, testing::Values("serial", "cpu"));

TEST_P(RunOn, ResumedRunGivesTheSameBits) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(30));
  const std::vector<std::string> common{"--executor", GetParam(), "--quiet"};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), common.begin(), common.end());
    return run_erg(folder, arguments);
  };
  const Ended whole = run({"run", config, "--hash", "--stats", "whole.json"});
  ASSERT_EQ(whole.exit_code, 0) << whole.errors;
  const Ended half = run({"run", config, "--steps", "13", "--out", "out", "--format", "checkpoint"});
  ASSERT_EQ(half.exit_code, 0) << half.errors;

  const std::string checkpoint = "out/small-000013.checkpoint";
  const Ended alone = run({"run", "--resume", checkpoint, "--steps", "30", "--hash", "--stats", "alone.json"});
  ASSERT_EQ(alone.exit_code, 0) << alone.errors;
  EXPECT_EQ(alone.output, whole.output);
  const Ended with_config = run({"run", config, "--resume", checkpoint, "--hash"});
  EXPECT_EQ(with_config.output, whole.output) << with_config.errors;
  // The totals go on too.
  for (const char* key : {"lifts", "polls", "flux"}) {
    EXPECT_EQ(read_json(folder.file("alone.json")).at(key), read_json(folder.file("whole.json")).at(key)) << key;
  }
}

TEST_P(RunOn, SlabsThatLeaveAnOpenGridAreCounted) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(40));
  const Ended ended = run_erg(folder, {"run", config, "--executor", GetParam(), "--set", "boundary=open", "--set",
                                       "inflow=0.5", "--stats", "stats.json", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const nlohmann::json stats = read_json(folder.file("stats.json"));
  EXPECT_GT(stats.at("mass_out"), 0);
  EXPECT_GT(stats.at("mass_in"), 0);
  EXPECT_EQ(stats.at("mass_start").get<int>() + stats.at("mass_in").get<int>() - stats.at("mass_out").get<int>(),
            stats.at("mass_now").get<int>());
}

std::string beginning(const std::string& path, std::size_t bytes) {
  std::string text(bytes, '\0');
  std::ifstream(path, std::ios::binary).read(text.data(), static_cast<std::streamsize>(bytes));
  return text;
}

TEST(Run, WritesEveryFormat) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(20));
  const Ended ended = run_erg(folder, {"run", config, "--out", "out", "--every", "10", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  EXPECT_EQ(ended.output, "");
  EXPECT_EQ(ended.errors, "");
  const std::string png_signature = "\x89PNG\r\n\x1a\n";
  for (const std::string step : {"000010", "000020"}) {
    const std::string stem = folder.file("out/small-" + step);
    EXPECT_EQ(beginning(stem + ".png", 8), png_signature);
    EXPECT_EQ(beginning(stem + "-height.png", 8), png_signature);
    EXPECT_EQ(beginning(stem + "-height.png", 26).substr(16), std::string("\0\0\0\x30\0\0\0\x20\x10\0", 10))
        << "48 x 32 pixels, 16 bits, grey";
    EXPECT_NE(read_bytes(stem + ".vti").find("<VTKFile type=\"ImageData\""), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(stem + ".checkpoint"));
  }
  const std::string table = read_bytes(folder.file("out/small.csv"));
  for (const char* row : {"\nstep,", "\n0,", "\n10,", "\n20,"}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << "\n" << table;
  }
}

// The steps that the rows of a table are of.
std::vector<std::string> steps_of_rows(const std::string& table) {
  std::vector<std::string> steps;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() >= '0' && line.front() <= '9') steps.push_back(line.substr(0, line.find(',')));
  }
  return steps;
}

// A row measures more than a step does, so a short run has few.
TEST(Run, RowsOfTheTableStandTenStepsApartUnlessAskedOtherwise) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(25));
  using Steps = std::vector<std::string>;
  ASSERT_EQ(run_erg(folder, {"run", config, "--out", "out", "--format", "csv", "--quiet"}).exit_code, 0);
  EXPECT_EQ(steps_of_rows(read_bytes(folder.file("out/small.csv"))), (Steps{"0", "10", "20", "25"}));
  ASSERT_EQ(run_erg(folder, {"run", config, "--out", "two", "--format", "csv", "--every", "8", "--quiet"}).exit_code,
            0);
  EXPECT_EQ(steps_of_rows(read_bytes(folder.file("two/small.csv"))), (Steps{"0", "8", "16", "24", "25"}));
}

TEST(Run, WritesTheMeshesAskedForAndNothingElse) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(2));
  const Ended ended = run_erg(folder, {"run", config, "--out", "out", "--format", "obj,ply,stl", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const std::filesystem::directory_iterator written(folder.path() / "out");
  EXPECT_EQ(std::distance(begin(written), end(written)), 3);
  const std::string stem = folder.file("out/small-000002");
  const std::string obj = read_bytes(stem + ".obj");
  std::size_t corners = 0;
  for (std::size_t at = 0; (at = obj.find("\nv ", at)) != std::string::npos; ++at) ++corners;
  EXPECT_EQ(corners, cells);
  const std::string ply = read_bytes(stem + ".ply");
  EXPECT_EQ(ply.substr(0, 4), "ply\n");
  EXPECT_NE(ply.find("element vertex " + std::to_string(cells) + "\n"), std::string::npos);
  // A header of 80 bytes, the number of triangles, 50 bytes for each.
  const std::string stl = read_bytes(stem + ".stl");
  ASSERT_GT(stl.size(), 84u);
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, stl.data() + 80, sizeof triangles);
  EXPECT_GT(triangles, 0u);
  EXPECT_EQ(stl.size(), 84 + std::size_t{50} * triangles);
}

TEST(Run, SetChangesAValue) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(5));
  const Ended ended = run_erg(folder, {"run", config, "--set", "model=werner", "--set", "sand=10", "--set", "nx=20",
                                       "--set", "wind.bearing=NW", "--stats", "stats.json", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const nlohmann::json stats = read_json(folder.file("stats.json"));
  EXPECT_EQ(stats.at("model"), "werner");
  EXPECT_EQ(stats.at("mass_now"), 20 * 32 * 10);
}

TEST(Run, AFinalStepOfZeroLeavesTheSceneAsItIs) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(0));
  const Ended ended = run_erg(folder, {"run", config, "--stats", "stats.json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const nlohmann::json stats = read_json(folder.file("stats.json"));
  EXPECT_EQ(stats.at("max_slabs"), 3);
  EXPECT_EQ(stats.at("sd_slabs"), 0);
  EXPECT_EQ(stats.at("flux"), 0);
  EXPECT_EQ(stats.at("polls"), 0);
}

}  // namespace
}  // namespace erg::test
