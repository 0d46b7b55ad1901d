#include "app/cli/way_on.h"

#include <iostream>
#include <memory>

#include "app/cli/tell.h"
#include "core/errors.h"
#include "core/join.h"

namespace erg::app {

using sim::Simulation;

namespace {

/// A step that failed half way may have taken sand from one place and not yet set it down at another.
void check_whole(Simulation& simulation) {
  const Terrain& terrain = simulation.terrain();
  if (terrain.total_mobile() == terrain.ledger().expected()) return;
  throw InputError("", "the step that failed has left the terrain half done, so it was not saved", "");
}

std::filesystem::path save(const RunRequest& request, Simulation& simulation, RunOutput* output) {
  check_whole(simulation);
  if (output != nullptr) return output->write_state_checkpoint();
  return RunOutput(output_folder(request), run_name(request), {}, simulation).write_state_checkpoint();
}

}  // namespace

std::string shell_quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string way_on(const RunRequest& request, const std::filesystem::path& checkpoint) {
  // What begins with a dash would be taken for an option.
  const auto path = [](const std::string& name) { return shell_quoted(name.starts_with('-') ? "./" + name : name); };
  std::string command = "erg run --resume " + path(checkpoint.string());
  if (writes_files(request)) command += " --out " + path(output_folder(request));
  if (request.every > 0) command += " --every " + std::to_string(request.every);
  if (!request.formats.empty()) command += " --format " + join(request.formats, ",");
  if (!request.stats.empty()) command += " --stats " + path(request.stats);
  return command;
}

void save_and_tell(const RunRequest& request, Simulation& simulation, RunOutput* output, const std::string& how_ended) {
  std::filesystem::path saved = output != nullptr ? output->last_checkpoint() : std::filesystem::path();
  try {
    saved = save(request, simulation, output);
  } catch (const std::exception& error) {
    tell(error);
  }
  std::cerr << how_ended << " after step " << simulation.step_count() << " of "
            << simulation.config().run.integer("steps") << ". ";
  if (saved.empty()) {
    std::cerr << "Nothing could be saved.\n";
  } else {
    std::cerr << "Go on with: " << way_on(request, saved) << "\n";
  }
}

}  // namespace erg::app
