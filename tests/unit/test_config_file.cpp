#include "io/config/config_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "message.h"
#include "models/model.h"
#include "temporary_folder.h"

namespace erg {

using forcing::WindInterval;
using io::config_text;
using io::parse_config;
using io::read_config;
using io::write_config;
using models::natural_spread;
using sim::Config;
using sim::model_keys;

namespace {

namespace fs = std::filesystem;

class ConfigFile : public ::testing::Test {
 protected:
  fs::path put(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    write_bytes(folder_ / name, text);
    return folder_ / name;
  }

  TemporaryFolder folder_;
};

std::string mistakes(const std::string& text) {
  return message([&] { parse_config(text, "a.json"); });
}

/// A valid config around one more line.
std::string mistakes_in(const std::string& line) {
  return mistakes("{\n\"erg\": 1,\n\"model\": \"momiji\",\n" + line + "\n}");
}

Config random_config(std::mt19937& random) {
  const std::vector<std::string> models = model_keys();
  const auto unit = [&] { return std::uniform_real_distribution<double>()(random); };
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  Config config(models[below(models.size())]);
  config.title = below(2) == 0 ? "" : "A \"title\"\n\u00e9\\";
  for (const sim::ConfigGroup& group : sim::config_groups()) {
    ParameterValues& values = config.*group.values;
    for (const Parameter& parameter : Parameters(values.declared())) {
      if (below(2) == 0) continue;
      const double number = parameter.minimum + unit() * (parameter.maximum - parameter.minimum);
      if (parameter.kind() == ParameterKind::real) values.set(parameter.key, number);
      if (parameter.kind() == ParameterKind::integer) values.set(parameter.key, static_cast<std::int64_t>(number));
      if (parameter.kind() == ParameterKind::boolean) values.set(parameter.key, below(2) == 0);
      if (parameter.kind() == ParameterKind::choice)
        values.set(parameter.key, parameter.choices[below(parameter.choices.size())]);
      if (parameter.kind() == ParameterKind::path) values.set(parameter.key, std::string("a/b c.png"));
    }
  }
  if (config.scene.text("kind") == "image") config.scene.set("image", std::string("ground.png"));
  if (const Parameter* wanted = wanted_path(config.parameters)) {
    config.parameters.set(std::string(wanted->key), std::string("plants.png"));
  }
  config.wind.intervals.assign(1 + below(3), WindInterval{});
  for (WindInterval& season : config.wind.intervals) {
    season.bearing = 360 * unit();
    season.first = 0.1 + 10 * unit();
    season.last = below(2) == 0 ? season.first : 0.1 + 10 * unit();
    season.steps = static_cast<std::int64_t>(1 + below(100));
    season.spread = below(2) == 0 ? 0 : 60 * unit();
    season.hold = static_cast<std::int64_t>(1 + below(9));
    if (below(2) == 0) season.curve = {{unit(), unit()}, {unit(), unit()}};
  }
  return config;
}

TEST_F(ConfigFile, OnlyVersionAndModelAreNeeded) {
  EXPECT_EQ(parse_config(R"({"erg": 1, "model": "werner"})", "a.json"), Config("werner"));
}

// What a file leaves out is as the model starts with it, so that its forms come out of it.
TEST_F(ConfigFile, WhatIsLeftOutIsAsTheModelStarts) {
  const Config bare = parse_config(R"({"erg": 1, "model": "grains"})", "a.json");
  EXPECT_EQ(bare, Config("grains"));
  EXPECT_EQ(bare.grid.real("cell_size"), 0.01);
  EXPECT_EQ(bare.scene.real("sand"), 200);
  EXPECT_EQ(bare.wind, forcing::WindSchedule::constant(270, 10));
  const Config south =
      parse_config(R"({"erg": 1, "model": "grains", "wind": {"seasons": [{"bearing": 180}, {"first": 7}]}})", "a.json");
  EXPECT_EQ(south.wind.intervals[0], (WindInterval{180, 10, 10, 1, {}}));
  EXPECT_EQ(south.wind.intervals[1], (WindInterval{270, 7, 7, 1, {}}));
  for (const std::string& model : model_keys()) {
    EXPECT_EQ(parse_config(config_text(Config(model)), "a.json"), Config(model)) << model;
  }
}

TEST_F(ConfigFile, ReadsEverything) {
  const Config config = parse_config(R"({
    "erg": 1, "title": "T", "description": "D.", "model": "bishop",
    "grid": {"nx": 100, "ny": 50, "cell_size": 0.5, "boundary": "open", "inflow": 2},
    "scene": {"kind": "cone", "sand": 1.5, "height": 3, "radius": 10},
    "parameters": {"p_sand": 0.5, "neighbours": 8, "polling": "nonrepeated", "forced_erosion": true},
    "wind": {"seasons": [{"bearing": "NE", "first": 5, "last": 8, "steps": 80, "curve": [[0.3, 0.1], [0.7, 0.9]]},
                         {"bearing": -90, "strength": 3, "steps": 2}]},
    "run": {"steps": 7, "seed": 9007199254740992, "executor": "serial", "threads": 3, "sweeps": 8}})",
                                     "a.json");
  EXPECT_EQ(config.title, "T");
  EXPECT_EQ(config.description, "D.");
  EXPECT_EQ(config.model, "bishop");
  EXPECT_EQ(config.grid.integer("ny"), 50);
  EXPECT_EQ(config.grid.real("inflow"), 2.0);
  EXPECT_EQ(config.scene.text("kind"), "cone");
  EXPECT_EQ(config.scene.real("sand"), 1.5);
  EXPECT_EQ(config.parameters.text("neighbours"), "8");
  EXPECT_TRUE(config.parameters.boolean("forced_erosion"));
  EXPECT_EQ(config.run.integer("seed"), std::int64_t{1} << 53);
  EXPECT_EQ(config.run.integer("sweeps"), 8);
  ASSERT_EQ(config.wind.intervals.size(), 2u);
  EXPECT_EQ(config.wind.intervals[0], (WindInterval{45, 5, 8, 80, {{0.3, 0.1}, {0.7, 0.9}}, 0, natural_spread}));
  EXPECT_EQ(config.wind.intervals[1], (WindInterval{270, 3, 3, 2, {}, 0, natural_spread}));
}

TEST_F(ConfigFile, OneEndOfTheStrengthStandsForBoth) {
  const Config config =
      parse_config(R"({"erg": 1, "model": "momiji", "wind": {"seasons": [{"first": 7}, {"last": 8}, {}]}})", "a.json");
  const std::vector<WindInterval>& seasons = config.wind.intervals;
  EXPECT_EQ(std::pair(seasons[0].first, seasons[0].last), std::pair(7.0, 7.0));
  EXPECT_EQ(std::pair(seasons[1].first, seasons[1].last), std::pair(8.0, 8.0));
  EXPECT_EQ(seasons[2], Config("momiji").wind.intervals.front());
}

TEST_F(ConfigFile, ASpreadStandsBesideAConstantWindOrInASeason) {
  const Config constant =
      parse_config(R"({"erg": 1, "model": "grains", "wind": {"bearing": "N", "spread": 25, "hold": 9}})", "a.json");
  EXPECT_EQ(constant.wind.intervals,
            (std::vector<WindInterval>{{.bearing = 0, .first = 10, .last = 10, .curve = {}, .spread = 25, .hold = 9}}));
  const Config seasons =
      parse_config(R"({"erg": 1, "model": "momiji", "wind": {"seasons": [{"spread": 0}, {"hold": 2}]}})", "a.json");
  EXPECT_EQ(seasons.wind.intervals, (std::vector<WindInterval>{{.curve = {}, .spread = 0},
                                                               {.curve = {}, .spread = natural_spread, .hold = 2}}));
  EXPECT_EQ(mistakes(R"({"erg": 1, "model": "momiji", "wind": {"spread": -1, "hold": 0.5}})"),
            "a.json:1: spread is -1; expected 0 to 60 °\n"
            "a.json:1: hold is 0.5; expected a whole number, 1 to 1000000000 steps");
}

TEST_F(ConfigFile, ReportsEveryMistakeAtOnceWhereItStands) {
  EXPECT_EQ(mistakes(R"({
  "erg": 2,
  "titel": "x",
  "model": "momji",
  "grid": {
    "nx": 0,
    "ny": "many",
    "nx": 5,
    "boundary": "toruss",
    "steps": 4
  },
  "scene": [],
  "parameters": {"p_snad": 0.5, "p_bare": 1.5,
    "forced_erosion": 1
  },
  "wind": {"bearing": "up", "strength": 1e300},
  "run": {"seed": 0.5,
          "threads": null}
})"),
            "a.json:2: erg is 2; this program reads version 1 of the format\n"
            "a.json:3: unknown key \"titel\"; did you mean \"title\"?\n"
            "a.json:4: unknown model \"momji\"; did you mean \"momiji\"?\n"
            "a.json:6: nx is 0; expected a whole number, 1 to 16384 cells\n"
            "a.json:7: ny is \"many\"; expected a whole number, 1 to 16384 cells\n"
            "a.json:8: duplicate key \"nx\"; it stands on line 6 already; keep one of the two\n"
            "a.json:9: unknown boundary \"toruss\"; did you mean \"torus\"?\n"
            "a.json:10: unknown key \"steps\"; it belongs in \"run\"\n"
            "a.json:12: scene is a list; expected an object, { ... }\n"
            "a.json:13: unknown key \"p_snad\"; did you mean \"p_sand\"?\n"
            "a.json:13: p_bare is 1.5; expected 0 to 1\n"
            "a.json:14: forced_erosion is 1; expected true or false\n"
            "a.json:16: bearing is \"up\"; expected -360 to 360 degrees, or a compass point such as W or NNE\n"
            "a.json:16: strength is 1e+300; expected 0 to 8192\n"
            "a.json:17: seed is 0.5; expected a whole number, 0 to 9007199254740992\n"
            "a.json:18: threads is null; expected a whole number, 0 to 256");
}

TEST_F(ConfigFile, SaysWhatIsMissing) {
  EXPECT_EQ(mistakes("{}"),
            "a.json:1: \"erg\", the version of the format, is missing; add \"erg\": 1\n"
            "a.json:1: \"model\" is missing; expected one of werner, momiji, bishop, nield_baas, snow_packing, "
            "snow_sintering, grains");
  EXPECT_EQ(mistakes("[]"), "a.json:1: a config is a list; expected an object, { ... }");
  EXPECT_EQ(mistakes("\n\n3"), "a.json:3: a config is 3; expected an object, { ... }");
  EXPECT_EQ(
      mistakes(R"({"erg": 1, "model": 7})"),
      "a.json:1: model is 7; expected one of werner, momiji, bishop, nield_baas, snow_packing, snow_sintering, grains");
  EXPECT_EQ(mistakes(R"({"erg": "1", "model": "momiji"})"),
            "a.json:1: erg is \"1\"; this program reads version 1 of the format");
  EXPECT_EQ(mistakes_in(R"("title": 5)"), "a.json:4: title is 5; expected text in double quotes");
}

TEST_F(ConfigFile, MistakesInTheWindTeach) {
  EXPECT_EQ(mistakes_in(R"("wind": {"seasons": []})"), "a.json:4: seasons is an empty list; give at least one season");
  EXPECT_EQ(mistakes_in(R"("wind": {"seasons": {}})"),
            "a.json:4: seasons is an object; expected a list of seasons, [{ ... }, { ... }]");
  EXPECT_EQ(mistakes_in("\"wind\": {\"bearing\": 3,\n\"seasons\": [{}, 5]}"),
            "a.json:4: \"bearing\" stands beside \"seasons\"; move it into each season\n"
            "a.json:5: a season is 5; expected an object, { ... }");
  EXPECT_EQ(mistakes_in(R"("wind": {"bearing": 361})"),
            "a.json:4: bearing is 361; expected -360 to 360 degrees, or a compass point such as W or NNE");
  EXPECT_EQ(
      mistakes_in(R"("wind": {"seasons": [{"strength": 3, "last": 4}]})"),
      "a.json:4: \"strength\" stands beside \"first\" or \"last\"; keep \"strength\" for one that does not change, "
      "else \"first\" and \"last\"");
  EXPECT_EQ(mistakes_in(R"("wind": {"seasons": [{"steps": 0, "first": -1, "beering": 4}]})"),
            "a.json:4: unknown key \"beering\"; did you mean \"bearing\"?\n"
            "a.json:4: first is -1; expected 0 to 8192\n"
            "a.json:4: steps is 0; expected a whole number, 1 to 1000000000");
  for (const char* curve :
       {"3", "[]", "[[0, 0]]", "[[0, 0], [1, 2]]", "[[0, 0], [1, \"1\"]]", "[[0, 0], [1, 1], [1, 1]]"}) {
    EXPECT_EQ(
        mistakes_in(std::string(R"("wind": {"seasons": [{"curve": )") + curve + "}]}"),
        "a.json:4: curve is not two points of the unit square; expected two control points, [[x, y], [x, y]], each "
        "number 0 to 1");
  }
  EXPECT_EQ(mistakes_in(R"("strength": 4)"), "a.json:4: unknown key \"strength\"; it belongs in \"wind\"");
}

TEST_F(ConfigFile, SyntaxErrorsHaveLineAndColumn) {
  EXPECT_EQ(mistakes(""), "a.json:1:1: syntax error: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(mistakes("{\n  \"erg\": 1,\n}"), "a.json:3:1: syntax error: unexpected '}'; remove the comma before it");
  EXPECT_EQ(mistakes("{\n  \"erg\": 1\n  \"model\": \"momiji\"}"),
            "a.json:3:9: syntax error: unexpected string literal; expected '}'");
  EXPECT_EQ(mistakes("{\"erg\": 1, \"model\": momiji}"), "a.json:1:21: syntax error: invalid literal");
  EXPECT_EQ(mistakes("{\"erg\": 1, \"model\": \"momiji\", \"run\": {\"steps\": 1e999}}"),
            "a.json:1:52: the number \"1e999\" is too large; write a number that a config accepts");
}

TEST_F(ConfigFile, MistakesBeforeASyntaxErrorAreReportedToo) {
  EXPECT_EQ(mistakes("{\"erg\": 1,\n\"modle\": 3,\n\"grid\": {\"nx\": 0, \"ny\": }"),
            "a.json:2: unknown key \"modle\"; did you mean \"model\"?\n"
            "a.json:3: nx is 0; expected a whole number, 1 to 16384 cells\n"
            "a.json:3:25: syntax error: unexpected '}'; expected '[', '{', or a literal");
}

TEST_F(ConfigFile, DeepNestingIsRefused) {
  const std::string deep(1'000'000, '[');
  EXPECT_EQ(mistakes("{\"model\": \"momiji\", \"wind\":\n" + deep),
            "a.json:2: wind is a list; expected an object, { ... }\na.json:2: lists and objects stand too deep inside "
            "each other; a config needs only a few levels");
}

// Each of these once took minutes or gibibytes.
TEST_F(ConfigFile, HugeNonsenseIsRefusedInAFewWords) {
  const auto many = [](const std::string& text, int times) {
    std::string all = text;
    for (int i = 1; i < times; ++i) all += "," + text;
    return all;
  };
  std::string keys = "\"a\": 1";
  for (int key = 0; key < 50'000; ++key) keys += ",\"k" + std::to_string(key) + "\":1";
  EXPECT_TRUE(mistakes_in(keys).ends_with("a.json: 49901 more mistakes; mend these first"));
  const std::string seasons = mistakes_in("\"wind\": {\"seasons\": [" + many("1", 300'000) + "]}");
  EXPECT_EQ(std::ranges::count(seasons, '\n'), 100) << seasons.substr(0, 1000);
  EXPECT_TRUE(seasons.ends_with("a.json: 299900 more mistakes; mend these first"));
  EXPECT_LT(mistakes_in("\"" + std::string(1'000'000, 'x') + "\": 1").size(), 300u);
  EXPECT_LT(mistakes("{\"erg\": 1, \"model\": \"" + std::string(1'000'000, 'w') + "\"}").size(), 300u);
  EXPECT_EQ(mistakes("{\"erg\": 1, \"model\": \"nield_baas\", \"parameters\": {\"grass_growth\": [" +
                     many("[1,2]", 10'000) + "]}}"),
            "a.json:1: grass_growth is 10000 vertices; expected 2 to 64 vertices x:y, x growing (balance, m/yr, -10 to "
            "10), y -10 to 10 1/yr");
}

TEST_F(ConfigFile, AFileWithoutEndIsRefused) {
  EXPECT_EQ(message([] { read_config("/dev/zero"); }),
            "/dev/zero: this file is too large; give a text of at most 16 MiB; is it the right one?");
}

TEST_F(ConfigFile, RoundTripsWithoutChange) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Config config = random_config(random);
    const std::string text = config_text(config);
    const Config back = parse_config(text, "a.json");
    EXPECT_EQ(back, config) << text;
    EXPECT_EQ(config_text(back), text);
  }
}

TEST_F(ConfigFile, SavesWhatDiffersAndWhatAReaderLooksFor) {
  Config config("momiji");
  config.title = "Small";
  config.grid.set("nx", std::int64_t{64});
  config.parameters.set("slab_height", 0.25);
  config.parameters.set("neighbours", std::string("8"));
  EXPECT_EQ(config_text(config), R"({
  "erg": 1,
  "title": "Small",
  "model": "momiji",
  "grid": {"nx": 64, "ny": 256},
  "scene": {"kind": "flat"},
  "parameters": {"slab_height": 0.25, "neighbours": 8},
  "wind": {"bearing": 270, "strength": 5},
  "run": {"steps": 1000, "seed": 0}
}
)");
}

TEST_F(ConfigFile, ASteadySeasonKeepsItsLength) {
  Config config;
  config.wind.intervals = {WindInterval{270, 5, 5, 80, {}}};
  EXPECT_EQ(parse_config(config_text(config), "a.json").wind, config.wind);
}

TEST_F(ConfigFile, DamagedTextNeverCrashes) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::string pool = "{}[]\",:0123456789.eE+-tfn \n\\u\xc3\xff";
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = config_text(random_config(random));
    for (std::size_t change = 1 + below(4); change > 0 && !text.empty(); --change) {
      const std::size_t at = below(text.size());
      switch (below(5)) {
        case 0:
          text[at] = pool[below(pool.size())];
          break;
        case 1:
          text.erase(at, 1 + below(8));
          break;
        case 2:
          text.insert(at, 1, pool[below(pool.size())]);
          break;
        case 3:
          text.insert(at, text.substr(below(text.size()), below(40)));
          break;
        default:
          text.resize(at);
          break;
      }
    }
    try {
      const Config config = parse_config(text, "a.json");
      EXPECT_EQ(parse_config(config_text(config), "again"), config) << text;
    } catch (const InputError& error) {
      ++refused;
      for (const Mistake& mistake : error.mistakes()) {
        EXPECT_TRUE(mistake.place.starts_with("a.json:")) << mistake.text();
        EXPECT_FALSE(mistake.problem.empty());
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST_F(ConfigFile, AMissingPictureIsReportedAtItsLine) {
  const std::string start = "{\"erg\": 1, \"model\": \"momiji\",\n\"scene\": {\"kind\": \"image\",\n\"image\": ";
  const fs::path path = put("a.json", start + "\"grond.png\", \"sand\": -1}}");
  put("ground.png", "");
  EXPECT_EQ(message([&] { read_config(path); }), path.string() + ":3: sand is -1; expected 0 to 10000 slabs\n" +
                                                     path.string() + ":3: there is no picture \"" +
                                                     (folder_ / "grond.png").string() + "\"; did you mean \"" +
                                                     (folder_ / "ground.png").string() + "\"?");
  EXPECT_EQ(mistakes("{\"erg\": 1, \"model\": \"momiji\",\n\"scene\": {\"kind\": \"image\"}}"),
            "a.json:2: kind \"image\" needs a picture; add \"image\": \"picture.png\" beside it");
}

TEST_F(ConfigFile, PicturesAreFoundFromTheConfigsFolder) {
  put("pictures/ground.png", "");
  const fs::path path = put("configs/a.json", R"({"erg": 1, "model": "momiji",
    "scene": {"kind": "image", "image": "../pictures/ground.png"}})");
  const Config config = read_config(path);
  EXPECT_EQ(config.scene.text("image"), (folder_ / "pictures/ground.png").string());
  const fs::path beside = folder_ / "pictures/b.json";
  write_config(beside, config);
  EXPECT_NE(read_bytes(beside).find("\"image\": \"ground.png\""), std::string::npos) << read_bytes(beside);
  EXPECT_EQ(read_config(beside), config);
}

TEST_F(ConfigFile, ARelativePictureStaysRelativeWhereverTheConfigGoes) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  put("pictures/ground.png", "");
  put("configs/a.json",
      R"({"erg": 1, "model": "momiji", "scene": {"kind": "image", "image": "../pictures/ground.png"}})");
  fs::create_directories("else/where");
  const Config config = read_config("configs/a.json");
  write_config("else/where/b.json", config);
  EXPECT_EQ(config.scene.text("image"), "pictures/ground.png");
  EXPECT_NE(read_bytes("else/where/b.json").find("\"../../pictures/ground.png\""), std::string::npos);
  EXPECT_EQ(read_config("else/where/b.json"), config);
  fs::current_path(before);
}

TEST_F(ConfigFile, FilesThatCannotBeReadAreExplained) {
  put("barchans.json", "");
  const fs::path wrong = folder_ / "barchan.json";
  EXPECT_EQ(message([&] { read_config(wrong); }),
            wrong.string() + ": there is no such file; did you mean \"" + (folder_ / "barchans.json").string() + "\"?");
  EXPECT_EQ(message([&] { read_config(folder_.path()); }),
            folder_.path().string() + ": this is a folder; give the name of a config file");
  EXPECT_EQ(message([&] { read_config("/nowhere/at/all"); }),
            "/nowhere/at/all: there is no such file; check its name and folder");
}

TEST_F(ConfigFile, ReplacesTheFileThatStoodThere) {
  const fs::path path = put("a.json", "old");
  write_config(path, Config());
  EXPECT_EQ(read_bytes(path), config_text(Config()));
}

TEST_F(ConfigFile, TheSchemaFollowsFromTheDeclarations) {
  const nlohmann::json schema = nlohmann::json::parse(io::config_schema());
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["properties"]["model"]["enum"], nlohmann::json(model_keys()));
  EXPECT_EQ(schema["allOf"].size(), model_keys().size());
  const auto expect_group = [](const nlohmann::json& group, const Parameters& declared) {
    EXPECT_EQ(group["properties"].size(), declared.size());
    EXPECT_EQ(group["additionalProperties"], false);
    for (const Parameter& parameter : declared) {
      const nlohmann::json& property = group["properties"][parameter.key];
      SCOPED_TRACE(parameter.key);
      EXPECT_EQ(property["title"], parameter.label);
      EXPECT_TRUE(property.contains("default"));
      const bool number = parameter.kind() == ParameterKind::real || parameter.kind() == ParameterKind::integer;
      ASSERT_EQ(property.contains("minimum"), number);
      if (!number) continue;
      EXPECT_EQ(property["minimum"].get<double>(), parameter.minimum);
      EXPECT_EQ(property["maximum"].get<double>(), parameter.maximum);
    }
  };
  expect_group(schema["properties"]["grid"], sim::grid_parameters());
  expect_group(schema["properties"]["scene"], sim::scene_parameters());
  expect_group(schema["properties"]["run"], sim::run_parameters());
  for (const models::ModelType& type : models::catalogue())
    expect_group(schema["$defs"][type.info.key], type.parameters);
}

}  // namespace
}  // namespace erg
