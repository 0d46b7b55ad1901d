#include "app/cli/run_setup.h"

#include <cmath>
#include <filesystem>

#include "app/cli/notice.h"
#include "app/cli/presets.h"
#include "io/checkpoint/checkpoint.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/files/given_file.h"
#include "sim/memory.h"

namespace erg::app {

using io::read_config;
using io::Saved;
using io::take_grid_from_picture;
using sim::Config;
using sim::Simulation;

namespace {

/// Applies --set and the options to a config; throws one InputError with all that is wrong with them.
void apply_options(Config& config, const RunRequest& request) {
  std::vector<Mistake> mistakes;
  const auto apply = [&](const std::string& place, const std::string& assignment) {
    try {
      sim::set_from_text(config, assignment);
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
    const double ours = models::find_model(config.model).make(config.parameters)->quantum();
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

/// The checkpoint of a folder that was written last; empty where it has none.
std::filesystem::path newest_checkpoint(const std::filesystem::path& folder) {
  std::filesystem::path newest;
  std::filesystem::file_time_type when;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() != ".checkpoint") continue;
    const auto written = entry->last_write_time(error);
    if (!newest.empty() && std::pair(written, entry->path()) < std::pair(when, newest)) continue;
    newest = entry->path();
    when = written;
  }
  return newest;
}

/// What is given in another's place: a folder of checkpoints, a checkpoint as a config.
void check_source(const RunRequest& request) {
  std::error_code none;
  if (std::filesystem::is_directory(request.resume, none)) {
    const std::filesystem::path newest = newest_checkpoint(request.resume);
    throw InputError(
        "--resume " + request.resume, "this is a folder",
        newest.empty() ? "give a checkpoint; there is none in it" : "did you mean \"" + newest.string() + "\"?");
  }
  if (std::filesystem::path(request.config).extension() == ".checkpoint") {
    throw InputError(request.config, "this is a checkpoint and no config", "go on from it with --resume");
  }
}

}  // namespace

Simulation start_simulation(const RunRequest& request) {
  check_source(request);
  if (request.resume.empty()) {
    std::vector<std::string> notes;
    Config config = read_config(config_path(request.config), &notes);
    apply_options(config, request);
    take_grid_from_picture(config);
    sim::check_memory({&config, 1}, 0, sim::free_memory());
    Simulation simulation = io::start_simulation(config, &notes);
    if (!request.quiet) print_notes(notes);
    return simulation;
  }
  Saved saved = io::read_checkpoint(request.resume);
  Config config = request.config.empty() ? saved.config : read_config(config_path(request.config));
  apply_options(config, request);
  if (!request.config.empty()) take_grid_from_picture(config);
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

bool writes_files(const RunRequest& request) {
  return !request.out.empty() || !request.formats.empty() || request.every > 0;
}

std::string output_folder(const RunRequest& request) { return request.out.empty() ? "out" : request.out; }

std::string run_name(const RunRequest& request) {
  const std::filesystem::path path = request.config.empty() ? request.resume : request.config;
  if (io::is_stream(path)) return "config";
  std::string name = path.stem().string();
  // A checkpoint's name ends with its step.
  const std::size_t last_letter = name.find_last_not_of("0123456789");
  const bool numbered = last_letter != std::string::npos && last_letter > 0 && last_letter + 1 < name.size();
  if (request.config.empty() && numbered && name[last_letter] == '-') name.resize(last_letter);
  return name;
}

}  // namespace erg::app
