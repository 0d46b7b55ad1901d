#include "app/cli/options.h"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "compute/executor.h"
#include "core/errors.h"
#include "core/number_text.h"

namespace erg::app {
namespace {

/// The program and the commands that were named, with the groups of their options.
std::vector<const CLI::App*> used(const CLI::App& program) {
  std::vector<const CLI::App*> all{&program};
  for (std::size_t next = 0; next < all.size(); ++next) {
    const CLI::App* const app = all[next];
    for (const CLI::App* below : app->get_subcommands([](const CLI::App*) { return true; })) {
      if (below->get_name().empty() || below->parsed()) all.push_back(below);
    }
  }
  return all;
}

}  // namespace

CLI::Validator whole_number(std::int64_t least, std::int64_t most) {
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  return {[=](std::string& text) {
            const auto value = number_from<std::int64_t>(text);
            if (value && *value >= least && *value <= most) return std::string();
            return "is " + quote(text) + "; expected a whole number, " + range;
          },
          range, "whole_number"};
}

CLI::Validator finite_number() {
  return {[](std::string& text) {
            const auto value = number_from<double>(text);
            return value && std::isfinite(*value) ? std::string() : "is " + quote(text) + "; expected a number";
          },
          "", "finite_number"};
}

void add_instructions_option(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--instructions",
          [](const std::string& name) {
            compute::find_instruction_set(name, "--instructions");
            ::setenv(compute::instructions_variable, name.c_str(), 1);
          },
          "Machine instructions that the engine uses: portable, avx2, avx512 (default: the best that the processor "
          "has; the same bits with all)")
      ->type_name("");
}

void refuse_empty_values(const CLI::App& program) {
  std::vector<Mistake> mistakes;
  for (const CLI::App* app : used(program)) {
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& value : option->results()) {
        if (!value.empty()) continue;
        mistakes.push_back({option->get_name(), "is empty", "give a value, or leave it out"});
        break;
      }
    }
  }
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
}

std::string remedy_for_unknown(const CLI::App& program) {
  std::vector<std::string> known;
  for (const CLI::App* app : used(program)) {
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    }
  }
  const bool command_named = !program.get_subcommands().empty();
  if (!command_named) {
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
      known.push_back(command->get_name());
    }
  }
  for (const std::string& word : program.remaining(true)) {
    const std::string near = nearest_word(word.substr(0, word.find('=')), known);
    if (!near.empty()) return "did you mean \"" + near + "\"?";
  }
  return {};
}

}  // namespace erg::app
