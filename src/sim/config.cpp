#include "sim/config.h"

#include <algorithm>
#include <utility>

#include "core/join.h"
#include "forcing/bearing.h"
#include "models/model.h"
#include "transport/executor.h"

namespace erg::sim {
namespace {

constexpr const char* default_model = "momiji";
/// Heights of a picture, m: from the deepest trench to the highest volcano of Mars, and some.
constexpr double lowest_point = -12000;
constexpr double highest_point = 30000;

/// Marks all of a group as read only when the terrain is made.
Parameters all_at_start(Parameters parameters) {
  for (Parameter& parameter : parameters) parameter.at_start = true;
  return parameters;
}

/// One `--set`: finds what the key means and sets it.
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
    const bool of_temperature = key_ == "temperature" || key_.starts_with("temperature.");
    if (of_temperature && !asks_temperature()) {
      const Mistake mistake = not_asked_for("temperature", config_.model);
      throw InputError(place_, mistake.problem, mistake.remedy);
    }
    if (key_ == "temperature") return void(config_.temperature.first = config_.temperature.last = temperature());
    const std::vector<std::string> matches = full_keys_matching();
    if (matches.empty()) throw InputError(place_, "unknown key " + quote(key_), suggestion(key_, possible_keys()));
    if (matches.size() > 1) {
      throw InputError(place_, quote(key_) + " is found in several groups", "say which: " + join(matches, " or "));
    }
    set(matches.front());
  }

 private:
  bool asks_temperature() const { return find_model(config_.model).info.asks_temperature; }

  /// "grid.nx" ... of every value that can be set in a group.
  std::vector<std::string> full_keys() const {
    std::vector<std::string> keys{"wind.bearing", "wind.strength", "wind.spread", "wind.hold"};
    if (asks_temperature()) keys.insert(keys.end(), {"temperature.first", "temperature.last"});
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
    if (asks_temperature()) keys.emplace_back("temperature");
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
    const std::string key = full_key.substr(full_key.find('.') + 1);
    if (full_key.starts_with("wind.")) return set_wind(key);
    if (full_key.starts_with("temperature.")) {
      return void((key == "first" ? config_.temperature.first : config_.temperature.last) = temperature());
    }
    for (const ConfigGroup& group : config_groups()) {
      ParameterValues& values = config_.*group.values;
      if (full_key == group.key + "." + key) values.set(key, parse_value(*values.find(key), value_, place_));
    }
  }

  void set_wind(const std::string& key) {
    if (key == "spread") {
      const double spread = std::get<double>(parse_value(season_spread_parameter(), value_, place_));
      for (Season& season : config_.wind.seasons) season.spread = spread;
      return;
    }
    if (key == "hold") {
      const auto hold = std::get<std::int64_t>(parse_value(season_hold_parameter(), value_, place_));
      for (Season& season : config_.wind.seasons) season.hold = hold;
      return;
    }
    if (config_.wind.seasons.size() != 1) {
      throw InputError(place_, "the wind has " + std::to_string(config_.wind.seasons.size()) + " seasons",
                       "change them in the config");
    }
    Season& season = config_.wind.seasons.front();
    if (key == "bearing") {
      season.bearing = parse_bearing(value_, place_);
    } else {
      season.first = season.last = std::get<double>(parse_value(strength_parameter(), value_, place_));
    }
  }

  double temperature() const { return std::get<double>(parse_value(temperature_parameter(), value_, place_)); }

  Config& config_;
  std::string place_;
  std::string key_;
  std::string value_;
};

}  // namespace

Parameter strength_parameter(const ModelStart& start) {
  return real_parameter(
      "strength", "Strength", "", start.strength, smallest_strength, largest_strength,
      "Strength of the wind: cells a hop for slab models, m/s for the others. 0 is a calm: time passes, and "
      "the wind moves nothing.");
}

Parameter season_spread_parameter(const ModelStart& start) {
  return real_parameter("spread", "Spread", "deg", start.spread, 0, widest_spread,
                        "How much the wind swings about its bearing: standard deviation from draw to draw.");
}

Parameter season_hold_parameter() {
  return integer_parameter("hold", "Hold", "steps", Season{}.hold, 1, most_steps,
                           "Time steps of the season for which the wind stays in one direction before it swings to "
                           "the next.");
}

Parameter season_steps_parameter() {
  return integer_parameter("steps", "Steps", "", Season{}.steps, 1, most_steps, "Time steps that the season lasts.");
}

Parameter season_snowfall_parameter() {
  return real_parameter("snowfall", "Snowfall", "mm/h", Season{}.snowfall, 0, heaviest_snowfall,
                        "Snow that falls during the season, as it lies; for models that let it fall.");
}

Parameter temperature_parameter() {
  return real_parameter("temperature", "Temperature", "deg C", Temperature{}.first, lowest_temperature,
                        highest_temperature, "Temperature of air and snow; for models that ask for it.");
}

Parameters grid_parameters(const ModelStart& start) {
  return all_at_start({
      integer_parameter("nx", "Cells east", "cells", 256, smallest_side, largest_side, "Grid width, west to east."),
      integer_parameter("ny", "Cells north", "cells", 256, smallest_side, largest_side, "Grid height, south to north."),
      with_hint(
          real_parameter("cell_size", "Cell size", "m", start.cell_size, 0.001, 1000.0, "Side of a cell."),
          "so small a number is a cell in degrees: one arc second, 0.000278 degrees, is 31 m from south to north"),
      choice_parameter("boundary", "Boundary", "torus", {"torus", "open"},
                       "torus: what leaves on one side enters on the other; open: it is counted and gone."),
      only_when(real_parameter("inflow", "Inflow", "slabs", 0.0, 0.0, 100.0,
                               "Slabs that enter per time step and cell of the upwind edge."),
                {"boundary", "open"}),
  });
}

Parameters scene_parameters(const ModelStart& start) {
  return all_at_start({
      choice_parameter(
          "kind", "Scene", "flat",
          {"flat", "random", "ripples", "transverse", "rocks", "uneven", "hump", "dune", "valley", "cone", "image"},
          "What lies on the grid before the first step."),
      real_parameter("sand", "Sand", "slabs", start.sand, 0.0, 10000.0,
                     "Mean thickness of the mobile layer in slabs a cell."),
      only_when(real_parameter("height", "Height", "m", 4.0, 0.0, 10000.0,
                               "Height of the rocks, hump, dune or cone; from trough to crest of ripples, transverse "
                               "dunes, uneven ground and valley."),
                {"kind", "ripples", "transverse", "rocks", "uneven", "hump", "dune", "valley", "cone"}),
      only_when(real_parameter("wavelength", "Wavelength", "cells", 32.0, 2.0, largest_side,
                               "From crest to crest of ripples, transverse dunes and uneven ground; width of the "
                               "valley."),
                {"kind", "ripples", "transverse", "uneven", "valley"}),
      only_when(real_parameter("radius", "Radius", "cells", 32.0, 1.0, largest_side,
                               "From the middle to the foot of the hump, dune or cone."),
                {"kind", "hump", "dune", "cone"}),
      only_when(path_parameter("image", "Picture", "Grey picture (PNG) of the heights; relative to the config file."),
                {"kind", "image"}),
      only_when(choice_parameter("image_role", "Picture shows", "bedrock", {"bedrock", "sand", "both"},
                                 "What the picture's heights become: bedrock under an even cover of sand, the sand "
                                 "itself, or the surface of bedrock and sand together."),
                {"kind", "image"}),
      only_when(real_parameter("image_low", "Height of black", "m", 0.0, lowest_point, highest_point,
                               "Height of a black point of the picture; where neither this nor image_high is given, "
                               "what a heightmap written by Erg says of itself."),
                {"kind", "image"}),
      only_when(real_parameter("image_high", "Height of white", "m", 10.0, lowest_point, highest_point,
                               "Height of a white point of the picture; likewise."),
                {"kind", "image"}),
      only_when(
          choice_parameter("image_fit", "Picture fits", "stretch", {"stretch", "crop", "from_file"},
                           "How a picture of another shape fits the grid: stretch: each side by itself; crop: its "
                           "middle, cut to the grid's shape; from_file: the grid takes the picture's sides, and the "
                           "cell size where the picture says one."),
          {"kind", "image"}),
      only_when(choice_parameter("image_nodata", "Without data", "refuse", {"refuse", "lowest", "around"},
                                 "What lies where pixels of the picture are transparent, which means that nothing was "
                                 "measured there: refuse: no such picture; lowest: its lowest height; around: heights "
                                 "carried on from the cells around."),
                {"kind", "image"}),
  });
}

Parameters run_parameters() {
  constexpr std::int64_t largest_seed = std::int64_t{1} << 53;  // every JSON reader keeps whole numbers up to here
  return {
      integer_parameter("steps", "Steps", "", 1000, 0, most_steps, "Time steps to run."),
      at_start(
          integer_parameter("seed", "Seed", "", 0, 0, largest_seed, "The same seed gives the same dunes everywhere.")),
      choice_parameter(
          "executor", "Executor", "auto", executor_names(),
          "serial: one slab at a time, the reference; cpu: parallel sub-sweeps; cuda: the same on a graphics "
          "card, with the same bits; auto: the fastest that works."),
      only_when(integer_parameter("threads", "Threads", "", 0, 0, 256,
                                  "Threads to use; 0: one for each processor. Results do not depend on it."),
                {"executor", "auto", "cpu", "cuda"}),
      only_when(choice_parameter("sweeps", "Sub-sweeps", "16", {"2", "4", "8", "16", "32", "64"},
                                 "Sub-sweeps that a time step is split into: more are slower and closer to one slab "
                                 "at a time."),
                {"executor", "auto", "cpu", "cuda"}),
  };
}

Mistake not_asked_for(const std::string& key, const std::string& model_key) {
  return {"", quote(model_key) + " asks for no " + key, "leave it out, or take a model that does"};
}

Regime starting_wind(const ModelStart& start) {
  Regime wind = Regime::constant(Season{}.bearing, start.strength);
  wind.seasons.front().spread = start.spread;
  return wind;
}

Config::Config() : Config(default_model) {}

Config::Config(const std::string& model_key) : Config(find_model(model_key)) {}

Config::Config(const ModelType& type)
    : model(type.info.key),
      grid(grid_parameters(type.info.start)),
      scene(scene_parameters(type.info.start)),
      run(run_parameters()),
      parameters(type.parameters),
      wind(starting_wind(type.info.start)) {}

const std::vector<ConfigGroup>& config_groups() {
  static const std::vector<ConfigGroup> groups{
      {"grid", &Config::grid}, {"scene", &Config::scene}, {"parameters", &Config::parameters}, {"run", &Config::run}};
  return groups;
}

std::vector<std::string> model_keys() {
  std::vector<std::string> keys;
  for (const ModelType& type : catalogue()) keys.push_back(type.info.key);
  return keys;
}

namespace {

/// Values under other declarations: those that were set stay where they are accepted, the others take the new defaults.
void redeclare(ParameterValues& values, const Parameters& declared) {
  ParameterValues anew(declared);
  for (const Parameter& parameter : values.declared()) {
    const Parameter* same = anew.find(parameter.key);
    if (same == nullptr || !values.is_set(parameter.key)) continue;
    if (values.is_default(parameter.key) && same->standard != parameter.standard) continue;
    const ParameterValue& value = values.value(parameter.key);
    if (!check_value(*same, value, "")) anew.set(parameter.key, value);
  }
  values = std::move(anew);
}

}  // namespace

void change_model(Config& config, const std::string& model_key) {
  const Config from(config.model);
  const Config to(model_key);
  for (const ConfigGroup& group : config_groups()) redeclare(config.*group.values, (to.*group.values).declared());
  Season& season = config.wind.seasons.front();
  const Season& old_start = from.wind.seasons.front();
  if (config.wind.seasons.size() == 1 && season.first == old_start.first && season.last == old_start.last) {
    season.first = season.last = to.wind.seasons.front().first;
  }
  for (Season& each : config.wind.seasons) {
    if (each.spread == old_start.spread) each.spread = to.wind.seasons.front().spread;
  }
  config.model = model_key;
}

void set_from_text(Config& config, const std::string& assignment) { Assignment(config, assignment).apply(); }

}  // namespace erg::sim
