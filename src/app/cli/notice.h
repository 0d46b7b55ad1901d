// What an executor has to tell the user: a device that is missing or was lost.
#pragma once

#include <string>
#include <vector>

#include "compute/executor.h"

namespace erg::app {

/// Prints it on standard error, where there is something.
void print_notice(compute::Executor& executor);

/// Prints what is worth telling of what was given, line by line, on standard error.
void print_notes(const std::vector<std::string>& notes);

}  // namespace erg::app
