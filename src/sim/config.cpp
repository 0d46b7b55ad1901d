#include "sim/config.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "compute/executor.h"
#include "models/model.h"
#include "sim/make_executor.h"

namespace erg::sim {

using forcing::WindInterval;
using forcing::WindSchedule;
using models::ModelDefaults;
using models::ModelType;

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

}  // namespace

Parameters grid_parameters(const ModelDefaults& start) {
  return all_at_start({
      {.key = "nx",
       .label = "Cells east",
       .unit = "cells",
       .default_value = 256,
       .minimum = smallest_side,
       .maximum = largest_side,
       .meaning = "Grid width, west to east."},
      {.key = "ny",
       .label = "Cells north",
       .unit = "cells",
       .default_value = 256,
       .minimum = smallest_side,
       .maximum = largest_side,
       .meaning = "Grid height, south to north."},
      {.key = "cell_size",
       .label = "Cell size",
       .unit = "m",
       .default_value = start.cell_size,
       .minimum = 0.001,
       .maximum = 1000.0,
       .meaning = "Side of a cell.",
       .too_small =
           "so small a number is a cell in degrees: one arc second, 0.000278 degrees, is 31 m from south to north"},
      {.key = "boundary",
       .label = "Boundary",
       .default_value = "torus",
       .choices = {"torus", "open"},
       .meaning = "torus: what leaves on one side enters on the other; open: it is counted and gone."},
      {.key = "inflow",
       .label = "Inflow",
       .unit = "slabs",
       .default_value = 0.0,
       .minimum = 0.0,
       .maximum = 100.0,
       .meaning = "Slabs that enter per time step and cell of the upwind edge.",
       .active_if = {"boundary", "open"}},
  });
}

Parameters scene_parameters(const ModelDefaults& start) {
  return all_at_start({
      {.key = "kind",
       .label = "Scene",
       .default_value = "flat",
       .choices = {"flat", "random", "ripples", "transverse", "rocks", "uneven", "hump", "dune", "valley", "cone",
                   "image"},
       .meaning = "What lies on the grid before the first step."},
      {.key = "sand",
       .label = "Sand",
       .unit = "slabs",
       .default_value = start.sand,
       .minimum = 0.0,
       .maximum = 10000.0,
       .meaning = "Mean thickness of the mobile layer in slabs a cell."},
      {.key = "height",
       .label = "Height",
       .unit = "m",
       .default_value = 4.0,
       .minimum = 0.0,
       .maximum = 10000.0,
       .meaning = "Height of the rocks, hump, dune or cone; from trough to crest of ripples, transverse "
                  "dunes, uneven ground and valley.",
       .active_if = {"kind", "ripples", "transverse", "rocks", "uneven", "hump", "dune", "valley", "cone"}},
      {.key = "wavelength",
       .label = "Wavelength",
       .unit = "cells",
       .default_value = 32.0,
       .minimum = 2.0,
       .maximum = largest_side,
       .meaning = "From crest to crest of ripples, transverse dunes and uneven ground; width of the "
                  "valley.",
       .active_if = {"kind", "ripples", "transverse", "uneven", "valley"}},
      {.key = "radius",
       .label = "Radius",
       .unit = "cells",
       .default_value = 32.0,
       .minimum = 1.0,
       .maximum = largest_side,
       .meaning = "From the middle to the foot of the hump, dune or cone.",
       .active_if = {"kind", "hump", "dune", "cone"}},
      {.key = "image",
       .label = "Picture",
       .default_value = "",
       .meaning = "Grey picture (PNG) of the heights; relative to the config file.",
       .active_if = {"kind", "image"}},
      {.key = "image_role",
       .label = "Picture shows",
       .default_value = "bedrock",
       .choices = {"bedrock", "sand", "both"},
       .meaning = "What the picture's heights become: bedrock under an even cover of sand, the sand "
                  "itself, or the surface of bedrock and sand together.",
       .active_if = {"kind", "image"}},
      {.key = "image_low",
       .label = "Height of black",
       .unit = "m",
       .default_value = 0.0,
       .minimum = lowest_point,
       .maximum = highest_point,
       .meaning = "Height of a black point of the picture; where neither this nor image_high is given, "
                  "what a heightmap written by Erg says of itself.",
       .active_if = {"kind", "image"}},
      {.key = "image_high",
       .label = "Height of white",
       .unit = "m",
       .default_value = 10.0,
       .minimum = lowest_point,
       .maximum = highest_point,
       .meaning = "Height of a white point of the picture; likewise.",
       .active_if = {"kind", "image"}},
      {.key = "image_fit",
       .label = "Picture fits",
       .default_value = "stretch",
       .choices = {"stretch", "crop", "from_file"},
       .meaning = "How a picture of another shape fits the grid: stretch: each side by itself; crop: its "
                  "middle, cut to the grid's shape; from_file: the grid takes the picture's sides, and the "
                  "cell size where the picture says one.",
       .active_if = {"kind", "image"}},
      {.key = "image_nodata",
       .label = "Without data",
       .default_value = "refuse",
       .choices = {"refuse", "lowest", "around"},
       .meaning = "What lies where pixels of the picture are transparent, which means that nothing was "
                  "measured there: refuse: no such picture; lowest: its lowest height; around: heights "
                  "carried on from the cells around.",
       .active_if = {"kind", "image"}},
  });
}

const Binding<RunValues>& run_binding() {
  constexpr std::int64_t largest_seed = std::int64_t{1} << 53;  // every JSON reader keeps whole numbers up to here
  static const Binding<RunValues> binding{
      {&RunValues::steps,
       {.key = "steps",
        .label = "Steps",
        .default_value = 1000,
        .minimum = 0,
        .maximum = forcing::most_steps,
        .meaning = "Time steps to run."}},
      {&RunValues::seed,
       {.key = "seed",
        .label = "Seed",
        .default_value = 0,
        .minimum = 0,
        .maximum = largest_seed,
        .meaning = "The same seed gives the same dunes everywhere.",
        .at_start = true}},
      {&RunValues::executor,
       {.key = "executor",
        .label = "Executor",
        .default_value = "auto",
        .choices = executor_names(),
        .meaning = "serial: one slab at a time, the reference; cpu: parallel sub-sweeps; cuda: the same on a graphics "
                   "card, with the same bits; auto: the fastest that works."}},
      {&RunValues::threads,
       {.key = "threads",
        .label = "Threads",
        .default_value = 0,
        .minimum = 0,
        .maximum = 256,
        .meaning = "Threads to use; 0: one for each processor. Results do not depend on it.",
        .active_if = {"executor", "auto", "cpu", "cuda"}}},
      {&RunValues::sweeps,
       {.key = "sweeps",
        .label = "Sub-sweeps",
        .default_value = "16",
        .choices = {"2", "4", "8", "16", "32", "64"},
        .meaning = "Sub-sweeps that a time step is split into: more are slower and closer to one slab "
                   "at a time.",
        .active_if = {"executor", "auto", "cpu", "cuda"}}},
  };
  return binding;
}

Parameters run_parameters() { return run_binding().declarations(); }

Mistake not_asked_for(const std::string& key, const std::string& model_key) {
  return {"", quote(model_key) + " asks for no " + key, "leave it out, or take a model that does"};
}

WindSchedule starting_wind(const ModelDefaults& start) {
  WindSchedule wind = WindSchedule::constant(WindInterval{}.bearing, start.strength);
  wind.intervals.front().spread = start.spread;
  return wind;
}

namespace {

/// The groups' declarations, made once for each place where a model may start and shared by all configs.
struct GroupDeclarations {
  Declarations grid;
  Declarations scene;
};

const GroupDeclarations& group_declarations(const ModelDefaults& start) {
  static std::mutex one_at_a_time;
  static std::map<std::pair<double, double>, GroupDeclarations> made;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  const auto [entry, is_new] = made.try_emplace({start.cell_size, start.sand});
  if (is_new) entry->second = {grid_parameters(start), scene_parameters(start)};
  return entry->second;
}

}  // namespace

Config::Config() : Config(default_model) {}

Config::Config(const std::string& model_key) : Config(models::find_model(model_key)) {}

Config::Config(const ModelType& type)
    : model(type.info.key),
      grid(group_declarations(type.info.start).grid),
      scene(group_declarations(type.info.start).scene),
      run(run_binding().declarations()),
      parameters(type.parameters),
      wind(starting_wind(type.info.start)) {}

const std::vector<ConfigGroup>& config_groups() {
  static const std::vector<ConfigGroup> groups{
      {"grid", &Config::grid}, {"scene", &Config::scene}, {"parameters", &Config::parameters}, {"run", &Config::run}};
  return groups;
}

std::vector<std::string> model_keys() {
  std::vector<std::string> keys;
  for (const ModelType& type : models::catalogue()) keys.push_back(type.info.key);
  return keys;
}

namespace {

/// Values under other declarations: those that were set stay where they are accepted, the others take the new defaults.
void redeclare(ParameterValues& values, const Declarations& declared) {
  ParameterValues anew(declared);
  for (const Parameter& parameter : values.declared()) {
    const Parameter* same = anew.find(parameter.key);
    if (same == nullptr || !values.is_set(parameter.key)) continue;
    if (values.is_default(parameter.key) && same->default_value != parameter.default_value) continue;
    const ParameterValue& value = values.value(parameter.key);
    if (!check_value(*same, value, "")) anew.set(parameter.key, value);
  }
  values = std::move(anew);
}

}  // namespace

void change_model(Config& config, const std::string& model_key) {
  const Config from(config.model);
  const Config to(model_key);
  for (const ConfigGroup& group : config_groups()) redeclare(config.*group.values, (to.*group.values).declarations());
  WindInterval& season = config.wind.intervals.front();
  const WindInterval& old_start = from.wind.intervals.front();
  if (config.wind.intervals.size() == 1 && season.first == old_start.first && season.last == old_start.last) {
    season.first = season.last = to.wind.intervals.front().first;
  }
  for (WindInterval& each : config.wind.intervals) {
    if (each.spread == old_start.spread) each.spread = to.wind.intervals.front().spread;
  }
  config.model = model_key;
}

}  // namespace erg::sim
