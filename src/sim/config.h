// Everything a run needs and nothing else: what a config file holds.
#pragma once

#include <string>
#include <vector>

#include "core/binding.h"
#include "core/terrain.h"
#include "forcing/channels.h"
#include "forcing/wind_schedule.h"
#include "models/model.h"

namespace erg::sim {

/// The version of the config format that this program writes; it reads this one.
inline constexpr int config_version = 1;

/// Declarations of the groups that are not a model's: their values stand under these keys in a config. Cell size and
/// sand have the defaults of the model that the config is of.
Parameters grid_parameters(const models::ModelDefaults& start = {});   ///< "grid": nx, ny, cell_size, boundary, inflow
Parameters scene_parameters(const models::ModelDefaults& start = {});  ///< "scene": kind and what each kind needs
Parameters run_parameters();  ///< "run": steps, seed, executor, threads, sweeps

/// The values of the group "run", for what works with them step by step: their declarations say what they mean.
struct RunValues {
  std::int64_t steps = 0;
  std::uint64_t seed = 0;
  std::string executor;
  int threads = 0;
  int sweeps = 16;
};
const Binding<RunValues>& run_binding();

/// The wind that a config has where it says nothing: one season, with the model's strength and spread.
forcing::WindSchedule starting_wind(const models::ModelDefaults& start);

/// One run, whole.
struct Config {
  /// A config of the default model with every value at its default.
  Config();
  /// The same for a model of the catalogue; throws InputError for an unknown key.
  explicit Config(const std::string& model_key);
  explicit Config(const models::ModelType& type);

  std::string title;
  std::string description;
  std::string model;  ///< key in the catalogue
  ParameterValues grid;
  ParameterValues scene;
  ParameterValues run;
  ParameterValues parameters;  ///< the model's own
  forcing::WindSchedule wind;
  forcing::Weather weather;  ///< channels over the run, for models that use them

  bool operator==(const Config&) const = default;
};

/// What is said against a value of the weather that this model does not use (ModelInfo::channels).
Mistake not_asked_for(const std::string& key, const std::string& model_key);

/// The names of the parameter groups in a config, in the order of a file: grid, scene, parameters, run.
struct ConfigGroup {
  std::string key;
  ParameterValues Config::*values;
};
const std::vector<ConfigGroup>& config_groups();

/// Changes the model. Values that were set (are not at their default) stay where the new model has the same parameter
/// and accepts them; all others take the new model's defaults. So do a single season's strength and any season's spread
/// where they are the old model's default. Throws InputError for an unknown key.
void change_model(Config& config, const std::string& model_key);

/// The keys of all models, in the catalogue's order.
std::vector<std::string> model_keys();

/// Sets one value from text, as `--set` does: "group.key=value" or "key=value" where the key is found in one group
/// only; "model=...", "wind.bearing=...", "wind.strength=..." (both for one season only), "wind.spread=...",
/// "wind.hold=..." (of every season), "wind.seasons[2].key=..." (of the second season), "temperature.first=...",
/// "temperature.last=..." and "temperature=..." (both; so for every channel over the run) too. Of a list of rows in a
/// group "group.list[2].key=...". Throws InputError.
void set_from_text(Config& config, const std::string& assignment);

}  // namespace erg::sim
