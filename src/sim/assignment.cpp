// One `--set`: finds what the key means and sets it.
#include <algorithm>
#include <optional>
#include <utility>

#include "core/join.h"
#include "core/number_text.h"
#include "models/model.h"
#include "sim/config.h"

namespace erg::sim {

using forcing::Channel;
using forcing::channels;
using forcing::Course;
using forcing::find_channel;
using forcing::set_in_interval;
using forcing::WindInterval;

namespace {

/// "seasons[2].bearing" in its parts.
struct RowKey {
  std::string list;
  std::size_t number = 0;  ///< from 1
  std::string column;
};

std::optional<RowKey> row_key(const std::string& key) {
  const std::size_t open = key.find('[');
  const std::size_t close = key.find("].", open);
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  const auto number = number_from<std::int64_t>(key.substr(open + 1, close - open - 1));
  if (!number || *number < 0) return std::nullopt;
  return RowKey{key.substr(0, open), static_cast<std::size_t>(*number), key.substr(close + 2)};
}

std::vector<std::string> keys_of(const Parameters& declared) {
  std::vector<std::string> keys;
  for (const Parameter& parameter : declared) keys.push_back(parameter.key);
  return keys;
}

class Assignment {
 public:
  Assignment(Config& config, const std::string& assignment) : config_(config), place_("--set " + assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError(place_, "not an assignment", "expected key=value, for example run.steps=500");
    }
    key_ = assignment.substr(0, equals);
    value_ = assignment.substr(equals + 1);
  }

  void apply() {
    if (key_ == "model") return set_model();
    if (key_ == "title") return void(config_.title = value_);
    if (key_ == "description") return void(config_.description = value_);
    for (const Channel& channel : channels()) {
      if (channel.over_run == nullptr) continue;
      const std::string& key = channel.declared.key;
      if (key_ != key && !key_.starts_with(key + ".")) continue;
      check_used(channel);
      Course& course = config_.weather.*channel.over_run;
      if (key_ == key) return void(course.first = course.last = number(channel.declared));
    }
    if (const auto row = row_key(key_)) return set_in_row(*row);
    const std::vector<std::string> matches = full_keys_matching();
    if (matches.empty()) throw InputError(place_, "unknown key " + quote(key_), suggestion(key_, possible_keys()));
    if (matches.size() > 1) {
      throw InputError(place_, quote(key_) + " is found in several groups", "say which: " + join(matches, " or "));
    }
    set(matches.front());
  }

 private:
  bool uses(const Channel& channel) const {
    return forcing::uses_channel(models::find_model(config_.model).info.channels, channel);
  }

  void check_used(const Channel& channel) const {
    if (uses(channel)) return;
    const Mistake mistake = not_asked_for(channel.declared.key, config_.model);
    throw InputError(place_, mistake.problem, mistake.remedy);
  }

  double number(const Parameter& parameter) const { return std::get<double>(parse_value(parameter, value_, place_)); }

  /// "grid.nx" ... of every value that can be set in a group.
  std::vector<std::string> full_keys() const {
    std::vector<std::string> keys;
    for (const Parameter& column : forcing::constant_wind_columns()) keys.push_back("wind." + column.key);
    for (const Channel& channel : channels()) {
      if (channel.over_run == nullptr || !uses(channel)) continue;
      for (const char* end : {".first", ".last"}) keys.push_back(channel.declared.key + end);
    }
    for (const ConfigGroup& group : config_groups()) {
      for (const Parameter& parameter : (config_.*group.values).declared()) {
        keys.push_back(group.key + "." + parameter.key);
      }
    }
    return keys;
  }

  /// Full keys that are `key_` or end in ".key_".
  std::vector<std::string> full_keys_matching() const {
    std::vector<std::string> matches;
    for (const std::string& full : full_keys()) {
      if (full == key_ || full.substr(full.find('.') + 1) == key_) matches.push_back(full);
    }
    return matches;
  }

  /// What the unknown key may have been meant as: full keys if it names a group, else bare ones.
  std::vector<std::string> possible_keys() const {
    std::vector<std::string> keys = full_keys();
    if (key_.find('.') != std::string::npos) return keys;
    for (std::string& key : keys) key.erase(0, key.find('.') + 1);
    keys.insert(keys.end(), {"model", "title", "description"});
    for (const Channel& channel : channels()) {
      if (channel.over_run != nullptr && uses(channel)) keys.push_back(channel.declared.key);
    }
    return keys;
  }

  void set_model() {
    const std::vector<std::string> keys = model_keys();
    if (std::ranges::find(keys, value_) == keys.end()) {
      throw InputError(place_, "unknown model " + quote(value_), suggestion(value_, keys));
    }
    change_model(config_, value_);
  }

  void set(const std::string& full_key) {
    const std::string group_key = full_key.substr(0, full_key.find('.'));
    const std::string key = full_key.substr(full_key.find('.') + 1);
    if (group_key == "wind") return set_wind(key);
    if (const Channel* channel = find_channel(group_key)) {
      Course& course = config_.weather.*channel->over_run;
      return void((key == "first" ? course.first : course.last) = number(channel->declared));
    }
    for (const ConfigGroup& group : config_groups()) {
      ParameterValues& values = config_.*group.values;
      if (group_key == group.key) values.set(key, parse_value(*values.find(key), value_, place_));
    }
  }

  /// Spread and hold of every season, the others of the only one.
  void set_wind(const std::string& key) {
    std::vector<WindInterval>& seasons = config_.wind.intervals;
    const bool of_every = key == "spread" || key == "hold";
    if (!of_every && seasons.size() != 1) {
      throw InputError(place_, "the wind has " + std::to_string(seasons.size()) + " seasons",
                       "change them in the config");
    }
    for (WindInterval& season : seasons) set_in_interval(season, key);
  }

  void set_in_interval(WindInterval& season, const std::string& key) {
    const Declarations columns = forcing::interval_columns();
    const Parameter* column = columns.find(key);
    if (column == nullptr) {
      throw InputError(place_, "unknown key " + quote(key), suggestion(key, keys_of(columns)));
    }
    const Channel* channel = find_channel(key);
    if (channel != nullptr) check_used(*channel);
    erg::forcing::set_in_interval(season, key, parse_value(*column, value_, place_));
  }

  void set_in_row(const RowKey& key) {
    if (key.list == "wind.seasons" || key.list == "seasons") {
      check_number(key, config_.wind.intervals.size(), "season");
      return set_in_interval(config_.wind.intervals[key.number - 1], key.column);
    }
    for (const ConfigGroup& group : config_groups()) {
      ParameterValues& values = config_.*group.values;
      for (const Parameter& parameter : values.declared()) {
        const bool meant = key.list == group.key + "." + parameter.key || key.list == parameter.key;
        if (!meant || parameter.kind() != ParameterKind::rows) continue;
        RowList list{values.rows(parameter.key)};
        check_number(key, list.rows.size(), parameter.row_name);
        ParameterValues& row = list.rows[key.number - 1];
        const Parameter* column = row.find(key.column);
        if (column == nullptr) {
          throw InputError(place_, "unknown key " + quote(key.column), suggestion(key.column, keys_of(row.declared())));
        }
        row.set(key.column, parse_value(*column, value_, place_));
        return values.set(parameter.key, std::move(list));
      }
    }
    throw InputError(place_, quote(key.list) + " is no list", "expected wind.seasons");
  }

  void check_number(const RowKey& key, std::size_t count, const std::string& row_name) const {
    if (key.number >= 1 && key.number <= count) return;
    throw InputError(place_, "there is no " + row_name + " " + std::to_string(key.number),
                     count == 0 ? "the list is empty" : "expected 1 to " + std::to_string(count));
  }

  Config& config_;
  std::string place_;
  std::string key_;
  std::string value_;
};

}  // namespace

void set_from_text(Config& config, const std::string& assignment) { Assignment(config, assignment).apply(); }

}  // namespace erg::sim
