// Everything a run needs and nothing else: what a config file holds.
#pragma once

#include <string>
#include <vector>

#include "core/parameters.h"
#include "core/terrain.h"
#include "wind/regime.h"
#include "wind/temperature.h"

namespace erg {

/// The version of the config format that this program writes; it reads this one.
inline constexpr int config_version = 1;

/// Declarations of the groups that are not a model's: their values stand under these keys in a config.
Parameters grid_parameters();   ///< "grid": nx, ny, cell_size, boundary, inflow
Parameters scene_parameters();  ///< "scene": kind and what each kind needs
Parameters run_parameters();    ///< "run": steps, seed, executor, threads, sweeps

/// Declarations of what a season of the wind holds besides its bearing and curve.
Parameter strength_parameter();
Parameter season_steps_parameter();
Parameter season_snowfall_parameter();
/// Declaration of a temperature at either end of a run.
Parameter temperature_parameter();

/// One run, whole.
struct Config {
  /// A config of the default model with every value at its default.
  Config();
  /// The same for a model of the catalogue; throws InputError for an unknown key.
  explicit Config(const std::string& model_key);

  std::string title;
  std::string description;
  std::string model;  ///< key in the catalogue
  ParameterValues grid;
  ParameterValues scene;
  ParameterValues run;
  ParameterValues parameters;  ///< the model's own
  Regime wind;
  Temperature temperature;  ///< for snow models

  bool operator==(const Config&) const = default;
};

/// The names of the parameter groups in a config, in the order of a file: grid, scene, parameters, run.
struct ConfigGroup {
  std::string key;
  ParameterValues Config::*values;
};
const std::vector<ConfigGroup>& config_groups();

/// Changes the model. Values that were set (are not at their default) stay where the new model has the same parameter
/// and accepts them; all others take the new model's defaults. Cells, wind and sand that stand where the old model
/// starts go to where the new one does (ModelStart). Throws InputError for an unknown key.
void change_model(Config& config, const std::string& model_key);
/// Cells, wind and sand as the model starts with them.
void start_as_model(Config& config);

/// The keys of all models, in the catalogue's order.
std::vector<std::string> model_keys();

/// Sets one value from text, as `--set` does: "group.key=value" or "key=value" where the key is found in one group
/// only; "model=...", "wind.bearing=...", "wind.strength=...", "temperature.first=...",
/// "temperature.last=..." and "temperature=..." (both) too. Throws InputError.
void set_from_text(Config& config, const std::string& assignment);

}  // namespace erg
