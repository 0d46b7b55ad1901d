#include "session/comparison.h"
#include "core/number_text.h"

#include <algorithm>
#include <limits>
#include <set>

namespace erg::session {

using forcing::Channel;
using forcing::uses_channel;
using sim::Config;

namespace {

/// A value with its unit, or "-" where the model has none such.
std::string shown(const ParameterValues& values, const std::string& key) {
  const Parameter* parameter = values.find(key);
  if (parameter == nullptr) return "-";
  return value_text(values.value(key)) + (parameter->unit.empty() ? "" : " " + unit_text(parameter->unit));
}

bool all_same(const std::vector<std::string>& values) {
  return std::ranges::all_of(values, [&](const std::string& value) { return value == values.front(); });
}

}  // namespace

std::optional<std::size_t> Comparison::add_copy_of(std::size_t index) {
  if (size() >= most_runs) return std::nullopt;
  setups_.push_back(setups_.at(index));
  Setup& copy = setups_.back();
  const std::int64_t seed = copy.config().run.integer("seed");
  // At the largest seed there is no next one; then the copy keeps it.
  copy.set("run", "seed", seed + 1);
  return size() - 1;
}

bool Comparison::remove(std::size_t index) {
  if (size() < 2 || index >= size()) return false;
  if (index == 0) setups_[1].replace(with_wind(setups_[1].config()));
  setups_.erase(setups_.begin() + static_cast<std::ptrdiff_t>(index));
  return true;
}

void Comparison::set_only(Setup setup) {
  setups_.clear();
  setups_.push_back(std::move(setup));
}

std::vector<SetupDifference> Comparison::differences() const {
  std::vector<SetupDifference> found;
  const auto add = [&](const std::string& name, const std::string& label, const auto& value_of) {
    SetupDifference difference{name, label, {}};
    for (const Setup& setup : setups_) difference.values.push_back(value_of(setup));
    if (!all_same(difference.values)) found.push_back(std::move(difference));
  };
  add("model", "Model", [](const Setup& setup) { return setup.model().info.title; });
  for (const Channel& channel : forcing::channels()) {
    if (channel.over_run == nullptr) continue;  // all runs have the same seasons
    add(channel.declared.key, channel.declared.label, [&channel](const Setup& setup) -> std::string {
      if (!uses_channel(setup.model().info.channels, channel)) return "-";
      const forcing::Course& course = setup.config().weather.*channel.over_run;
      return value_text(course.first) + " to " + value_text(course.last) + " " + unit_text(channel.declared.unit);
    });
  }
  for (const sim::ConfigGroup& group : sim::config_groups()) {
    std::set<std::string> seen;
    for (const Setup& first : setups_) {
      for (const Parameter& parameter : (first.config().*group.values).declared()) {
        if (!seen.insert(parameter.key).second) continue;
        add(group.key + "." + parameter.key, parameter.label,
            [&](const Setup& setup) { return shown(setup.config().*group.values, parameter.key); });
      }
    }
  }
  return found;
}

bool Comparison::uses(const Channel& channel) const {
  return std::ranges::any_of(setups_,
                             [&](const Setup& setup) { return uses_channel(setup.model().info.channels, channel); });
}

Config Comparison::with_wind(Config config) const {
  config.wind = setups_.front().config().wind;
  return config;
}

std::vector<Config> Comparison::configs() const {
  std::vector<Config> all;
  for (std::size_t i = 0; i < size(); ++i) all.push_back(config(i));
  return all;
}

std::vector<Config> Comparison::configs_in_force(const Snapshot& snapshot) const {
  std::vector<Config> all;
  for (std::size_t i = 0; i < size(); ++i) all.push_back(setups_[i].in_force_on(*snapshot.runs.at(i).config));
  // One wind for all; where a run's model is about to change, it blows on as it did in all of them.
  const bool same_models = std::ranges::equal(setups_, snapshot.runs, [](const Setup& setup, const RunSnapshot& run) {
    return setup.config().model == run.config->model;
  });
  for (Config& config : all)
    config.wind = same_models ? setups_.front().config().wind : snapshot.runs.front().config->wind;
  return all;
}

std::vector<Config> Comparison::configs_to_create() {
  std::vector<Config> all;
  std::vector<Mistake> mistakes;
  for (std::size_t i = 0; i < size(); ++i) {
    try {
      all.push_back(with_wind(setups_[i].config_to_create()));
    } catch (const InputError& error) {
      for (Mistake mistake : error.mistakes()) {
        if (size() > 1) mistake.place = "run " + std::to_string(i + 1) + ", " + mistake.place;
        mistakes.push_back(std::move(mistake));
      }
    }
  }
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
  return all;
}

bool Comparison::needs_new_terrain(const Snapshot& snapshot) const {
  if (snapshot.runs.size() != size()) return true;
  for (std::size_t i = 0; i < size(); ++i) {
    if (setups_[i].needs_new_terrain(*snapshot.runs[i].config)) return true;
  }
  return false;
}

std::vector<ComparedNumber> compared_numbers(const Snapshot& snapshot) {
  std::vector<ComparedNumber> table;
  const std::vector<io::RunNumber>& numbers = io::run_numbers();
  for (std::size_t column = 0; column < numbers.size(); ++column) {
    ComparedNumber row{numbers[column], {}};
    for (const RunSnapshot& run : snapshot.runs) {
      const std::size_t rows = run.series->rows();
      row.values.push_back(rows == 0 ? std::numeric_limits<double>::quiet_NaN() : run.series->value(rows - 1, column));
    }
    table.push_back(std::move(row));
  }
  return table;
}

}  // namespace erg::session
