#include "sim/run_check.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "forcing/bearing.h"
#include "models/model.h"

namespace erg::sim {

using forcing::row_of;

namespace {

/// What is wrong with a group's values as those that are declared here.
std::optional<Mistake> group_mistake(const ConfigGroup& group, const ParameterValues& values,
                                     const Parameters& wanted) {
  const Parameters& declared = values.declared();
  const bool same = std::ranges::equal(declared, wanted, {}, &Parameter::key, &Parameter::key);
  if (!same) {
    return Mistake{group.key, "these are not the values that the config's model declares",
                   "make a config of that model, Config(model), or change the model by change_model"};
  }
  for (const Parameter& parameter : wanted) {
    if (auto mistake = check_value(parameter, values.value(parameter.key), group.key)) return mistake;
  }
  return std::nullopt;
}

/// What a row of these values is refused for.
std::optional<Mistake> row_mistake(const std::string& place, const std::function<void()>& make_row) {
  try {
    make_row();
  } catch (const InputError& error) {
    Mistake mistake = error.mistakes().front();
    mistake.place = place;
    return mistake;
  }
  return std::nullopt;
}

std::optional<Mistake> wind_mistake(const forcing::WindSchedule& wind) {
  if (wind.intervals.empty()) return Mistake{"wind", "it has no season", "give at least one"};
  const Declarations columns = forcing::interval_columns();
  for (const forcing::WindInterval& season : wind.intervals) {
    if (auto mistake = row_mistake("wind", [&] { row_of(season, columns); })) return mistake;
  }
  return std::nullopt;
}

std::optional<Mistake> weather_mistake(const forcing::Weather& weather) {
  for (const forcing::Channel& channel : forcing::channels()) {
    if (channel.over_run == nullptr) continue;
    const auto make_row = [&] { row_of(weather.*channel.over_run, channel); };
    if (auto mistake = row_mistake(channel.declared.key, make_row)) return mistake;
  }
  return std::nullopt;
}

Extent grid_of(const Config& config) {
  return {static_cast<int>(config.grid.integer("nx")), static_cast<int>(config.grid.integer("ny"))};
}

std::string sides(Extent extent) { return std::to_string(extent.nx) + " x " + std::to_string(extent.ny); }

std::optional<std::string> layer_problem(const std::string& name, Extent layer, Extent grid) {
  if (layer == grid) return std::nullopt;
  return name + " has " + sides(layer) + " cells, and the grid " + sides(grid);
}

std::optional<std::string> length_problem(const std::string& things, double is, double should_be) {
  if (is == should_be) return std::nullopt;
  return "its " + things + " are of " + value_text(is) + " m, and the config's of " + value_text(should_be) + " m";
}

std::optional<std::string> height_problem(const Terrain& terrain) {
  for (std::size_t cell = 0; cell < terrain.extent().cells(); ++cell) {
    const std::int64_t bedrock = terrain.bedrock()[cell];
    const std::int64_t mobile = terrain.mobile()[cell];
    if (mobile < 0) return "a cell holds less than nothing";
    if (bedrock < -largest_height || bedrock + mobile > largest_height) return "a height is out of range";
  }
  return std::nullopt;
}

/// A model finds its fields by their places.
std::optional<std::string> field_problem(const std::vector<FieldInfo>& wanted, const Terrain& terrain, Extent grid) {
  const std::vector<Field>& fields = terrain.fields();
  for (std::size_t place = 0; place < wanted.size(); ++place) {
    if (place < fields.size() && fields[place].info.key == wanted[place].key) continue;
    return "it has not the fields of its model: " + wanted[place].key + " is missing";
  }
  for (const Field& field : fields) {
    if (auto problem = layer_problem("the field " + field.info.key, field.values.extent(), grid)) return problem;
    // Written so that NaN is refused.
    const auto fits = [](float value) { return std::abs(value) <= largest_field_value; };
    if (!std::ranges::all_of(field.values.cells(), fits)) {
      return "a value of the field " + field.info.key + " is out of range";
    }
  }
  return std::nullopt;
}

}  // namespace

void check_config(const Config& config) {
  const Config wanted(config.model);
  for (const ConfigGroup& group : config_groups()) {
    if (auto mistake = group_mistake(group, config.*group.values, (wanted.*group.values).declared())) {
      throw InputError({std::move(*mistake)});
    }
  }
  if (auto mistake = wind_mistake(config.wind)) throw InputError({std::move(*mistake)});
  if (auto mistake = weather_mistake(config.weather)) throw InputError({std::move(*mistake)});
}

std::optional<std::string> terrain_problem(const Config& config, double quantum, const Terrain& terrain,
                                           bool fields_may_come) {
  const Extent grid = grid_of(config);
  if (auto problem = layer_problem("the bedrock", terrain.bedrock().extent(), grid)) return problem;
  if (auto problem = layer_problem("the mobile layer", terrain.mobile().extent(), grid)) return problem;
  if (auto problem = length_problem("cells", terrain.cell_size(), config.grid.real("cell_size"))) return problem;
  if (auto problem = length_problem("slabs", terrain.quantum(), quantum)) return problem;
  const bool open = config.grid.text("boundary") == "open";
  if (open != (terrain.boundary() == Boundary::open)) return "its boundary is not that of the config";
  if (check_value(*config.grid.find("inflow"), terrain.inflow(), "")) return "its inflow is out of range";
  if (auto problem = height_problem(terrain)) return problem;
  if (fields_may_come && terrain.fields().empty()) return std::nullopt;
  return field_problem(models::find_model(config.model).fields, terrain, grid);
}

bool counts_in_range(const MassLedger& ledger) {
  const auto fits = [](std::int64_t count) { return count >= 0 && count <= largest_count; };
  return fits(ledger.start) && fits(ledger.in) && fits(ledger.out);
}

std::optional<std::string> ledger_problem(const Terrain& terrain) {
  if (!counts_in_range(terrain.ledger())) return "a count of its account is out of range";
  if (terrain.total_mobile() != terrain.ledger().expected()) return "by its account material is missing or too much";
  return std::nullopt;
}

void check_state(const Config& config, double quantum, const RunState& state) {
  const auto refuse = [](const std::string& problem, const std::string& remedy) {
    throw InputError("state", problem, remedy);
  };
  if (auto problem = terrain_problem(config, quantum, state.terrain, true)) {
    refuse("the terrain is none of a run of this config: " + *problem, "give one that is, or another config");
  }
  if (auto problem = ledger_problem(state.terrain)) {
    refuse("the terrain is not whole: " + *problem, "open its account anew (open_ledger)");
  }
  const models::StepReport& totals = state.totals;
  for (const std::int64_t count : {state.step, totals.polls, totals.lifts, totals.slabs_in, totals.slabs_out}) {
    if (count < 0 || count > largest_count) refuse("a count is out of range", "count from 0");
  }
}

}  // namespace erg::sim
