// Parameters that are lists of rows: read, written, set and described as their columns are declared.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../unit/message.h"
#include "io/config/config_file.h"
#include "models/model.h"
#include "models/slab/slab_model.h"
#include "session/setup.h"

namespace erg {

using io::config_text;
using io::parse_config;
using models::ModelType;
using sim::Config;
using sim::set_from_text;

namespace {

Parameter stones() {
  return {.key = "stones",
          .label = "Stones",
          .default_value = RowList{},
          .minimum = 0,
          .maximum = 3,
          .columns = {{.key = "x", .label = "East", .unit = "cells", .default_value = 0.0, .minimum = 0, .maximum = 99},
                      {.key = "height", .label = "Height", .unit = "m", .default_value = 2.0, .maximum = 9},
                      {.key = "shape", .label = "Shape", .default_value = "round", .choices = {"round", "flat"}}},
          .row_name = "stone",
          .meaning = "Stones that lie on the sand."};
}

/// Werner's model with a list, which it does nothing with.
ModelType stony_type() {
  ModelType type = models::find_model("werner");
  type.info.key = "stony";
  Parameters declared = type.parameters;
  declared.push_back(stones());
  type.parameters = declared;
  return type;
}

class RowLists : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { models::add_model(stony_type()); }

  static std::string mistakes(const std::string& list) {
    return message([&] { parse_config(text(list), "a.json"); });
  }
  static std::string text(const std::string& list) {
    return "{\"erg\": 1, \"model\": \"stony\", \"parameters\": {\n\"stones\": " + list + "}}";
  }
};

TEST_F(RowLists, AreReadRowByRow) {
  const Config config = parse_config(text(R"([{"x": 5, "shape": "flat"}, {}])"), "a.json");
  const std::vector<ParameterValues>& rows = config.parameters.rows("stones");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].real("x"), 5);
  EXPECT_EQ(rows[0].text("shape"), "flat");
  EXPECT_EQ(rows[1].real("height"), 2) << "what a row leaves out has its default";
  EXPECT_TRUE(parse_config(text("[]"), "a.json").parameters.rows("stones").empty());
  EXPECT_EQ(&rows[0].declared(), &rows[1].declared()) << "all rows share one table of declarations";
}

TEST_F(RowLists, MistakesSayTheLineOfTheRow) {
  EXPECT_EQ(mistakes("[{\"x\": 5},\n{\"x\": -1},\n{\"hight\": 3, \"shape\": \"falt\"}]"),
            "a.json:3: x is -1; expected 0 to 99 cells\n"
            "a.json:4: unknown key \"hight\"; did you mean \"height\"?\n"
            "a.json:4: unknown shape \"falt\"; did you mean \"flat\"?");
  EXPECT_EQ(mistakes("{}"), "a.json:2: stones is an object; expected a list of stones, [{ ... }, { ... }]");
  EXPECT_EQ(mistakes("[7]"), "a.json:2: a stone is 7; expected an object, { ... }");
  EXPECT_EQ(mistakes("[{}, {}, {}, {}]"),
            "a.json:2: stones has 4 rows; expected a list of stones, [{ ... }, { ... }], 0 to 3 of them");
}

TEST_F(RowLists, AreWrittenAsTheyAreRead) {
  const Config config = parse_config(text(R"([{"x": 5, "shape": "flat"}, {"height": 3.5}])"), "a.json");
  const nlohmann::json json = nlohmann::json::parse(config_text(config));
  EXPECT_EQ(json["parameters"]["stones"], nlohmann::json::parse(R"([{"x": 5, "shape": "flat"}, {"height": 3.5}])"));
  EXPECT_EQ(parse_config(config_text(config), "a.json"), config);
  EXPECT_FALSE(nlohmann::json::parse(config_text(Config("stony"))).contains("parameters"));
}

TEST_F(RowLists, AreSetFromText) {
  Config config = parse_config(text(R"([{"x": 5}, {}])"), "a.json");
  set_from_text(config, "parameters.stones[2].shape=flat");
  set_from_text(config, "stones[1].x=7");
  EXPECT_EQ(config.parameters.rows("stones")[1].text("shape"), "flat");
  EXPECT_EQ(config.parameters.rows("stones")[0].real("x"), 7);
  const auto said = [&](const std::string& assignment) { return message([&] { set_from_text(config, assignment); }); };
  EXPECT_EQ(said("stones[3].x=7"), "--set stones[3].x=7: there is no stone 3; expected 1 to 2");
  EXPECT_EQ(said("stones[0].x=7"), "--set stones[0].x=7: there is no stone 0; expected 1 to 2");
  EXPECT_EQ(said("stones[1].hight=7"), "--set stones[1].hight=7: unknown key \"hight\"; did you mean \"height\"?");
  EXPECT_EQ(said("stones[1].x=-1"), "--set stones[1].x=-1: x is -1; expected 0 to 99 cells");
  EXPECT_EQ(said("nx[1].x=3"), "--set nx[1].x=3: \"nx\" is no list; expected wind.seasons");
}

TEST_F(RowLists, AreDescribedByTheSchema) {
  const nlohmann::json schema = nlohmann::json::parse(io::config_schema());
  const nlohmann::json& list = schema["$defs"]["stony"]["properties"]["stones"];
  EXPECT_EQ(list["type"], "array");
  EXPECT_EQ(list["maxItems"], 3);
  EXPECT_EQ(list["items"]["properties"]["height"]["default"], 2);
  EXPECT_EQ(list["items"]["additionalProperties"], false);
}

TEST_F(RowLists, AreEditedInASetup) {
  erg::session::Setup setup;
  setup.choose_model("stony");
  RowList list;
  list.rows.emplace_back(stones().columns);
  EXPECT_FALSE(setup.set("parameters", "stones", list).has_value());
  list.rows.resize(4, list.rows.front());
  EXPECT_TRUE(setup.set("parameters", "stones", list).has_value()) << "more than there may be";
  EXPECT_EQ(setup.config().parameters.rows("stones").size(), 1u);
}

TEST(SeasonRows, AreSetFromText) {
  Config config("snow_sintering");
  config.wind.intervals.resize(2, config.wind.intervals.front());
  set_from_text(config, "wind.seasons[2].bearing=NE");
  set_from_text(config, "wind.seasons[2].last=9");
  set_from_text(config, "wind.seasons[2].snowfall=3");
  set_from_text(config, "seasons[1].steps=40");
  EXPECT_EQ(config.wind.intervals[1].bearing, 45);
  EXPECT_EQ(config.wind.intervals[1].first, Config("snow_sintering").wind.intervals.front().first);
  EXPECT_EQ(config.wind.intervals[1].last, 9);
  EXPECT_EQ(config.wind.intervals[1].snowfall, 3);
  EXPECT_EQ(config.wind.intervals[0].steps, 40);
  EXPECT_EQ(message([&] { set_from_text(config, "wind.seasons[3].steps=4"); }),
            "--set wind.seasons[3].steps=4: there is no season 3; expected 1 to 2");
  Config sand("momiji");
  EXPECT_EQ(
      message([&] { set_from_text(sand, "wind.seasons[1].snowfall=3"); }),
      "--set wind.seasons[1].snowfall=3: \"momiji\" asks for no snowfall; leave it out, or take a model that does");
}

}  // namespace
}  // namespace erg
