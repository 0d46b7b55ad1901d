// `erg validate`: writes docs/validation.md, or prints it.
#include "app/validate/validate_command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/known_words.h"
#include "app/cli/options.h"
#include "app/cli/output_folder.h"
#include "app/validate/page_part.h"
#include "app/validate/validation.h"
#include "core/errors.h"
#include "io/config/provenance.h"
#include "io/files/atomic_file.h"
#include "io/files/given_file.h"

namespace erg::app {
namespace {

struct Section {
  const char* name;
  std::string (*measure)(const ValidationOptions&);
};

constexpr Section sections[] = {
    {"published", published_section}, {"executors", executors_section},
    {"bearings", bearings_section},   {"ripples", ripples_section},
    {"plants", plants_section},       {"snow", snow_section},
    {"nature", nature_section},       {"identities", [](const ValidationOptions&) { return identities_section(); }},
};

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const Section& section : sections) names.push_back(section.name);
  return names;
}

/// A choice within a section needs that section.
void check_choice(const std::string& option, const std::string& value, const std::string& kind,
                  const std::string& needed, const std::string& section) {
  if (value.empty() || section == needed) return;
  throw InputError(option + " " + value, "is a " + kind + " of the section " + needed, "add --section " + needed);
}

std::string validation_document(const ValidationOptions& options) {
  const std::string command = options.quick ? "erg validate --quick" : "erg validate";
  std::string document =
      "# Validation\n\nMade by `" + command + " --out docs/validation.md` with erg " + io::program_version() + ".\n";
  for (const Section& section : sections) document += "\n" + section.measure(options);
  return document;
}

}  // namespace

void add_validate_command(CLI::App& program, Action& action) {
  struct Options {
    ValidationOptions validation;
    std::string out;
    std::string section;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("validate", "Measure what is in print beside this program's figures (long)");
  command->add_flag("--quick", options->validation.quick, "Fewer seeds and steps, only the small scenes");
  command->add_option("--out", options->out,
                      "Markdown file to write (default: print); with --section only that part of it");
  command->add_option("--section", options->section, "Only this section of the document")
      ->check(one_of(section_names()));
  command->add_option("--scene", options->validation.scene, "With --section published: only the row of this preset")
      ->check(one_of(published_presets()));
  command->add_option("--law", options->validation.law, "With --section nature: only the table of this law")
      ->check(one_of(nature_law_names()));
  add_instructions_option(*command);
  command->callback([&action, options] {
    action = [options] {
      check_choice("--scene", options->validation.scene, "row", "published", options->section);
      check_choice("--law", options->validation.law, "table", "nature", options->section);
      check_output("--out", options->out);
      std::string document;
      for (const Section& section : sections) {
        if (options->section == section.name) document = section.measure(options->validation);
      }
      if (document.empty()) {
        document = validation_document(options->validation);
      } else if (!options->out.empty() && std::filesystem::is_regular_file(options->out)) {
        document = with_part(io::read_text_file(options->out, "page"), document);
      }
      if (options->out.empty()) {
        std::cout << document;
      } else {
        io::write_file_atomically(options->out, document);
      }
      return exit_done;
    };
  });
}

}  // namespace erg::app
