// `erg check`, `erg presets` and `erg schema`: config files without running them.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/presets.h"
#include "app/cli/text_table.h"
#include "core/errors.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "models/model.h"
#include "sim/memory.h"
#include "sim/step_time.h"

namespace erg::app {

using io::read_config;
using sim::Config;

namespace {

/// Finds what a run refuses at its start, where there is memory for that; else the note says what there is not.
void try_start(Config config, const io::ConfigPictures& pictures, std::vector<std::string>& notes) {
  config.run.set("executor", std::string("serial"));  // no threads and no device for a run of no steps
  try {
    sim::check_memory({&config, 1}, 0, sim::free_memory());
  } catch (const InputError& short_of_memory) {
    notes.emplace_back(short_of_memory.what());
    return;
  }
  sim::Simulation(std::move(config), pictures.scene ? &*pictures.scene : nullptr,
                  pictures.model ? &*pictures.model : nullptr);
}

ExitCode check_config(const std::string& name) {
  const std::string path = config_path(name);
  std::vector<std::string> notes;
  Config config = read_config(path, &notes);
  io::take_grid_from_picture(config);
  try_start(config, io::read_pictures(config, &notes), notes);
  const models::ModelType& type = models::find_model(config.model);
  std::cout << path << ": good; " << type.info.title << ", " << config.grid.integer("nx") << " x "
            << config.grid.integer("ny") << " cells, " << config.run.integer("steps") << " steps\n";
  for (const std::string& meaning : sim::explain(config)) std::cout << "  " << meaning << "\n";
  for (const std::string& note : notes) std::cout << "  note: " << note << "\n";
  return exit_done;
}

ExitCode print_presets() {
  TextTable table;
  table.heading = {"preset", "title", "what it shows"};
  for (const io::Preset& preset : presets()) {
    const Config config = read_config(preset.path);
    table.rows.push_back({preset.name, config.title, config.description});
  }
  if (table.rows.empty()) {
    throw InputError(presets_folder().string(), "there are no presets", "install the program with `cmake --install`");
  }
  std::cout << table.aligned() << "\nGrow one with `erg run PRESET`.\n";
  return exit_done;
}

ExitCode print_schema() {
  std::cout << io::config_schema();
  return exit_done;
}

}  // namespace

void add_check_command(CLI::App& program, Action& action) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("check", "Check a config file and run nothing");
  command->add_option("CONFIG", *name, "Config file, or the name of a preset")->required();
  command->callback([&action, name] { action = [name] { return check_config(*name); }; });
}

void add_presets_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("presets", "List the presets");
  command->callback([&action] { action = print_presets; });
}

void add_schema_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("schema", "Print the JSON schema of config files");
  command->callback([&action] { action = print_schema; });
}

}  // namespace erg::app
