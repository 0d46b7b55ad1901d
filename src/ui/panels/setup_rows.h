// Rows of a setup, made from the declarations.
#pragma once

#include <string>

#include "session/setup.h"

namespace erg::ui {

/// Draws the rows of one group that have an effect ("grid", "scene", "parameters", "run") and enters what is changed.
/// `running`: the config of the run now, or null. Returns the key of a path whose file is to be chosen from the
/// browser, else "".
std::string draw_setup_rows(session::Setup& setup, const std::string& group, const sim::Config* running);

}  // namespace erg::ui
