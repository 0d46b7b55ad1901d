// What an executor has to tell the user: a device that is missing or was lost.
#pragma once

#include "transport/executor.h"

namespace erg {

/// Prints it on standard error, where there is something.
void print_notice(Executor& executor);

}  // namespace erg
