// The program `erg`: names its commands, runs the one that was asked for, and turns errors into exit codes.
#include <exception>
#include <iostream>
#include <string>

#include "app/bench/bench_command.h"
#include "app/cli/command.h"
#include "app/cli/options.h"
#include "app/cli/standard_streams.h"
#include "app/cli/tell.h"
#include "app/gui/gui_command.h"
#include "app/validate/validate_command.h"
#include "core/errors.h"
#include "io/config/provenance.h"
#include "io/files/atomic_file.h"

namespace erg::app {
namespace {

ExitCode run_program(int argument_count, char** arguments) {
  CLI::App program("Erg grows sand dunes and wind-blown snow on a grid. Without a command it opens its window.", "erg");
  program.set_version_flag("--version", "erg " + io::program_version());
  program.require_subcommand(0, 1);
  program.footer("`erg COMMAND --help` shows the options of a command.");

  Action action = open_gallery_window;
  add_gui_command(program, action);
  add_run_command(program, action);
  add_measure_command(program, action);
  add_render_command(program, action);
  add_check_command(program, action);
  add_models_command(program, action);
  add_model_command(program, action);
  add_presets_command(program, action);
  add_gallery_command(program, action);
  add_schema_command(program, action);
  add_bench_command(program, action);
  add_validate_command(program, action);

  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::ExtrasError& error) {
    const ExitCode code = program.exit(error) == 0 ? exit_done : exit_wrong_use;
    if (const std::string remedy = remedy_for_unknown(program); !remedy.empty()) std::cerr << remedy << "\n";
    return code;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_done : exit_wrong_use;
  }
  refuse_empty_values(program);
  return action();
}

/// The same with errors told and turned into exit codes.
ExitCode run_and_tell(int argument_count, char** arguments) {
  try {
    return run_program(argument_count, arguments);
  } catch (const io::WriteError& error) {  // the disk's fault, not that of what was asked for
    tell(error);
    return exit_failed;
  } catch (const InputError& error) {
    tell(error);
    return exit_wrong_use;
  } catch (const std::exception& error) {
    tell(error);
    return exit_failed;
  }
}

}  // namespace
}  // namespace erg::app

int main(int argument_count, char** arguments) {
  erg::app::guard_standard_streams();
  const erg::app::ExitCode code = erg::app::run_and_tell(argument_count, arguments);
  if (const std::string notice = erg::io::take_disk_notice(); !notice.empty()) std::cerr << "note: " << notice << "\n";
  const std::string problem = erg::app::output_problem();
  if (problem.empty()) return code;
  std::cerr << "standard output: cannot be written (" << problem << ")\n";
  return code == erg::app::exit_done ? erg::app::exit_failed : code;
}
