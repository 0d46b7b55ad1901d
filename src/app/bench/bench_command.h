// `erg bench`.
#pragma once

#include "app/cli/command.h"

namespace erg::app {

/// Adds the command to `program`; when it is named, `action` is set.
void add_bench_command(CLI::App& program, Action& action);

}  // namespace erg::app
