// The CUDA runtime behind DeviceCalls, and the kernels compiled for the device. The only file that nvcc sees.
#include <cuda_runtime.h>

#include "cuda/device_calls.h"
#include "cuda/kernel_table.h"

namespace erg {
namespace {

class CudaCalls : public DeviceCalls {
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
  Status launch(DeviceKernel kernel, int blocks, const DevicePlan& plan, void* stream) override {
    return start(on_device::kernel_of(kernel), blocks, plan, stream);
  }
  Status launch(LayerKernel kernel, int blocks, const LayerPlan& plan, void* stream) override {
    return start(on_device::kernel_of(kernel), blocks, plan, stream);
  }
  Status launch(SnowKernel kernel, int blocks, const SnowPlan& plan, void* stream) override {
    return start(on_device::kernel_of(kernel), blocks, plan, stream);
  }
  Status launch(GrainKernel kernel, int blocks, const GrainPlan& plan, void* stream) override {
    return start(on_device::kernel_of(kernel), blocks, plan, stream);
  }

 private:
  template <typename Plan>
  static Status start(void (*kernel)(Plan), int blocks, const Plan& plan, void* stream) {
    kernel<<<blocks, device_block, 0, static_cast<cudaStream_t>(stream)>>>(plan);
    return cudaGetLastError();
  }
};

}  // namespace

std::unique_ptr<DeviceCalls> cuda_calls() { return std::make_unique<CudaCalls>(); }

}  // namespace erg
