// `erg validate`: writes docs/validation.md, or prints it.
#include <iostream>
#include <memory>

#include "app/command.h"
#include "app/validation.h"
#include "io/atomic_file.h"

namespace erg {
namespace {

std::string validation_document(const ValidationOptions& options) {
  const std::string command = options.quick ? "erg validate --quick" : "erg validate";
  std::string document =
      "# Validation\n\nMade by `" + command + " --out docs/validation.md` with erg " ERG_VERSION ".\n";
  document += "\n" + published_section(options);
  document += "\n" + executors_section(options);
  document += "\n" + bearings_section(options);
  document += "\n" + identities_section();
  return document;
}

}  // namespace

void add_validate_command(CLI::App& program, Action& action) {
  struct Options {
    ValidationOptions validation;
    std::string out;
    bool snow = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("validate", "Measure what is in print beside this program's figures (long)");
  command->add_flag("--quick", options->validation.quick, "Fewer seeds and steps, only the small scenes");
  command->add_flag("--snow", options->snow, "Only which forms sintering snow takes, by wind and calm hours");
  command->add_option("--out", options->out, "Markdown file to write (default: print)");
  command->callback([&action, options] {
    action = [options] {
      const std::string document =
          options->snow ? snow_section(options->validation) : validation_document(options->validation);
      if (options->out.empty()) {
        std::cout << document;
      } else {
        write_file_atomically(options->out, document);
      }
      return exit_done;
    };
  });
}

}  // namespace erg
