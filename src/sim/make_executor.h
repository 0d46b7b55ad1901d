// Every executor by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compute/executor.h"

namespace erg::sim {

/// "auto", "serial", "cpu", "cuda".
const std::vector<std::string>& executor_names();

/// Throws InputError for an unknown name. "cuda" where no device works is the processor with a notice; "auto" then is
/// the processor without one.
std::unique_ptr<compute::Executor> make_executor(const compute::ExecutorOptions& options);

}  // namespace erg::sim
