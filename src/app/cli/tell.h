// Errors as the command line tells them.
#pragma once

#include <exception>

namespace erg::app {

/// Prints an error on standard error: each mistake of an InputError on a line of its own.
void tell(const std::exception& error);

}  // namespace erg::app
