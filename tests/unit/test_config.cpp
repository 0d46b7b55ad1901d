#include "sim/config.h"

#include <gtest/gtest.h>

#include <set>

#include "io/config/config_file.h"
#include "message.h"
#include "models/model.h"

namespace erg {

using forcing::WindInterval;
using io::config_text;
using io::parse_config;
using models::natural_spread;
using sim::change_model;
using sim::Config;
using sim::model_keys;
using sim::set_from_text;

namespace {

std::string set_message(const std::string& assignment, Config config = Config()) {
  const Config before = config;
  const std::string said = message([&] { set_from_text(config, assignment); });
  if (said != "no error") {
    EXPECT_EQ(config, before) << "a refused assignment changed the config";
  }
  return said;
}

TEST(Config, EveryModelHasAConfigOfDefaults) {
  for (const std::string& key : model_keys()) {
    const Config config(key);
    EXPECT_EQ(config.model, key);
    EXPECT_EQ(config.parameters, ParameterValues(models::find_model(key).parameters));
  }
  EXPECT_EQ(Config().model, "momiji");
  EXPECT_THROW(Config("moniji"), InputError);
}

TEST(Config, EveryDeclarationIsSound) {
  for (const std::string& key : model_keys()) {
    const Config config(key);
    for (const sim::ConfigGroup& group : sim::config_groups()) {
      std::set<std::string> seen;
      for (const Parameter& parameter : (config.*group.values).declared()) {
        SCOPED_TRACE(group.key + "." + parameter.key);
        EXPECT_TRUE(seen.insert(parameter.key).second) << "declared twice";
        EXPECT_FALSE(parameter.label.empty());
        EXPECT_FALSE(parameter.meaning.empty());
        EXPECT_FALSE(check_value(parameter, parameter.default_value, "")) << "the default is not accepted";
        if (parameter.active_if.empty()) continue;
        const Parameter* switch_parameter = (config.*group.values).find(parameter.active_if.front());
        ASSERT_NE(switch_parameter, nullptr);
        for (std::size_t i = 1; i < parameter.active_if.size(); ++i) {
          EXPECT_FALSE(check_value(*switch_parameter, parameter.active_if[i], "")) << parameter.active_if[i];
        }
      }
    }
  }
}

// The terrain counts its heights in it.
TEST(Config, NoChangeOfARunChangesTheHeightOfItsSlabs) {
  for (const models::ModelType& type : models::catalogue()) {
    const double quantum = type.make(ParameterValues(type.parameters))->quantum();
    for (const Parameter& parameter : type.parameters) {
      if (parameter.at_start || parameter.kind() != ParameterKind::real) continue;
      ParameterValues values(type.parameters);
      values.set(parameter.key, 0.5 * (parameter.minimum + parameter.maximum));
      EXPECT_EQ(type.make(values)->quantum(), quantum) << type.info.key << ", " << parameter.key;
    }
  }
}

TEST(Config, SetsValuesFromText) {
  Config config;
  set_from_text(config, "grid.nx=512");
  set_from_text(config, "steps=20");
  set_from_text(config, "boundary=open");
  set_from_text(config, "parameters.p_sand=0.5");
  set_from_text(config, "wind.bearing=SW");
  set_from_text(config, "strength=7.5");
  set_from_text(config, "title=a = b");
  set_from_text(config, "sweeps=8");
  EXPECT_EQ(config.grid.integer("nx"), 512);
  EXPECT_EQ(config.run.integer("steps"), 20);
  EXPECT_EQ(config.grid.text("boundary"), "open");
  EXPECT_EQ(config.parameters.real("p_sand"), 0.5);
  EXPECT_EQ(
      config.wind.intervals,
      (std::vector<WindInterval>{{.bearing = 225, .first = 7.5, .last = 7.5, .curve = {}, .spread = natural_spread}}));
  EXPECT_EQ(config.title, "a = b");
  EXPECT_EQ(config.run.integer("sweeps"), 8);
}

TEST(Config, AnotherModelKeepsWhatWasSet) {
  Config config("momiji");
  set_from_text(config, "p_sand=0.4");
  set_from_text(config, "linear=0.7");
  set_from_text(config, "model=werner");
  EXPECT_EQ(config.model, "werner");
  EXPECT_EQ(config.parameters.real("p_sand"), 0.4);
  EXPECT_EQ(config.parameters.real("repose_angle"), 30);  // a default is no choice: it is the new model's
  EXPECT_EQ(config.parameters.find("linear"), nullptr);
}

TEST(Config, AnotherModelStartsWithItsOwnCellsWindAndSand) {
  Config config("momiji");
  set_from_text(config, "sand=50");
  set_from_text(config, "model=grains");
  Config expected("grains");
  expected.scene.set("sand", 50.0);
  EXPECT_EQ(config, expected);
  EXPECT_TRUE(config.grid.is_default("cell_size"));
  set_from_text(config, "wind.strength=8");
  set_from_text(config, "model=momiji");
  EXPECT_EQ(config.wind.intervals,
            (std::vector<WindInterval>{{.first = 8, .last = 8, .curve = {}, .spread = natural_spread}}))
      << "what was set stays, what was not is the new model's";
  EXPECT_EQ(config.scene.real("sand"), 50);
  EXPECT_EQ(config.grid.real("cell_size"), 1);
}

TEST(Config, ASpreadIsTheModelsOwnUntilItIsSet) {
  Config config("momiji");
  config.wind.intervals.resize(2, config.wind.intervals.front());
  change_model(config, "grains");
  for (const WindInterval& season : config.wind.intervals) EXPECT_EQ(season.spread, 0);
  set_from_text(config, "wind.spread=25");
  set_from_text(config, "wind.hold=7");
  change_model(config, "momiji");
  for (const WindInterval& season : config.wind.intervals) {
    EXPECT_EQ(season.spread, 25);
    EXPECT_EQ(season.hold, 7);
  }
}

/// What is said against the text of a config.
std::string text_message(const std::string& text) {
  return message([&] { parse_config(text, "a.json"); });
}

TEST(Config, WeatherThatTheModelDoesNotAskForIsRefusedAndNotWritten) {
  EXPECT_EQ(text_message("{\"erg\": 1, \"model\": \"momiji\",\n\"temperature\": -5,\n\"wind\": {\"seasons\": [{},\n"
                         "{\"snowfall\": 0}]}}"),
            "a.json:2: \"momiji\" asks for no temperature; leave it out, or take a model that does\n"
            "a.json:4: \"momiji\" asks for no snowfall; leave it out, or take a model that does");
  EXPECT_EQ(text_message(R"({"erg": 1, "model": "snow_packing", "temperature": -5})"), "no error");
  EXPECT_NE(text_message(R"({"erg": 1, "model": "snow_packing", "wind": {"seasons": [{"snowfall": 1}]}})"), "no error");
  EXPECT_EQ(text_message(R"({"erg": 1, "model": "snow_sintering", "wind": {"seasons": [{"snowfall": 1}]}})"),
            "no error");

  Config config("snow_sintering");  // as a setup of the window, whose model may change
  config.weather.temperature.last = -2;
  config.wind.intervals.front().snowfall = 3;
  EXPECT_EQ(parse_config(config_text(config), "a.json"), config);
  change_model(config, "momiji");
  const Config read = parse_config(config_text(config), "a.json");
  EXPECT_EQ(read.weather, forcing::Weather{});
  EXPECT_EQ(read.wind.intervals.front().snowfall, 0);
}

TEST(Config, MistakesInAssignmentsTeach) {
  EXPECT_EQ(set_message("grid.nx=0"), "--set grid.nx=0: nx is 0; expected a whole number, 1 to 16384 cells");
  EXPECT_EQ(set_message("stepps=3"), "--set stepps=3: unknown key \"stepps\"; did you mean \"steps\"?");
  EXPECT_EQ(set_message("run.stepps=3"), "--set run.stepps=3: unknown key \"run.stepps\"; did you mean \"run.steps\"?");
  EXPECT_EQ(set_message("boundary=opne"), "--set boundary=opne: unknown boundary \"opne\"; did you mean \"open\"?");
  EXPECT_EQ(set_message("model=bishopp"), "--set model=bishopp: unknown model \"bishopp\"; did you mean \"bishop\"?");
  EXPECT_EQ(set_message("temperature.last=-3"),
            "--set temperature.last=-3: \"momiji\" asks for no temperature; leave it out, or take a model that does");
  EXPECT_EQ(set_message("nx"), "--set nx: not an assignment; expected key=value, for example run.steps=500");
  EXPECT_EQ(set_message("=3"), "--set =3: not an assignment; expected key=value, for example run.steps=500");
  EXPECT_EQ(set_message("wind.strength=-1"), "--set wind.strength=-1: strength is -1; expected 0 to 8192");
  EXPECT_EQ(set_message("bearing=up"),
            "--set bearing=up: bearing is \"up\"; expected -360 to 360 degrees, or a compass "
            "point such as W or NNE");
}

TEST(Config, AWindOfSeasonsIsNotSetFromText) {
  Config config;
  config.wind.intervals = {WindInterval{}, WindInterval{}};
  EXPECT_EQ(set_message("bearing=W", config), "--set bearing=W: the wind has 2 seasons; change them in the config");
}

TEST(Config, ChangingTheStrengthKeepsTheSeason) {
  Config config;
  config.wind.intervals = {{.bearing = 10, .first = 3, .last = 8, .steps = 80, .curve = {}}};
  set_from_text(config, "strength=4");
  EXPECT_EQ(config.wind.intervals.front(),
            (WindInterval{.bearing = 10, .first = 4, .last = 4, .steps = 80, .curve = {}}));
}

}  // namespace
}  // namespace erg
