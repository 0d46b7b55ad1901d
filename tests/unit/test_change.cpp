// A run that goes on under another config: what a resumed run does, to the bit, but on the executor that it has.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "small_runs.h"

namespace erg {

using sim::Config;
using sim::set_from_text;
using sim::Simulation;

namespace {

using test::name_of;
using test::small_runs;

/// Another value that the parameter accepts; its own where there is none to be had (paths, curves).
ParameterValue another(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    const double more = *real == 0 ? 0.2 * parameter.maximum : 1.3 * *real;
    return std::clamp(more > parameter.maximum ? 0.7 * *real : more, parameter.minimum, parameter.maximum);
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    return *whole + (static_cast<double>(*whole) < parameter.maximum ? 1 : -1);
  }
  if (const auto* truth = std::get_if<bool>(&value)) return !*truth;
  if (parameter.kind() != ParameterKind::choice) return value;
  const auto here = std::ranges::find(parameter.choices, std::get<std::string>(value));
  return here + 1 == parameter.choices.end() ? parameter.choices.front() : *(here + 1);
}

/// Runs two steps under one config and two under the other: on one executor, and as a run resumed from a checkpoint.
void expect_change_is_resume(const Config& before, const Config& after, const std::string& where) {
  Simulation changed(before);
  for (int step = 0; step < 2; ++step) changed.step();
  Simulation resumed(after, changed.state());
  const compute::Executor* executor = &changed.executor();
  changed.change(after);
  for (int step = 0; step < 2; ++step) {
    changed.step();
    resumed.step();
  }
  EXPECT_EQ(state_hash(changed.terrain()), state_hash(resumed.terrain())) << where;
  EXPECT_EQ(changed.terrain().ledger(), resumed.terrain().ledger()) << where;
  EXPECT_EQ(&changed.executor(), executor) << where;
}

TEST(Change, OfAnyParameterKeepsTheExecutorAndGoesOnAsAResumedRunDoes) {
  for (const Config& config : small_runs()) {
    int changes = 0;
    for (const Parameter& parameter : config.parameters.declared()) {
      if (parameter.at_start) continue;
      Config other = config;
      other.parameters.set(parameter.key, another(parameter, config.parameters.value(parameter.key)));
      if (other == config) continue;
      expect_change_is_resume(config, other, name_of(config) + ", another " + parameter.key);
      ++changes;
    }
    EXPECT_GT(changes, 3) << name_of(config);
  }
}

TEST(Change, OfTheWindKeepsTheExecutorAndGoesOnAsAResumedRunDoes) {
  for (const Config& config : small_runs()) {
    for (const char* wind : {"wind.bearing=10", "wind.bearing=250", "wind.strength=11"}) {
      Config other = config;
      set_from_text(other, wind);
      expect_change_is_resume(config, other, name_of(config) + ", " + wind);
    }
  }
}

double sum_of(const Field& field) {
  double sum = 0;
  for (const float value : field.values.cells()) sum += value;
  return sum;
}

TEST(Change, OfTheExecutorMakesAnother) {
  for (const char* setting : {"threads=1", "sweeps=8", "executor=serial"}) {
    Config config("momiji");
    for (const char* small : {"nx=32", "ny=24", "threads=2", "sweeps=4", "executor=cpu"}) set_from_text(config, small);
    Simulation run(config);
    run.watch_flux(true);
    run.step();
    set_from_text(config, setting);
    run.change(config);
    EXPECT_EQ(run.executor().name(), config.run.text("executor"));
    EXPECT_EQ(run.executor().threads(), config.run.text("executor") == "serial" ? 1 : config.run.integer("threads"));
    EXPECT_EQ(run.executor().sub_sweeps(), config.run.text("executor") == "serial" ? 0 : config.run.integer("sweeps"));
    const double before = sum_of(run.flux()->mean());
    run.step();
    EXPECT_GT(2 * sum_of(run.flux()->mean()), before) << "lifts are counted on";
  }
}

}  // namespace
}  // namespace erg
