// Standard output and its kin: what happens where nobody reads them, or nothing can be written to them.
#pragma once

#include <string>

namespace erg::app {

/// To be called before anything is opened. A stream that is closed is opened on nothing, or else the next file would
/// take its place and be written into; writing to it fails. A pipe that nobody reads and a file that may not grow
/// (SIGPIPE, SIGXFSZ) are errors of writing and do not end the program.
void guard_standard_streams();

/// Why not all that was printed arrived; empty when it did. To be called at the end.
std::string output_problem();

}  // namespace erg::app
