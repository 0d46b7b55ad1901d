// `erg measure` as a person uses it.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "program.h"

namespace erg::test {
namespace {

/// A heap of sand that becomes a barchan, in a wind from the west-north-west.
const std::string heap = R"({
  "erg": 1, "model": "momiji", "grid": {"nx": 128, "ny": 96},
  "scene": {"kind": "cone", "sand": 0, "height": 8, "radius": 20}, "wind": {"bearing": 285, "strength": 5, "spread": 0},
  "run": {"steps": 100, "executor": "cpu", "threads": 1}
})";

/// The lines of a CSV that are no comments.
std::vector<std::string> rows(const std::string& csv) {
  std::vector<std::string> lines;
  std::istringstream text(csv);
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

TEST(Measure, TellsOfABarchanInJson) {
  const ScratchFolder folder;
  folder.write("heap.json", heap);
  const Ended ended = run_erg(folder, {"measure", "heap.json", "--json", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const nlohmann::json all = nlohmann::json::parse(ended.output);
  ASSERT_EQ(all.at("moments").size(), 1u);
  const nlohmann::json& moment = all.at("moments").at(0);
  EXPECT_EQ(moment.at("step"), 100);
  EXPECT_EQ(moment.at("bearing").get<double>(), all.at("config").at("wind").at("bearing").get<double>());
  EXPECT_EQ(moment.at("dunes"), 1);
  EXPECT_GT(moment.at("sand_share"), 0.6);
  EXPECT_TRUE(moment.at("height_sd").is_null()) << "of a single dune";
  ASSERT_EQ(moment.at("each").size(), 1u);
  const nlohmann::json& dune = moment.at("each").at(0);
  EXPECT_EQ(dune.at("dune"), 1);
  EXPECT_EQ(dune.at("height"), moment.at("height"));
  EXPECT_GT(dune.at("width"), dune.at("height"));
  EXPECT_GT(dune.at("speed"), 0.1);
  EXPECT_LT(dune.at("speed"), 2);
  EXPECT_NEAR(dune.at("toward").get<double>(), 105, 10) << "downwind";
  // A step is 5 / 0.6 / 3 m2 of 50 a year.
  EXPECT_NEAR(dune.at("speed_a_year").get<double>() / dune.at("speed").get<double>(), 50 * 0.6 * 3 / 5, 1e-6);
  EXPECT_EQ(all.at("units_of_each").at("volume"), "m³");
  for (const auto& [key, value] : moment.items()) {
    if (value.is_number()) {
      EXPECT_TRUE(all.at("units").contains(key)) << key;
    }
  }
}

TEST(Measure, ACheckpointIsAsGoodAsItsConfig) {
  const ScratchFolder folder;
  folder.write("heap.json", heap);
  ASSERT_EQ(run_erg(folder, {"run", "heap.json", "--out", ".", "--format", "checkpoint", "--quiet"}).exit_code, 0);
  const Ended config = run_erg(folder, {"measure", "heap.json", "--quiet"});
  const Ended saved = run_erg(folder, {"measure", "heap-000100.checkpoint", "--quiet"});
  ASSERT_EQ(saved.exit_code, 0) << saved.errors;
  EXPECT_EQ(saved.output, config.output);
  EXPECT_NE(saved.output.find("Slip face, °"), std::string::npos) << saved.output;
}

TEST(Measure, ARunGivesARowForEachDuneAndMoment) {
  const ScratchFolder folder;
  folder.write("heap.json", heap);
  const Ended ended = run_erg(folder, {"measure", "heap.json", "--every", "40", "--csv", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  EXPECT_NE(ended.output.find("# erg:config"), std::string::npos) << "says where it comes from";
  const std::vector<std::string> lines = rows(ended.output);
  ASSERT_EQ(lines.size(), 5u) << ended.output;
  EXPECT_TRUE(lines[0].starts_with("step,days,dune,x,y,height,width,length,volume,")) << lines[0];
  const std::string steps[] = {"0,", "40,", "80,", "100,"};
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_TRUE(lines[row + 1].starts_with(steps[row])) << lines[row + 1];
    std::istringstream cells(lines[row + 1]);
    std::string cell;
    for (int column = 0; column < 3; ++column) std::getline(cells, cell, ',');
    EXPECT_EQ(cell, "1") << "the same dune all the way";
  }
  const Ended together = run_erg(folder, {"measure", "heap.json", "--every", "50", "--csv", "--summary", "--quiet"});
  EXPECT_EQ(rows(together.output).size(), 4u) << "0, 50, 100";
  EXPECT_TRUE(rows(together.output).at(0).starts_with("step,days,dunes,endless,")) << together.output;
}

TEST(Measure, SaysWhatIsWrong) {
  const ScratchFolder folder;
  folder.write("heap.json", heap);
  EXPECT_EQ(run_erg(folder, {"measure"}).exit_code, 2);
  EXPECT_EQ(run_erg(folder, {"measure", "heap.json", "--json", "--csv"}).exit_code, 2);
  const Ended nowhere = run_erg(folder, {"measure", "heap.json", "--bearing", "up", "--quiet"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.errors.find("--bearing"), std::string::npos) << nowhere.errors;
  ASSERT_EQ(run_erg(folder, {"run", "heap.json", "--out", ".", "--format", "checkpoint", "--quiet"}).exit_code, 0);
  const Ended past = run_erg(folder, {"measure", "heap-000100.checkpoint", "--steps", "50", "--quiet"});
  EXPECT_EQ(past.exit_code, 2);
  EXPECT_NE(past.errors.find("step 100"), std::string::npos) << past.errors;
}

}  // namespace
}  // namespace erg::test
