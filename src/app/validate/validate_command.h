// `erg validate`.
#pragma once

#include "app/cli/command.h"

namespace erg::app {

/// Adds the command to `program`; when it is named, `action` is set.
void add_validate_command(CLI::App& program, Action& action);

}  // namespace erg::app
