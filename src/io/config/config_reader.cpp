#include "io/config/config_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "forcing/bearing.h"
#include "io/config/config_file.h"
#include "io/files/json_tree.h"
#include "models/model.h"

namespace erg::io {

using sim::Config;
using sim::config_groups;
using sim::config_version;
using sim::ConfigGroup;

namespace {

/// A list of pairs of numbers as a curve; nothing for any other value.
std::optional<ParameterValue> vertices(const JsonNode& node) {
  if (node.array() == nullptr) return std::nullopt;
  PiecewiseLinear curve;
  for (const JsonNode& entry : *node.array()) {
    const JsonNode::Array* pair = entry.array();
    if (pair == nullptr || pair->size() != 2) return std::nullopt;
    const auto x = (*pair)[0].number();
    const auto y = (*pair)[1].number();
    if (!x || !y) return std::nullopt;
    curve.vertices.push_back({*x + 0.0, *y + 0.0});  // turns -0 into 0
  }
  return curve;
}

/// A JSON value as a parameter's value; nothing for null, objects, and lists that are no curve.
std::optional<ParameterValue> parameter_value(const Parameter& parameter, const JsonNode& node) {
  if (parameter.kind == ParameterKind::curve) return vertices(node);
  if (const auto* flag = std::get_if<bool>(&node.value)) return *flag;
  if (const auto* real = std::get_if<double>(&node.value)) return *real;
  if (const std::string* text = node.text()) return *text;
  const auto* whole = std::get_if<std::int64_t>(&node.value);
  if (whole == nullptr) return std::nullopt;
  if (parameter.kind == ParameterKind::choice) return std::to_string(*whole);  // a choice between numbers: 4 is "4"
  return *whole;
}

std::vector<std::string> keys_of(const Parameters& declared) {
  std::vector<std::string> keys;
  for (const Parameter& parameter : declared) keys.push_back(parameter.key);
  return keys;
}

class ConfigReader {
 public:
  ConfigReader(std::string_view text, const std::string& name)
      : tree_(read_json(text, name)), reading_{{}, MistakeList(name)} {}

  ConfigReading read() {
    const JsonNode::Object* root = object(tree_.root, "a config");
    if (root != nullptr) read_root(*root);
    if (tree_.broken) mistakes().add_last(*tree_.broken);
    reading_.has_comments = tree_.has_comments;
    return std::move(reading_);
  }

 private:
  MistakeList& mistakes() { return reading_.mistakes; }
  Config& config() { return reading_.config; }

  /// With a syntax error the end of the text is unknown, so nothing can be said to be missing.
  bool whole() const { return !tree_.broken; }

  const JsonNode::Object* object(const JsonNode& node, const std::string& what) {
    const bool nothing_read = !whole() && std::holds_alternative<std::monostate>(node.value);
    if (node.object() == nullptr && !nothing_read) {
      mistakes().add(node.line, what + " is " + node.shown(), "expected an object, { ... }");
    }
    return node.object();
  }

  static const JsonNode* find(const JsonNode::Object& object, std::string_view key) {
    const auto member = std::ranges::find(object, key, &JsonMember::key);
    return member == object.end() ? nullptr : &member->node;
  }

  /// Reports keys that are not among `known` and keys that stand twice.
  void check_keys(const JsonNode::Object& object, const std::vector<std::string>& known) {
    std::map<std::string_view, int> lines;
    for (const JsonMember& member : object) {
      const auto [first, is_new] = lines.emplace(member.key, member.line);
      if (!is_new) {
        mistakes().add(member.line, "duplicate key " + quote(member.key),
                       "it stands on line " + std::to_string(first->second) + " already; keep one of the two");
      } else if (std::ranges::find(known, member.key) == known.end()) {
        mistakes().add(member.line, "unknown key " + quote(member.key), better_key(member.key, known));
      }
    }
  }

  /// Where an unknown key belongs, or the known key that it was most likely meant as.
  std::string better_key(const std::string& key, const std::vector<std::string>& known) {
    for (const ConfigGroup& group : config_groups()) {
      if ((config().*group.values).find(key) != nullptr) return "it belongs in \"" + group.key + "\"";
    }
    if (key == "bearing" || key == "strength" || key == "spread" || key == "hold" || key == "seasons")
      return "it belongs in \"wind\"";
    return suggestion(key, known);
  }

  void read_root(const JsonNode::Object& root) {
    read_version(root);
    const bool model_known = read_model(root);
    check_keys(root,
               {"erg", "title", "description", "model", "grid", "scene", "parameters", "wind", "temperature", "run"});
    read_text(root, "title", config().title);
    read_text(root, "description", config().description);
    for (const ConfigGroup& group : config_groups()) {
      const JsonNode* node = find(root, group.key);
      if (node == nullptr || (group.key == "parameters" && !model_known)) continue;
      read_group(*node, group.key, config().*group.values);
    }
    if (const JsonNode* wind = find(root, "wind")) read_wind(*wind, !model_known || info().asks_snowfall);
    if (const JsonNode* temperature = find(root, "temperature")) {
      check_asked_for(*temperature, "temperature", !model_known || info().asks_temperature);
      read_temperature(*temperature);
    }
    check_picture(root, "scene", config().scene, reading_.image_line);
    check_picture(root, "parameters", config().parameters, reading_.model_image_line);
  }

  /// What the config's model declares; the default model's where none is named.
  const ModelInfo& info() { return find_model(config().model).info; }

  /// Reports a value of the weather that the model does not ask for.
  void check_asked_for(const JsonNode& node, const std::string& key, bool asked) {
    if (asked) return;
    const Mistake mistake = sim::not_asked_for(key, config().model);
    mistakes().add(node.line, mistake.problem, mistake.remedy);
  }

  void read_version(const JsonNode::Object& root) {
    const std::string version = std::to_string(config_version);
    const JsonNode* node = find(root, "erg");
    if (node == nullptr) {
      if (whole())
        mistakes().add(tree_.root.line, "\"erg\", the version of the format, is missing", "add \"erg\": " + version);
    } else if (node->number() != static_cast<double>(config_version)) {
      mistakes().add(node->line, "erg is " + node->shown(), "this program reads version " + version + " of the format");
    }
  }

  /// Makes the config one of the model asked for. With an unknown model it takes the one most likely meant, so that its
  /// parameters are checked all the same; false if there is none.
  bool read_model(const JsonNode::Object& root) {
    const std::vector<std::string> keys = sim::model_keys();
    const JsonNode* node = find(root, "model");
    if (node == nullptr) {
      if (whole()) mistakes().add(tree_.root.line, "\"model\" is missing", suggestion("", keys));
      return false;
    }
    if (node->text() == nullptr) {
      mistakes().add(node->line, "model is " + node->shown(), suggestion("", keys));
      return false;
    }
    std::string key = *node->text();
    if (std::ranges::find(keys, key) == keys.end()) {
      mistakes().add(node->line, "unknown model " + quote(key), suggestion(key, keys));
      key = nearest_word(key, keys);
    }
    if (key.empty()) return false;
    config() = Config(key);
    return true;
  }

  void read_text(const JsonNode::Object& root, const std::string& key, std::string& text) {
    const JsonNode* node = find(root, key);
    if (node == nullptr) return;
    if (node->text() != nullptr) {
      text = *node->text();
    } else {
      mistakes().add(node->line, key + " is " + node->shown(), "expected text in double quotes");
    }
  }

  void read_group(const JsonNode& node, const std::string& group, ParameterValues& values) {
    const JsonNode::Object* members = object(node, group);
    if (members == nullptr) return;
    check_keys(*members, keys_of(values.declared()));
    values = read_values(*members, values.declared());
  }

  /// The value if the parameter accepts it; else reports why not.
  std::optional<ParameterValue> checked(const Parameter& parameter, const JsonNode& node) {
    const auto value = parameter_value(parameter, node);
    if (!value) {
      mistakes().add(node.line, parameter.key + " is " + node.shown(), "expected " + accepted_with_unit(parameter));
      return std::nullopt;
    }
    if (const auto mistake = check_value(parameter, *value, "")) {
      mistakes().add(node.line, mistake->problem, mistake->remedy);
      return std::nullopt;
    }
    return value;
  }

  /// Notes where a group names its picture, and reports one that is wanted but not named.
  void check_picture(const JsonNode::Object& root, const std::string& group, const ParameterValues& values, int& line) {
    const JsonNode* members = find(root, group);
    const Parameter* path = wanted_path(values);
    if (path == nullptr || members == nullptr || members->object() == nullptr) return;
    const JsonNode* given = find(*members->object(), path->key);
    if (given != nullptr) line = given->line;
    if (!whole() || (given != nullptr && (given->text() == nullptr || !given->text()->empty()))) return;
    const std::string& choice = path->only_when.front();
    const JsonNode* wanting = find(*members->object(), choice);
    mistakes().add(wanting != nullptr ? wanting->line : members->line,
                   choice + " " + quote(values.text(choice)) + " needs a picture",
                   "add \"" + path->key + "\": \"picture.png\" beside it");
  }

  /// `snows`: whether seasons may have snowfall.
  void read_wind(const JsonNode& node, bool snows) {
    const JsonNode::Object* wind = object(node, "wind");
    if (wind == nullptr) return;
    check_keys(*wind, {"bearing", "strength", "spread", "hold", "seasons"});
    const JsonNode* seasons = find(*wind, "seasons");
    if (seasons == nullptr) {
      Season& season = config().wind.seasons.front();
      read_bearing(*wind, season);
      read_strength(*wind, "strength", season.first);
      season.last = season.first;
      read_swing(*wind, season);
      return;
    }
    for (const char* key : {"bearing", "strength", "spread", "hold"}) {
      const JsonNode* beside = find(*wind, key);
      if (beside == nullptr) continue;
      mistakes().add(beside->line, quote(key) + " stands beside \"seasons\"", "move it into each season");
    }
    read_seasons(*seasons, snows);
  }

  void read_seasons(const JsonNode& node, bool snows) {
    const JsonNode::Array* list = node.array();
    if (list == nullptr) {
      mistakes().add(node.line, "seasons is " + node.shown(), "expected a list of seasons, [{ ... }, { ... }]");
      return;
    }
    if (list->empty()) {
      if (whole()) mistakes().add(node.line, "seasons is an empty list", "give at least one season");
      return;
    }
    config().wind.seasons.clear();
    for (const JsonNode& entry : *list) config().wind.seasons.push_back(read_season(entry, snows));
  }

  Season read_season(const JsonNode& node, bool snows) {
    Season season = sim::starting_wind(info().start).seasons.front();
    const JsonNode::Object* members = object(node, "a season");
    if (members == nullptr) return season;
    check_keys(*members, {"bearing", "strength", "first", "last", "spread", "hold", "steps", "curve", "snowfall"});
    read_bearing(*members, season);
    read_strengths(*members, season);
    if (const JsonNode* snowfall = find(*members, "snowfall")) check_asked_for(*snowfall, "snowfall", snows);
    read_swing(*members, season);
    const ParameterValues values =
        read_values(*members, {sim::season_steps_parameter(), sim::season_snowfall_parameter()});
    season.steps = values.integer("steps");
    season.snowfall = values.real("snowfall");
    if (const JsonNode* curve = find(*members, "curve")) read_curve(*curve, season.curve);
    return season;
  }

  void read_swing(const JsonNode::Object& members, Season& season) {
    const ParameterValues values =
        read_values(members, {sim::season_spread_parameter(info().start), sim::season_hold_parameter()});
    season.spread = values.real("spread");
    season.hold = values.integer("hold");
  }

  /// Those of the declared values that stand among the members; the others have their defaults.
  ParameterValues read_values(const JsonNode::Object& members, const Parameters& declared) {
    ParameterValues values(declared);
    for (const Parameter& parameter : declared) {
      const JsonNode* member = find(members, parameter.key);
      if (member == nullptr) continue;
      if (const auto value = checked(parameter, *member)) values.set(parameter.key, *value);
    }
    return values;
  }

  /// A number for a temperature that does not change, or its two ends and the curve between them.
  void read_temperature(const JsonNode& node) {
    Temperature& temperature = config().temperature;
    if (node.number()) {
      read_degrees(node, "temperature", temperature.first);
      temperature.last = temperature.first;
      return;
    }
    const JsonNode::Object* members = object(node, "temperature");
    if (members == nullptr) return;
    check_keys(*members, {"first", "last", "curve"});
    const JsonNode* first = find(*members, "first");
    const JsonNode* last = find(*members, "last");
    if (first != nullptr) read_degrees(*first, "first", temperature.first);
    temperature.last = temperature.first;
    if (last != nullptr) read_degrees(*last, "last", temperature.last);
    if (const JsonNode* curve = find(*members, "curve")) read_curve(*curve, temperature.curve);
  }

  void read_degrees(const JsonNode& node, const std::string& key, double& temperature) {
    Parameter parameter = sim::temperature_parameter();
    parameter.key = key;
    ParameterValues values({parameter});
    if (const auto value = checked(parameter, node)) values.set(key, *value);
    temperature = values.real(key);
  }

  void read_strengths(const JsonNode::Object& members, Season& season) {
    const JsonNode* same = find(members, "strength");
    const JsonNode* first = find(members, "first");
    const JsonNode* last = find(members, "last");
    if (same != nullptr && (first != nullptr || last != nullptr)) {
      mistakes().add(same->line, "\"strength\" stands beside \"first\" or \"last\"",
                     "keep \"strength\" for one that does not change, else \"first\" and \"last\"");
    }
    read_strength(members, "strength", season.first);
    season.last = season.first;
    read_strength(members, "first", season.first);
    read_strength(members, "last", season.last);
    // One end alone means a strength that does not change.
    if (first != nullptr && last == nullptr) season.last = season.first;
    if (last != nullptr && first == nullptr) season.first = season.last;
  }

  void read_strength(const JsonNode::Object& members, const std::string& key, double& strength) {
    const JsonNode* node = find(members, key);
    if (node == nullptr) return;
    Parameter parameter = sim::strength_parameter(info().start);
    parameter.key = key;
    ParameterValues values({parameter});
    if (const auto value = checked(parameter, *node)) values.set(key, *value);
    strength = values.real(key);
  }

  void read_bearing(const JsonNode::Object& members, Season& season) {
    const JsonNode* node = find(members, "bearing");
    if (node == nullptr) return;
    if (const std::string* text = node->text()) {
      try {
        season.bearing = parse_bearing(*text, "");
      } catch (const InputError& error) {
        const Mistake& mistake = error.mistakes().front();
        mistakes().add(node->line, mistake.problem, mistake.remedy);
      }
      return;
    }
    const std::optional<double> number = node->number();
    if (number && std::abs(*number) <= largest_bearing) {
      season.bearing = fold_bearing(*number);
    } else {
      mistakes().add(node->line, "bearing is " + node->shown(), std::string("expected ") + accepted_bearings);
    }
  }

  static std::optional<CurvePoint> curve_point(const JsonNode& node) {
    const JsonNode::Array* pair = node.array();
    if (pair == nullptr || pair->size() != 2) return std::nullopt;
    const auto x = (*pair)[0].number();
    const auto y = (*pair)[1].number();
    const auto fits = [](std::optional<double> number) { return number && *number >= 0 && *number <= 1; };
    if (!fits(x) || !fits(y)) return std::nullopt;
    return CurvePoint{*x + 0.0, *y + 0.0};  // turns -0 into 0
  }

  void read_curve(const JsonNode& node, BezierCurve& curve) {
    const JsonNode::Array* points = node.array();
    const bool two = points != nullptr && points->size() == 2;
    const auto first = two ? curve_point(points->front()) : std::nullopt;
    const auto second = two ? curve_point(points->back()) : std::nullopt;
    if (first && second) {
      curve = {*first, *second};
    } else if (whole()) {
      mistakes().add(node.line, "curve is not two points of the unit square",
                     "expected two control points, [[x, y], [x, y]], each number 0 to 1");
    }
  }

  JsonTree tree_;
  ConfigReading reading_;
};

}  // namespace

void MistakeList::add(int line, std::string problem, std::string remedy) {
  if (found_.size() >= most_told) {
    ++untold_;
    return;
  }
  found_.push_back({line, {place(line), std::move(problem), std::move(remedy)}});
}

void MistakeList::add_last(Mistake mistake) { found_.push_back({std::numeric_limits<int>::max(), std::move(mistake)}); }

void MistakeList::throw_if_any() const {
  if (found_.empty()) return;
  auto sorted = found_;
  std::ranges::stable_sort(sorted, {}, [](const auto& entry) { return entry.first; });
  std::vector<Mistake> mistakes;
  for (auto& [line, mistake] : sorted) mistakes.push_back(std::move(mistake));
  if (untold_ > 0) mistakes.push_back({name_, std::to_string(untold_) + " more mistakes", "mend these first"});
  throw InputError(std::move(mistakes));
}

ConfigReading read_config_text(std::string_view text, const std::string& name) {
  return ConfigReader(text, name).read();
}

}  // namespace erg::io
