// The program `erg`: names its commands, runs the one that was asked for, and turns errors into exit codes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/command.h"
#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/provenance.h"
#include "sim/memory.h"

namespace erg {
namespace {

ExitCode run_program(int argument_count, char** arguments) {
  CLI::App program("Erg grows sand dunes and wind-blown snow on a grid. Without a command it opens its window.", "erg");
  program.set_version_flag("--version", "erg " + program_version());
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
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_done : exit_wrong_use;
  }
  return action();
}

}  // namespace
}  // namespace erg

int main(int argument_count, char** arguments) {
  const auto tell = [](const erg::InputError& error) {
    for (const erg::Mistake& mistake : error.mistakes()) std::fprintf(stderr, "%s\n", mistake.text().c_str());
  };
  try {
    return erg::run_program(argument_count, arguments);
  } catch (const erg::WriteError& error) {  // the disk's fault, not that of what was asked for
    tell(error);
    return erg::exit_failed;
  } catch (const erg::InputError& error) {
    tell(error);
    return erg::exit_wrong_use;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "erg: %s\n", erg::problem_of(error).c_str());
    return erg::exit_failed;
  }
}
