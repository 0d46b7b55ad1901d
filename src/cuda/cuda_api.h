// The few calls of the CUDA runtime that the back end makes, one to one, so that tests can stand in for them on a
// machine without a graphics card, and make any of them fail. Each returns 0 or an error number.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace erg::cuda {

/// Threads in a block of every launch.
inline constexpr int device_block = 256;

class CudaApi {
 public:
  using Status = int;
  virtual ~CudaApi() = default;

  virtual Status count_devices(int& count) = 0;
  virtual Status choose_device(int number) = 0;
  virtual Status name_device(int number, std::string& name) = 0;
  virtual std::string error_text(Status status) = 0;

  virtual Status allocate(void*& memory, std::size_t bytes) = 0;
  virtual void release(void* memory) = 0;
  virtual Status allocate_pinned(void*& memory, std::size_t bytes) = 0;
  virtual void release_pinned(void* memory) = 0;

  virtual Status create_stream(void*& stream) = 0;
  virtual void destroy_stream(void* stream) = 0;
  virtual Status wait_for_stream(void* stream) = 0;
  virtual Status create_event(void*& event) = 0;
  virtual void destroy_event(void* event) = 0;
  virtual Status record(void* event, void* stream) = 0;
  virtual Status wait_for_event(void* event) = 0;

  /// Copies between pinned and device memory; return before they are done.
  virtual Status copy_in(void* device, const void* pinned, std::size_t bytes, void* stream) = 0;
  virtual Status copy_out(void* pinned, const void* device, std::size_t bytes, void* stream) = 0;
  virtual Status fill(void* device, int byte, std::size_t bytes, void* stream) = 0;
  /// Starts an entry (CudaEntries) on so many blocks. It takes the plan by value.
  virtual Status launch(const void* entry, int blocks, const void* plan, void* stream) = 0;
};

/// The real ones; null where Erg was built without CUDA.
std::unique_ptr<CudaApi> cuda_api();

}  // namespace erg::cuda
