// A graphics card under CUDA: memory, copies in pieces through pinned memory, launches. It knows kernels by a table of
// their entries, and no model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "compute/executor.h"
#include "cuda/cuda_api.h"

namespace erg::cuda {

/// The entry of a kernel on the card (a __global__ function that takes its plan); null where it has none.
using CudaEntries = const void* (*)(const compute::Kernel& kernel);

class CudaBackend : public compute::Backend {
 public:
  /// The first device. Throws DeviceError if there is none that works.
  CudaBackend(std::unique_ptr<CudaApi> api, CudaEntries entries);
  ~CudaBackend() override;
  CudaBackend(const CudaBackend&) = delete;
  CudaBackend& operator=(const CudaBackend&) = delete;

  std::string name() const override { return "cuda"; }
  int rows_a_thread() const override { return 32; }
  /// "NVIDIA H200".
  const std::string& device_name() const { return name_; }

  void* allocate(std::size_t bytes) override;
  void release(void* memory) override { api_->release(memory); }
  void fill(void* memory, int byte, std::size_t bytes) override;
  void copy_in(void* memory, std::size_t bytes, const Pack& pack) override;
  void copy_out(const void* memory, std::size_t bytes, const Unpack& unpack) override;
  void launch(const compute::Kernel& kernel, std::int64_t items, const void* plan) override;
  using compute::Backend::fill;
  using compute::Backend::launch;

  /// Bytes of a piece; a multiple of every element's size. The processor packs one while the one before is on its way.
  static constexpr std::size_t piece_bytes = std::size_t{1} << 22;

 private:
  struct Piece {
    std::byte* pinned = nullptr;
    void* copied = nullptr;  // event
  };
  void open();
  void close();
  static int blocks_for(std::int64_t items);
  void check(CudaApi::Status status, const char* doing);

  std::unique_ptr<CudaApi> api_;
  CudaEntries entries_;
  std::string name_;
  void* stream_ = nullptr;
  Piece pieces_[2];
};

/// The executor "cuda": on the card, or on the processor, with a notice, where no card works.
std::unique_ptr<compute::Executor> make_cuda_executor(const compute::ExecutorOptions& options,
                                                      std::unique_ptr<CudaApi> api, CudaEntries entries);

}  // namespace erg::cuda
