// What all commands of the program share: how each one registers itself, and how the program ends.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace erg::app {

/// Exit codes of the program.
enum ExitCode : int {
  exit_done = 0,
  exit_failed = 1,     ///< the run failed or was interrupted
  exit_wrong_use = 2,  ///< wrong use of the command line, or bad input
};

/// What the command line asked for; the command that was named sets it, main calls it.
using Action = std::function<ExitCode()>;

/// Each of these adds one command (its options and help) to `program`; when it is named, `action` is set. Those of the
/// window, the benchmark and the validation are declared beside them.
void add_run_command(CLI::App& program, Action& action);
void add_measure_command(CLI::App& program, Action& action);
void add_render_command(CLI::App& program, Action& action);
void add_check_command(CLI::App& program, Action& action);
void add_models_command(CLI::App& program, Action& action);
void add_model_command(CLI::App& program, Action& action);
void add_presets_command(CLI::App& program, Action& action);
void add_gallery_command(CLI::App& program, Action& action);
void add_schema_command(CLI::App& program, Action& action);

}  // namespace erg::app
