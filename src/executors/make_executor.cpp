// Every executor by name.
#include "core/errors.h"
#include "cuda/cuda_executor.h"
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
  if (options.name == "auto") return make_fastest(options);
  if (options.name == "serial") return std::make_unique<SerialExecutor>();
  if (options.name == "cpu") return std::make_unique<ParallelExecutor>(options);
  if (options.name == "cuda") return std::make_unique<CudaExecutor>(options, cuda_calls());
  throw InputError("executor", "unknown executor \"" + options.name + "\"", suggestion(options.name, executor_names()));
}

}  // namespace erg
