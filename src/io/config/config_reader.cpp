#include "io/config/config_reader.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "forcing/bearing.h"
#include "io/config/config_file.h"
#include "io/files/json_tree.h"
#include "models/model.h"

namespace erg::io {

using forcing::Channel;
using forcing::channels;
using forcing::constant_wind_columns;
using forcing::interval_of;
using forcing::WindInterval;
using sim::Config;
using sim::config_groups;
using sim::config_version;
using sim::ConfigGroup;

namespace {

/// A pair of numbers as a point; nothing for any other value.
std::optional<CurvePoint> point(const JsonNode& node) {
  const JsonNode::Array* pair = node.array();
  if (pair == nullptr || pair->size() != 2) return std::nullopt;
  const auto x = (*pair)[0].number();
  const auto y = (*pair)[1].number();
  if (!x || !y) return std::nullopt;
  return CurvePoint{*x + 0.0, *y + 0.0};  // turns -0 into 0
}

/// A list of pairs of numbers as a curve; nothing for any other value.
std::optional<ParameterValue> vertices(const JsonNode& node) {
  if (node.array() == nullptr) return std::nullopt;
  PiecewiseLinear curve;
  for (const JsonNode& entry : *node.array()) {
    const auto vertex = point(entry);
    if (!vertex) return std::nullopt;
    curve.vertices.push_back(*vertex);
  }
  return curve;
}

/// A JSON value as a parameter's value; nothing for null, objects, and lists that are no curve.
std::optional<ParameterValue> parameter_value(const Parameter& parameter, const JsonNode& node) {
  if (parameter.kind() == ParameterKind::curve) return vertices(node);
  if (parameter.kind() == ParameterKind::bezier) {
    const auto points = vertices(node);
    if (!points || std::get<PiecewiseLinear>(*points).vertices.size() != 2) return std::string();  // which is none
    const std::vector<CurvePoint>& two = std::get<PiecewiseLinear>(*points).vertices;
    return BezierCurve{two[0], two[1]};
  }
  if (const auto* flag = std::get_if<bool>(&node.value)) return *flag;
  if (const auto* real = std::get_if<double>(&node.value)) return *real;
  if (const std::string* text = node.text()) return *text;
  const auto* whole = std::get_if<std::int64_t>(&node.value);
  if (whole == nullptr) return std::nullopt;
  if (parameter.kind() == ParameterKind::choice) return std::to_string(*whole);  // a choice between numbers: 4 is "4"
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
    if (key == "seasons" || constant_wind_columns().find(key) != nullptr) return "it belongs in \"wind\"";
    return suggestion(key, known);
  }

  void read_root(const JsonNode::Object& root) {
    read_version(root);
    const bool model_known = read_model(root);
    std::vector<std::string> known{"erg", "title", "description", "model", "grid", "scene", "parameters", "wind"};
    for (const Channel& channel : channels()) {
      if (channel.over_run != nullptr) known.push_back(channel.declared.key);
    }
    known.emplace_back("run");
    check_keys(root, known);
    read_text(root, "title", config().title);
    read_text(root, "description", config().description);
    for (const ConfigGroup& group : config_groups()) {
      const JsonNode* node = find(root, group.key);
      if (node == nullptr || (group.key == "parameters" && !model_known)) continue;
      read_group(*node, group.key, config().*group.values);
    }
    if (const JsonNode* wind = find(root, "wind")) read_wind(*wind, model_known);
    for (const Channel& channel : channels()) {
      const JsonNode* node = channel.over_run != nullptr ? find(root, channel.declared.key) : nullptr;
      if (node == nullptr) continue;
      if (model_known) check_used(*node, channel);
      read_course(*node, channel);
    }
    check_picture(root, "scene", config().scene, reading_.image_line);
    check_picture(root, "parameters", config().parameters, reading_.model_image_line);
  }

  /// What the config's model declares; the default model's where none is named.
  const models::ModelInfo& info() { return models::find_model(config().model).info; }

  /// Reports a value of the weather that the model does not use.
  void check_used(const JsonNode& node, const Channel& channel) {
    if (forcing::uses_channel(info().channels, channel)) return;
    const Mistake mistake = sim::not_asked_for(channel.declared.key, config().model);
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
    values = read_values(*members, values.declarations());
  }

  /// The value if the parameter accepts it; else reports why not.
  std::optional<ParameterValue> checked(const Parameter& parameter, const JsonNode& node) {
    if (parameter.kind() == ParameterKind::rows) return checked_rows(parameter, node);
    if (parameter.notation != nullptr && node.text() != nullptr) return checked_text(parameter, node);
    const auto value = parameter_value(parameter, node);
    if (!value) {
      mistakes().add(node.line, parameter.key + " is " + node.shown(), "expected " + accepted_with_unit(parameter));
      return std::nullopt;
    }
    if (const auto mistake = check_value(parameter, *value, "")) {
      // A list that a syntax error cut short says nothing of what was meant.
      if (whole() || parameter.kind() != ParameterKind::bezier) {
        mistakes().add(node.line, mistake->problem, mistake->remedy);
      }
      return std::nullopt;
    }
    return value;
  }

  /// A number that people write in another way.
  std::optional<ParameterValue> checked_text(const Parameter& parameter, const JsonNode& node) {
    try {
      return parse_value(parameter, *node.text(), "");
    } catch (const InputError& error) {
      const Mistake& mistake = error.mistakes().front();
      mistakes().add(node.line, mistake.problem, mistake.remedy);
      return std::nullopt;
    }
  }

  /// The entries of a list of rows; null, and reported, where it is none or has none.
  const JsonNode::Array* entries(const JsonNode& node, const std::string& key, const std::string& row_name) {
    const JsonNode::Array* list = node.array();
    if (list == nullptr) {
      mistakes().add(node.line, key + " is " + node.shown(),
                     "expected a list of " + row_name + "s, [{ ... }, { ... }]");
    } else if (list->empty()) {
      if (whole()) mistakes().add(node.line, key + " is an empty list", "give at least one " + row_name);
      return nullptr;
    }
    return list;
  }

  /// One entry under its columns; those that are no object have the defaults.
  ParameterValues read_row(const JsonNode& node, const std::string& row_name, const Declarations& columns) {
    const JsonNode::Object* members = object(node, "a " + row_name);
    if (members == nullptr) return ParameterValues(columns);
    check_keys(*members, keys_of(columns));
    return read_values(*members, columns);
  }

  std::optional<ParameterValue> checked_rows(const Parameter& parameter, const JsonNode& node) {
    RowList list;
    if (node.array() == nullptr || !node.array()->empty() || parameter.minimum > 0) {
      const JsonNode::Array* rows = entries(node, parameter.key, parameter.row_name);
      if (rows == nullptr) return std::nullopt;
      const auto most = static_cast<std::size_t>(parameter.maximum);
      for (const JsonNode& row : *rows) {
        if (list.rows.size() <= most) list.rows.push_back(read_row(row, parameter.row_name, parameter.columns));
      }
    }
    if (const auto mistake = check_value(parameter, list, "")) {
      mistakes().add(node.line, mistake->problem, mistake->remedy);
      return std::nullopt;
    }
    return list;
  }

  /// Notes where a group names its picture, and reports one that is wanted but not named.
  void check_picture(const JsonNode::Object& root, const std::string& group, const ParameterValues& values, int& line) {
    const JsonNode* members = find(root, group);
    const Parameter* path = wanted_path(values);
    if (path == nullptr || members == nullptr || members->object() == nullptr) return;
    const JsonNode* given = find(*members->object(), path->key);
    if (given != nullptr) line = given->line;
    if (!whole() || (given != nullptr && (given->text() == nullptr || !given->text()->empty()))) return;
    const std::string& choice = path->active_if.front();
    const JsonNode* wanting = find(*members->object(), choice);
    mistakes().add(wanting != nullptr ? wanting->line : members->line,
                   choice + " " + quote(values.text(choice)) + " needs a picture",
                   "add \"" + path->key + "\": \"picture.png\" beside it");
  }

  void read_wind(const JsonNode& node, bool model_known) {
    const JsonNode::Object* wind = object(node, "wind");
    if (wind == nullptr) return;
    const WindInterval standard = sim::starting_wind(info().start).intervals.front();
    const Declarations constant = constant_wind_columns(standard);
    std::vector<std::string> known = keys_of(constant);
    known.emplace_back("seasons");
    check_keys(*wind, known);
    const JsonNode* seasons = find(*wind, "seasons");
    if (seasons == nullptr) {
      config().wind.intervals.front() = interval_of(read_values(*wind, constant));
      return;
    }
    for (const Parameter& column : constant) {
      const JsonNode* beside = find(*wind, column.key);
      if (beside == nullptr) continue;
      mistakes().add(beside->line, quote(column.key) + " stands beside \"seasons\"", "move it into each season");
    }
    const JsonNode::Array* list = entries(*seasons, "seasons", "season");
    if (list == nullptr) return;
    const Declarations columns = forcing::interval_columns(standard);
    config().wind.intervals.clear();
    for (const JsonNode& entry : *list) config().wind.intervals.push_back(read_interval(entry, columns, model_known));
  }

  WindInterval read_interval(const JsonNode& node, const Declarations& columns, bool model_known) {
    if (const JsonNode::Object* members = node.object()) {
      const JsonNode* same = find(*members, "strength");
      if (same != nullptr && (find(*members, "first") != nullptr || find(*members, "last") != nullptr)) {
        mistakes().add(same->line, "\"strength\" stands beside \"first\" or \"last\"",
                       "keep \"strength\" for one that does not change, else \"first\" and \"last\"");
      }
      for (const Channel& channel : channels()) {
        const JsonNode* given = channel.of_interval != nullptr ? find(*members, channel.declared.key) : nullptr;
        if (given != nullptr && model_known) check_used(*given, channel);
      }
    }
    return interval_of(read_row(node, "season", columns));
  }

  /// Those of the declared values that stand among the members; the others have their defaults.
  ParameterValues read_values(const JsonNode::Object& members, const Declarations& declared) {
    ParameterValues values(declared);
    for (const Parameter& parameter : declared) {
      const JsonNode* member = find(members, parameter.key);
      if (member == nullptr) continue;
      if (const auto value = checked(parameter, *member)) values.set(parameter.key, *value);
    }
    return values;
  }

  /// A number for a value that does not change over the run, or its two ends and the curve between them.
  void read_course(const JsonNode& node, const Channel& channel) {
    forcing::Course& course = config().weather.*channel.over_run;
    if (node.number()) {
      if (const auto value = checked(channel.declared, node)) course.first = course.last = *node.number() + 0.0;
      return;
    }
    const JsonNode::Object* members = object(node, channel.declared.key);
    if (members == nullptr) return;
    const Declarations columns = forcing::course_columns(channel);
    check_keys(*members, keys_of(columns));
    course = forcing::course_of(read_values(*members, columns));
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
