// `erg gui`.
#pragma once

#include "app/cli/command.h"

namespace erg::app {

/// Adds the command to `program`; when it is named, `action` is set.
void add_gui_command(CLI::App& program, Action& action);

/// What `erg` does when no command is named.
ExitCode open_gallery_window();

}  // namespace erg::app
