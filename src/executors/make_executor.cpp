// Every executor by name.
#include <algorithm>

#include "core/errors.h"
#include "cuda/cuda_executor.h"
#include "process/allowance.h"
#include "transport/serial_executor.h"

namespace erg {
namespace {

/// Without a device it is `cpu`, which needs no notice where nobody asked for a device.
std::unique_ptr<Executor> make_fastest(const ExecutorOptions& options) {
  auto executor = std::make_unique<CudaExecutor>(options, cuda_calls());
  executor->take_notice();
  return executor;
}

}  // namespace

const std::vector<std::string>& executor_names() {
  static const std::vector<std::string> names{"auto", "serial", "cpu", "cuda"};
  return names;
}

std::unique_ptr<Executor> make_executor(const ExecutorOptions& options) {
  ExecutorOptions chosen = options;
  if (chosen.threads <= 0) chosen.threads = process::allowed_threads();
  if (options.name == "auto") return make_fastest(chosen);
  if (options.name == "serial") return std::make_unique<SerialExecutor>();
  if (options.name == "cpu") return std::make_unique<ParallelExecutor>(chosen);
  if (options.name == "cuda") return std::make_unique<CudaExecutor>(chosen, cuda_calls());
  throw InputError("executor", "unknown executor \"" + options.name + "\"", suggestion(options.name, executor_names()));
}

}  // namespace erg
