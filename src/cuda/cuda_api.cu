// The CUDA runtime behind CudaApi.
#include <cuda_runtime.h>

#include "cuda/cuda_api.h"

namespace erg::cuda {
namespace {

class CudaApiOfTheRuntime : public CudaApi {
 public:
  Status count_devices(int& count) override { return cudaGetDeviceCount(&count); }
  Status choose_device(int number) override { return cudaSetDevice(number); }
  Status name_device(int number, std::string& name) override {
    cudaDeviceProp properties;
    const cudaError_t status = cudaGetDeviceProperties(&properties, number);
    if (status == cudaSuccess) name = properties.name;
    return status;
  }
  std::string error_text(Status status) override { return cudaGetErrorString(static_cast<cudaError_t>(status)); }

  Status allocate(void*& memory, std::size_t bytes) override { return cudaMalloc(&memory, bytes); }
  void release(void* memory) override { cudaFree(memory); }
  Status allocate_pinned(void*& memory, std::size_t bytes) override { return cudaMallocHost(&memory, bytes); }
  void release_pinned(void* memory) override { cudaFreeHost(memory); }

  Status create_stream(void*& stream) override {
    return cudaStreamCreateWithFlags(reinterpret_cast<cudaStream_t*>(&stream), cudaStreamNonBlocking);
  }
  void destroy_stream(void* stream) override { cudaStreamDestroy(static_cast<cudaStream_t>(stream)); }
  Status wait_for_stream(void* stream) override { return cudaStreamSynchronize(static_cast<cudaStream_t>(stream)); }
  Status create_event(void*& event) override {
    return cudaEventCreateWithFlags(reinterpret_cast<cudaEvent_t*>(&event), cudaEventDisableTiming);
  }
  void destroy_event(void* event) override { cudaEventDestroy(static_cast<cudaEvent_t>(event)); }
  Status record(void* event, void* stream) override {
    return cudaEventRecord(static_cast<cudaEvent_t>(event), static_cast<cudaStream_t>(stream));
  }
  Status wait_for_event(void* event) override { return cudaEventSynchronize(static_cast<cudaEvent_t>(event)); }

  Status copy_in(void* device, const void* pinned, std::size_t bytes, void* stream) override {
    return cudaMemcpyAsync(device, pinned, bytes, cudaMemcpyHostToDevice, static_cast<cudaStream_t>(stream));
  }
  Status copy_out(void* pinned, const void* device, std::size_t bytes, void* stream) override {
    return cudaMemcpyAsync(pinned, device, bytes, cudaMemcpyDeviceToHost, static_cast<cudaStream_t>(stream));
  }
  Status fill(void* device, int byte, std::size_t bytes, void* stream) override {
    return cudaMemsetAsync(device, byte, bytes, static_cast<cudaStream_t>(stream));
  }
  Status launch(const void* entry, int blocks, const void* plan, void* stream) override {
    void* arguments[] = {const_cast<void*>(plan)};
    return cudaLaunchKernel(entry, dim3(static_cast<unsigned>(blocks)), dim3(device_block), arguments, 0,
                            static_cast<cudaStream_t>(stream));
  }
};

}  // namespace

std::unique_ptr<CudaApi> cuda_api() { return std::make_unique<CudaApiOfTheRuntime>(); }

}  // namespace erg::cuda
