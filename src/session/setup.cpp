#include "session/setup.h"

#include <algorithm>
#include <filesystem>
#include <random>

#include "io/checkpoint/start_simulation.h"
#include "sim/simulation.h"
#include "sim/step_time.h"

namespace erg::session {

using models::ModelType;
using sim::Config;
using sim::config_groups;
using sim::ConfigGroup;

namespace {

/// Seeds that are drawn stay short enough to be written down.
constexpr std::int64_t largest_drawn_seed = 999'999'999;

std::int64_t drawn_seed() {
  std::random_device device;
  return std::uniform_int_distribution<std::int64_t>(1, largest_drawn_seed)(device);
}

const ParameterValues* group_of(const Config& config, const std::string& key) {
  for (const ConfigGroup& group : config_groups()) {
    if (group.key == key) return &(config.*group.values);
  }
  return nullptr;
}

}  // namespace

std::string SetupRow::tooltip() const {
  std::string text = parameter->meaning;
  text += "\nAccepts " + accepted_with_unit(*parameter);
  text += "; default " + value_text(parameter->default_value) + ".";
  if (!parameter->source.empty()) text += "\nSource: " + parameter->source + ".";
  text += needs_new_terrain ? "\nTakes effect with CREATE." : "\nTakes effect at the next step.";
  return text;
}

std::vector<const ModelType*> Setup::models_of(Material material) {
  std::vector<const ModelType*> found;
  for (const ModelType& type : models::catalogue()) {
    if (type.info.material == material) found.push_back(&type);
  }
  return found;
}

Material Setup::material() const { return model().info.material; }

void Setup::choose_material(Material material) {
  if (material == this->material()) return;
  const std::vector<const ModelType*> models = models_of(material);
  if (!models.empty()) choose_model(models.front()->info.key);
}

const ModelType& Setup::model() const { return models::find_model(config_.model); }

void Setup::choose_model(const std::string& key) {
  sim::change_model(config_, key);
  config_.title = has_its_own_model() ? named_.title : "";
  config_.description = has_its_own_model() ? named_.description : "";
}

std::vector<SetupRow> Setup::rows(const std::string& group, const Config* running) const {
  std::vector<SetupRow> found;
  const ParameterValues* values = group_of(config_, group);
  if (values == nullptr) return found;
  const ParameterValues* in_force = running != nullptr ? group_of(*running, group) : nullptr;
  for (const Parameter& parameter : values->declared()) {
    SetupRow row;
    row.group = group;
    row.parameter = &parameter;
    row.value = values->value(parameter.key);
    row.changed = !values->is_default(parameter.key);
    row.relevant = values->is_active(parameter);
    row.needs_new_terrain = parameter.at_start;
    row.pending = in_force != nullptr &&
                  (in_force->find(parameter.key) == nullptr || in_force->value(parameter.key) != row.value);
    found.push_back(std::move(row));
  }
  return found;
}

ParameterValues* Setup::group(const std::string& key) { return const_cast<ParameterValues*>(group_of(config_, key)); }

std::optional<Mistake> Setup::set(const std::string& group, const std::string& key, const ParameterValue& value) {
  ParameterValues* values = this->group(group);
  if (values == nullptr) return Mistake{group, "there is no such group", ""};
  try {
    values->set(key, value);
  } catch (const InputError& error) {
    return error.mistakes().front();
  }
  return std::nullopt;
}

std::optional<Mistake> Setup::set_text(const std::string& group, const std::string& key, std::string_view text) {
  const ParameterValues* values = this->group(group);
  const Parameter* parameter = values == nullptr ? nullptr : values->find(key);
  if (parameter == nullptr) return Mistake{group + "." + key, "there is no such value", ""};
  try {
    return set(group, key, parse_value(*parameter, text, parameter->label));
  } catch (const InputError& error) {
    return error.mistakes().front();
  }
}

void Setup::reset(const std::string& group, const std::string& key) {
  ParameterValues* values = this->group(group);
  if (values == nullptr) return;
  if (values->find(key) != nullptr) values->reset(key);
}

void Setup::reset_all() {
  Config fresh(config_.model);
  fresh.title = config_.title;
  fresh.description = config_.description;
  config_ = std::move(fresh);
  fresh_seed_ = false;
}

std::vector<std::string> Setup::explanations() const { return sim::explain(config_); }

std::vector<Mistake> Setup::mistakes() const {
  std::vector<Mistake> found;
  for (const ParameterValues* values : {&config_.scene, &config_.parameters}) {
    const Parameter* picture = wanted_path(*values);
    if (picture == nullptr) continue;
    const std::string& path = values->text(picture->key);
    std::error_code failed;
    if (path.empty()) {
      found.push_back({picture->label, "no picture is chosen", "choose one"});
    } else if (!std::filesystem::is_regular_file(path, failed)) {
      found.push_back({picture->label, "there is no picture " + quote(path), "choose another"});
    }
  }
  return found;
}

std::optional<Mistake> Setup::set_course(const forcing::Channel& channel, const forcing::Course& course) {
  try {
    forcing::row_of(course, channel);
  } catch (const InputError& error) {
    Mistake mistake = error.mistakes().front();
    mistake.place = channel.declared.key;
    return mistake;
  }
  config_.weather.*channel.over_run = course;
  return std::nullopt;
}

bool Setup::needs_new_terrain(const Config& running) const { return erg::sim::needs_new_terrain(running, config_); }

Config Setup::in_force_on(const Config& running) const {
  Config result = running;
  if (running.model != config_.model) return result;
  result.title = config_.title;
  result.description = config_.description;
  result.wind = config_.wind;
  result.weather = config_.weather;
  for (const ConfigGroup& group : config_groups()) {
    for (const Parameter& parameter : (config_.*group.values).declared()) {
      if (parameter.at_start) continue;
      (result.*group.values).set(parameter.key, (config_.*group.values).value(parameter.key));
    }
  }
  return result;
}

Config Setup::config_to_create() {
  if (auto found = mistakes(); !found.empty()) throw InputError(std::move(found));
  io::take_grid_from_picture(config_);
  if (fresh_seed_) config_.run.set("seed", drawn_seed());
  return config_;
}

}  // namespace erg::session
