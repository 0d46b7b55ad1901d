// Setting up: nothing invalid can be entered, and what is entered is what is made.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/config/config_file.h"
#include "session/comparison.h"
#include "session/setup.h"
#include "session/step_cost.h"
#include "session/wind_cycle.h"
#include "small_config.h"

namespace erg {

using forcing::WindSchedule;
using io::config_text;
using io::parse_config;
using session::Comparison;
using session::measure_step;
using session::Setup;
using session::SetupRow;
using session::times_the_measured_terrain;
using session::wind_rose;
using session::WindCycle;
using session::WindEditor;
using session::WindRose;
using sim::Config;

namespace {

using test::small_config;

const SetupRow& row_of(const std::vector<SetupRow>& rows, const std::string& key) {
  for (const SetupRow& row : rows) {
    if (row.parameter->key == key) return row;
  }
  throw std::logic_error("no row " + key);
}

/// A value that the parameter must refuse.
ParameterValue wrong_value(const Parameter& parameter) {
  if (parameter.kind() == ParameterKind::choice) return std::string("no such thing");
  if (parameter.kind() == ParameterKind::real || parameter.kind() == ParameterKind::integer) {
    return 2 * parameter.maximum + 1;
  }
  return 0.5;
}

TEST(Setup, EveryValueOfEveryModelRefusesWhatIsOutOfRange) {
  for (const models::ModelType& type : models::catalogue()) {
    erg::session::Setup setup{Config(type.info.key)};
    const Config before = setup.config();
    for (const std::string group : {"grid", "scene", "parameters", "run"}) {
      for (const SetupRow& row : setup.rows(group)) {
        EXPECT_TRUE(setup.set(group, row.parameter->key, wrong_value(*row.parameter)).has_value())
            << row.parameter->key;
        if (row.parameter->kind() == ParameterKind::real) {
          EXPECT_TRUE(setup.set(group, row.parameter->key, std::nan("")).has_value()) << row.parameter->key;
        }
        EXPECT_EQ(setup.config(), before) << row.parameter->key;
        EXPECT_FALSE(row.tooltip().empty());
      }
    }
  }
}

TEST(Setup, RowsTellWhatIsChangedPendingAndRelevant) {
  erg::session::Setup setup;
  const Config running = setup.config();
  EXPECT_FALSE(setup.set_text("grid", "nx", "128").has_value());
  EXPECT_FALSE(setup.set("parameters", "p_sand", 0.5).has_value());
  const std::vector<SetupRow> grid = setup.rows("grid", &running);
  EXPECT_TRUE(row_of(grid, "nx").changed);
  EXPECT_TRUE(row_of(grid, "nx").pending);
  EXPECT_TRUE(row_of(grid, "nx").needs_new_terrain);
  EXPECT_FALSE(row_of(grid, "ny").changed);
  EXPECT_FALSE(row_of(grid, "inflow").relevant) << "a torus has no inflow";
  const std::vector<SetupRow> parameters = setup.rows("parameters", &running);
  EXPECT_FALSE(row_of(parameters, "p_sand").needs_new_terrain);
  EXPECT_TRUE(row_of(parameters, "slab_height").needs_new_terrain);
  EXPECT_TRUE(setup.needs_new_terrain(running));
  setup.reset("grid", "nx");
  EXPECT_FALSE(setup.needs_new_terrain(running)) << "a chance of landing may change in a run";
  setup.reset_all();
  EXPECT_EQ(setup.config(), running);
}

TEST(Setup, EachModelBeginsWhereItsFormsComeOut) {
  erg::session::Setup setup;
  setup.choose_model("grains");
  EXPECT_EQ(setup.config().grid.real("cell_size"), 0.01);
  EXPECT_EQ(setup.config().wind.intervals.front().first, 10);
  setup.set("grid", "cell_size", 0.02);
  setup.choose_model("snow_sintering");
  EXPECT_EQ(setup.config().grid.real("cell_size"), 0.02) << "what was set stays";
  EXPECT_EQ(setup.config().wind.intervals.front().last, 11);
  setup.reset_all();
  EXPECT_EQ(setup.config().grid.real("cell_size"), 0.1);
  setup.set("grid", "cell_size", 0.1);
  setup.choose_model("momiji");
  EXPECT_EQ(setup.config(), Config("momiji"));
}

TEST(Setup, TypedTextThatIsNoValueIsRefusedWithARemedy) {
  erg::session::Setup setup;
  const auto mistake = setup.set_text("grid", "nx", "many");
  ASSERT_TRUE(mistake.has_value());
  EXPECT_NE(mistake->remedy.find("16384"), std::string::npos) << mistake->text();
  EXPECT_TRUE(setup.set_text("grid", "no_such", "1").has_value());
  EXPECT_TRUE(setup.set_text("no_such", "nx", "1").has_value());
}

TEST(Setup, WhatIsEnteredSurvivesAFile) {
  erg::session::Setup setup;
  setup.choose_model("werner");
  setup.set_text("grid", "boundary", "open");
  setup.set_text("grid", "inflow", "0.25");
  setup.set_title("a \"title\"");
  setup.wind().duplicate(0);
  ASSERT_FALSE(setup.wind().set_curve(1, {{0.25, 0}, {0.5, 1}}).has_value());
  ASSERT_FALSE(setup.wind().set_steps(1, 80).has_value());
  ASSERT_FALSE(setup.wind().set_last(1, 9).has_value());
  EXPECT_EQ(parse_config(config_text(setup.config()), "test"), setup.config());
}

TEST(Setup, APictureMustBeThereBeforeItIsCreated) {
  erg::session::Setup setup;
  setup.set_text("scene", "kind", "image");
  EXPECT_EQ(setup.mistakes().size(), 1u);
  EXPECT_THROW(setup.config_to_create(), InputError);
}

TEST(Setup, TheTemperatureOfSnowIsEditedInItsRange) {
  erg::session::Setup setup;
  setup.choose_material(Material::snow);
  ASSERT_EQ(setup.material(), Material::snow);
  const Config before = setup.config();
  const forcing::Channel& temperature = *forcing::find_channel("temperature");
  EXPECT_TRUE(setup.set_course(temperature, {-20, 5, {}}).has_value());
  EXPECT_TRUE(setup.set_course(temperature, {-20, -4, {{0, 2}, {1, 1}}}).has_value());
  EXPECT_EQ(setup.config(), before);
  ASSERT_FALSE(setup.set_course(temperature, {-20, -4, {{0, 0}, {1, 1}}}).has_value());
  const forcing::Course& now = setup.config().weather.temperature;
  EXPECT_EQ(now.at(0), -20);
  EXPECT_NEAR(now.at(0.5), -12, 1e-9);
  EXPECT_EQ(now.at(1), -4);
  EXPECT_EQ(parse_config(config_text(setup.config()), "test"), setup.config());
  EXPECT_EQ(setup.in_force_on(before).weather.temperature.last, -4) << "may change in a run";
  setup.choose_material(Material::sand);
  EXPECT_EQ(setup.material(), Material::sand);
}

TEST(Setup, AFreshSeedIsDrawnAndKept) {
  erg::session::Setup setup;
  EXPECT_EQ(setup.config_to_create().run.integer("seed"), 0);
  setup.set_fresh_seed(true);
  const std::int64_t drawn = setup.config_to_create().run.integer("seed");
  EXPECT_GT(drawn, 0);
  EXPECT_EQ(setup.config().run.integer("seed"), drawn) << "so that the run can be done again";
}

TEST(Setup, WhatTakesEffectInARunLeavesTheRestAsItRuns) {
  erg::session::Setup setup(small_config());
  setup.set_text("grid", "nx", "64");
  setup.set_text("parameters", "p_bare", "0.1");
  ASSERT_FALSE(setup.wind().set_bearing(0, "N").has_value());
  const Config applied = setup.in_force_on(small_config());
  EXPECT_EQ(applied.grid.integer("nx"), 48);
  EXPECT_EQ(applied.parameters.real("p_bare"), 0.1);
  EXPECT_EQ(applied.wind.intervals[0].bearing, 0);
  setup.choose_model("bishop");
  EXPECT_EQ(setup.in_force_on(small_config()), small_config());
}

TEST(WindEditor, SeasonsAreAddedMovedAndRemovedButNeverAll) {
  WindSchedule schedule = WindSchedule::constant(270, 5);
  WindEditor wind(schedule);
  EXPECT_FALSE(wind.remove(0));
  EXPECT_EQ(wind.duplicate(0), 1u);
  ASSERT_FALSE(wind.set_bearing(1, "NNE").has_value());
  EXPECT_EQ(wind.season(1).bearing, 22.5);
  EXPECT_FALSE(wind.move_up(0));
  EXPECT_TRUE(wind.move_up(1));
  EXPECT_EQ(wind.season(0).bearing, 22.5);
  EXPECT_TRUE(wind.move_down(0));
  EXPECT_FALSE(wind.move_down(1));
  EXPECT_EQ(wind.add(), 2u);
  EXPECT_TRUE(wind.remove(1));
  EXPECT_EQ(wind.seasons(), 2u);
}

TEST(WindEditor, InvalidValuesChangeNothing) {
  WindSchedule schedule = WindSchedule::constant(270, 5);
  const WindSchedule before = schedule;
  WindEditor wind(schedule);
  EXPECT_TRUE(wind.set_bearing(0, 361).has_value());
  EXPECT_TRUE(wind.set_bearing(0, std::nan("")).has_value());
  EXPECT_TRUE(wind.set_bearing(0, "upward").has_value());
  EXPECT_TRUE(wind.set_first(0, -1).has_value());
  EXPECT_TRUE(wind.set_last(0, std::numeric_limits<double>::infinity()).has_value());
  EXPECT_TRUE(wind.set_steps(0, 0).has_value());
  EXPECT_TRUE(wind.set(0, "snowfall", -1.0).has_value());
  EXPECT_TRUE(wind.set_curve(0, {{-0.1, 0}, {1, 1}}).has_value());
  EXPECT_TRUE(wind.set_curve(0, {{0, 0}, {1, 1.5}}).has_value());
  EXPECT_EQ(schedule, before);
}

TEST(WindCycle, IsTheWindOfTheRun) {
  const WindSchedule schedule{{{.bearing = 270, .first = 3, .last = 8, .steps = 10, .curve = {}},
                               {.bearing = 180, .first = 8, .last = 8, .steps = 5, .curve = {}}}};
  const WindCycle cycle = session::sample_cycle(schedule, 15);
  ASSERT_EQ(cycle.steps.size(), 15u);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(cycle.steps[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(cycle.strengths[i], schedule.at(cycle.steps[i]).strength);
  }
  EXPECT_EQ(cycle.season_starts, (std::vector<std::int64_t>{0, 10}));
  EXPECT_EQ(cycle.position(37), 7);
  EXPECT_EQ(cycle.season_at(24), 0u);
  EXPECT_EQ(cycle.season_at(26), 1u);
}

TEST(WindRose, AddsUpWhatBlowsFromWhere) {
  const WindSchedule schedule{{{.bearing = 270, .first = 3, .last = 3, .steps = 10, .curve = {}},
                               {.bearing = 180, .first = 8, .last = 8, .steps = 5, .curve = {}}}};
  // After 17 steps: a whole cycle (30 from W, 40 from S) and two more steps from W. At 30: two cycles.
  const WindRose rose = wind_rose(schedule, 17, 30, 8);
  EXPECT_DOUBLE_EQ(rose.blown[6], 36);
  EXPECT_DOUBLE_EQ(rose.blown[4], 40);
  EXPECT_DOUBLE_EQ(rose.to_blow[6], 24);
  EXPECT_DOUBLE_EQ(rose.to_blow[4], 40);
  EXPECT_DOUBLE_EQ(rose.blown[0] + rose.to_blow[0], 0);
}

TEST(WindRose, CountsTheSwingsOfASpread) {
  const WindSchedule schedule{
      {{.bearing = 270, .first = 4, .last = 4, .steps = 1, .curve = {}, .snowfall = 0, .spread = 10}}};
  // 8 sectors: swings beyond 22.5 degrees lie in the neighbours; none of 10 degrees does. Of 32 sectors the widest do.
  EXPECT_DOUBLE_EQ(wind_rose(schedule, 16, 16, 8).blown[6], 64);
  const WindRose fine = wind_rose(schedule, 16, 16, 32);
  EXPECT_LT(fine.blown[24], 64);
  EXPECT_DOUBLE_EQ(fine.blown[23], fine.blown[25]) << "as often to the left as to the right";
  EXPECT_DOUBLE_EQ(fine.blown[22] + fine.blown[23] + fine.blown[24] + fine.blown[25] + fine.blown[26], 64);
}

TEST(Setup, TitlesSpeakOfTheirModelOnly) {
  Config config("werner");
  config.title = "Barchans after Werner";
  config.description = "As in the paper.";
  erg::session::Setup setup(config);  // gtest has another
  setup.choose_model("momiji");
  EXPECT_EQ(setup.config().title, "");
  EXPECT_EQ(setup.config().description, "");
  EXPECT_FALSE(setup.has_its_own_model());
  setup.choose_model("werner");
  EXPECT_EQ(setup.config().title, "Barchans after Werner");
  EXPECT_EQ(setup.config().description, "As in the paper.");
  setup.choose_model("momiji");
  setup.set_title("mine");
  setup.choose_model("werner");
  EXPECT_EQ(setup.config().title, "") << "the new one was given for the other model";
}

TEST(StepCost, IsFoundBeforeTheTerrainIsMade) {
  Config config("grains");
  config.run.set("executor", std::string("serial"));
  config.grid.set("nx", std::int64_t{64});
  config.grid.set("ny", std::int64_t{64});
  EXPECT_DOUBLE_EQ(times_the_measured_terrain(config), 1);
  config.grid.set("nx", std::int64_t{512});
  config.grid.set("ny", std::int64_t{32});
  EXPECT_DOUBLE_EQ(times_the_measured_terrain(config), 8);
  const std::optional<double> seconds = measure_step(config);
  ASSERT_TRUE(seconds.has_value());
  EXPECT_GT(*seconds, 0);
  config.scene.set("kind", std::string("image"));
  EXPECT_EQ(measure_step(config), std::nullopt) << "without its picture no terrain can be made";
}

TEST(Comparison, HasOneWindAndListsWhatDiffers) {
  Comparison comparison;
  ASSERT_EQ(comparison.add_copy_of(0), 1u);
  comparison.setup(1).choose_model("werner");
  comparison.setup(1).set_text("parameters", "p_sand", "0.3");
  ASSERT_FALSE(comparison.wind().set_bearing(0, "NE").has_value());
  const std::vector<Config> configs = comparison.configs_to_create();
  EXPECT_EQ(configs[0].wind, configs[1].wind);
  std::vector<std::string> names;
  for (const session::SetupDifference& difference : comparison.differences()) {
    names.push_back(difference.name);
    ASSERT_EQ(difference.values.size(), 2u);
    if (difference.name == "parameters.linear") {
      EXPECT_EQ(difference.values[1], "-");
    } else if (difference.name == "parameters.p_sand") {
      EXPECT_EQ(difference.values, (std::vector<std::string>{"0.6", "0.3"}));
    }
  }
  for (const std::string name : {"model", "run.seed", "parameters.p_sand", "parameters.linear"}) {
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
  }
  EXPECT_EQ(std::ranges::find(names, "grid.nx"), names.end());
  ASSERT_EQ(comparison.add_copy_of(0), 2u);
  ASSERT_EQ(comparison.add_copy_of(0), 3u);
  EXPECT_EQ(comparison.add_copy_of(0), std::nullopt);
  EXPECT_TRUE(comparison.remove(0));
  EXPECT_EQ(comparison.configs()[0].wind, configs[0].wind) << "the wind of all outlives the first run";
}

}  // namespace
}  // namespace erg
