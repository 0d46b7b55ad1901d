#include "sim/make_executor.h"

#include "core/errors.h"
#include "cuda/cuda_backend.h"
#include "sim/cuda_entries.h"

namespace erg::sim {

using compute::Executor;
using compute::ExecutorOptions;
using cuda::cuda_api;
using cuda::make_cuda_executor;

namespace {

/// Without a device it is `cpu`, which needs no notice where nobody asked for a device.
std::unique_ptr<Executor> make_fastest(const ExecutorOptions& options) {
  auto executor = make_cuda_executor(options, cuda_api(), cuda_entry);
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
  if (options.name == "serial" || options.name == "cpu") return std::make_unique<Executor>(options);
  if (options.name == "cuda") return make_cuda_executor(options, cuda_api(), cuda_entry);
  throw InputError("executor", "unknown executor \"" + options.name + "\"", suggestion(options.name, executor_names()));
}

}  // namespace erg::sim
