// What options of the command line accept, and what is said where one is not right.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace erg::app {

/// Accepts whole numbers from `least` to `most`, which the number that it is read into must hold.
CLI::Validator whole_number(std::int64_t least, std::int64_t most);

/// Accepts finite numbers.
CLI::Validator finite_number();

/// Adds --instructions, which sets the variable of the environment that executors look at (wanted_instruction_set).
void add_instructions_option(CLI::App& command);

/// Throws InputError for every option and argument that was given and is empty: mostly a variable of the shell that was
/// never set.
void refuse_empty_values(const CLI::App& program);

/// The nearest right word for each that the command line does not know; empty where none is near.
std::string remedy_for_unknown(const CLI::App& program);

}  // namespace erg::app
