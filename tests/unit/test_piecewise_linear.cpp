#include <gtest/gtest.h>

#include "core/parameters.h"
#include "io/config/config_file.h"
#include "models/model.h"

namespace erg {

using io::parse_config;

namespace {

const PiecewiseLinear growth{{{-1, -0.5}, {0, 0}, {0.5, 1}}};

TEST(PiecewiseLinear, IsStraightBetweenVerticesAndLevelBeyondThem) {
  EXPECT_EQ(growth.at(-1), -0.5);
  EXPECT_EQ(growth.at(0), 0);
  EXPECT_EQ(growth.at(0.5), 1);
  EXPECT_EQ(growth.at(-0.5), -0.25);
  EXPECT_EQ(growth.at(0.25), 0.5);
  EXPECT_EQ(growth.at(-7), -0.5);
  EXPECT_EQ(growth.at(7), 1);
}

TEST(PiecewiseLinear, IsReadAsItIsWritten) {
  EXPECT_EQ(vertices_text(growth), "-1:-0.5, 0:0, 0.5:1");
  EXPECT_EQ(parse_vertices(vertices_text(growth)), growth);
  for (const char* wrong : {"", "1", "1:2,", "1:2 3:4", "a:1, 2:3", "1:2:3"}) {
    EXPECT_FALSE(parse_vertices(wrong)) << wrong;
  }
}

Parameter declared() {
  return {.key = "growth",
          .label = "Growth",
          .unit = "1/yr",
          .default_value = growth,
          .minimum = -1,
          .maximum = 1,
          .x_label = "balance, m/yr",
          .x_minimum = -2,
          .x_maximum = 2,
          .meaning = "How plants grow."};
}

TEST(CurveParameter, RefusesWhatIsNoCurveWithinItsRanges) {
  EXPECT_FALSE(check_value(declared(), growth, ""));
  for (const char* wrong : {"0:0", "0:0, 0:1", "1:0, 0:0", "0:0, 3:0", "0:0, 1:2", "flat"}) {
    EXPECT_THROW(parse_value(declared(), wrong, "--set growth"), InputError) << wrong;
  }
  EXPECT_TRUE(check_value(declared(), 3.0, ""));
}

TEST(CurveParameter, GoesThroughAConfigFile) {
  const sim::Config read = parse_config(
      R"({"erg": 1, "model": "nield_baas", "parameters": {"grass_growth": [[-1, -1], [0.5, 0.25], [2, -0.5]]}})", "c");
  const PiecewiseLinear expected{{{-1, -1}, {0.5, 0.25}, {2, -0.5}}};
  EXPECT_EQ(read.parameters.curve("grass_growth"), expected);
  EXPECT_EQ(parse_config(io::config_text(read), "saved"), read);
  try {
    parse_config("{\"erg\": 1, \"model\": \"nield_baas\",\n\"parameters\": {\"grass_growth\": [[0, 0], [0, 1]]}}", "c");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.mistakes().front().text().find("c:2"), std::string::npos) << error.mistakes().front().text();
  }
}

}  // namespace
}  // namespace erg
