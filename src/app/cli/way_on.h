// What becomes of a run that ends before its last step: it is saved, and the way on is told.
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/run_output.h"
#include "app/cli/run_setup.h"

namespace erg::app {

/// A word as a shell reads it back: as it is where nothing in it means anything there, else in single quotes.
std::string shell_quoted(const std::string& word);

/// The command that goes on from a checkpoint, with the outputs that were asked for.
std::string way_on(const RunRequest& request, const std::filesystem::path& checkpoint);

/// Writes a checkpoint of the run as it stands, into the folder of its files or the usual one, and says on standard
/// error how to go on; from the last checkpoint where it cannot be written. `output` may be null. Does not throw.
void save_and_tell(const RunRequest& request, sim::Simulation& simulation, RunOutput* output,
                   const std::string& how_ended);

}  // namespace erg::app
