#include "app/run_setup.h"

#include <cmath>
#include <filesystem>

#include "app/presets.h"
#include "io/checkpoint.h"
#include "io/config_file.h"
#include "io/start_simulation.h"
#include "sim/memory.h"

namespace erg {
namespace {

/// Applies --set and the options to a config; throws one InputError with all that is wrong with them.
void apply_options(Config& config, const RunRequest& request) {
  std::vector<Mistake> mistakes;
  const auto apply = [&](const std::string& place, const std::string& assignment) {
    try {
      set_from_text(config, assignment);
    } catch (const InputError& error) {
      for (Mistake mistake : error.mistakes()) {
        mistake.place = place;
        mistakes.push_back(std::move(mistake));
      }
    }
  };
  for (const std::string& assignment : request.assignments) apply("--set " + assignment, assignment);
  for (const auto& [key, value] : request.options) apply("--" + key + " " + value, "run." + key + "=" + value);
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
}

/// A checkpoint goes on under another config only where its terrain fits.
void check_fits(const Config& config, const Saved& saved, const std::string& place) {
  std::vector<Mistake> mistakes;
  const auto compare = [&](const std::string& what, const std::string& ours, const std::string& theirs) {
    if (ours == theirs) return;
    mistakes.push_back({place, what + " is " + theirs + " in the checkpoint and " + ours + " in the config",
                        "resume without a config, or with one that fits"});
  };
  compare("model", config.model, saved.config.model);
  for (const Parameter& parameter : config.grid.declared()) {
    compare("grid." + parameter.key, value_text(config.grid.value(parameter.key)),
            value_text(saved.config.grid.value(parameter.key)));
  }
  if (config.model == saved.config.model) {
    const double ours = find_model(config.model).make(config.parameters)->quantum();
    compare("slab height", value_text(ours), value_text(saved.state.terrain.quantum()));
  }
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
}

void check_steps_left(const Config& config, std::int64_t done, const std::string& place) {
  if (config.run.integer("steps") >= done) return;
  throw InputError(place,
                   "the checkpoint stands at step " + std::to_string(done) + ", after the last step asked for, " +
                       std::to_string(config.run.integer("steps")),
                   "ask for more with --steps (it counts from the start of the run)");
}

}  // namespace

Simulation start_simulation(const RunRequest& request) {
  if (request.resume.empty()) {
    Config config = read_config(config_path(request.config));
    apply_options(config, request);
    check_memory({&config, 1}, 0, free_memory());
    return start_simulation(config);
  }
  Saved saved = read_checkpoint(request.resume);
  Config config = request.config.empty() ? saved.config : read_config(config_path(request.config));
  apply_options(config, request);
  check_fits(config, saved, request.resume);
  check_steps_left(config, saved.state.step, request.resume);
  return Simulation(std::move(config), std::move(saved.state));
}

bool is_checkpoint(const std::string& source) { return std::filesystem::path(source).extension() == ".checkpoint"; }

Simulation start_from(const std::string& source, const std::vector<std::string>& assignments) {
  RunRequest request;
  (is_checkpoint(source) ? request.resume : request.config) = source;
  request.assignments = assignments;
  return start_simulation(request);
}

std::string run_name(const RunRequest& request) {
  const std::filesystem::path path = request.config.empty() ? request.resume : request.config;
  std::string name = path.stem().string();
  // A checkpoint's name ends with its step.
  const std::size_t last_letter = name.find_last_not_of("0123456789");
  const bool numbered = last_letter != std::string::npos && last_letter > 0 && last_letter + 1 < name.size();
  if (request.config.empty() && numbered && name[last_letter] == '-') name.resize(last_letter);
  return name;
}

}  // namespace erg
