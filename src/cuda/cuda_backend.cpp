#include "cuda/cuda_backend.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace erg::cuda {

using compute::DeviceError;
using compute::Executor;

namespace {

constexpr std::int64_t most_blocks = 1 << 20;

std::string size_text(std::size_t bytes) {
  const std::size_t mebibytes = bytes >> 20;
  return mebibytes > 0 ? std::to_string(mebibytes) + " MiB" : std::to_string(bytes) + " bytes";
}

}  // namespace

CudaBackend::CudaBackend(std::unique_ptr<CudaApi> api, CudaEntries entries) : api_(std::move(api)), entries_(entries) {
  if (!api_) throw DeviceError("this program was built without CUDA");
  try {
    open();
  } catch (const DeviceError&) {
    close();
    throw;
  }
}

CudaBackend::~CudaBackend() { close(); }

void CudaBackend::open() {
  int count = 0;
  check(api_->count_devices(count), "looking for a device");
  if (count == 0) throw DeviceError("there is no CUDA device");
  check(api_->choose_device(0), "choosing the device");
  check(api_->name_device(0, name_), "asking for the device's name");
  check(api_->create_stream(stream_), "creating a stream");
  for (Piece& piece : pieces_) {
    void* pinned = nullptr;
    check(api_->allocate_pinned(pinned, piece_bytes), "allocating pinned memory");
    piece.pinned = static_cast<std::byte*>(pinned);
    check(api_->create_event(piece.copied), "creating an event");
  }
}

void CudaBackend::close() {
  if (stream_ != nullptr) api_->wait_for_stream(stream_);  // pinned memory may still be under way
  for (Piece& piece : pieces_) {
    if (piece.copied != nullptr) api_->destroy_event(piece.copied);
    if (piece.pinned != nullptr) api_->release_pinned(piece.pinned);
  }
  if (stream_ != nullptr) api_->destroy_stream(stream_);
}

void CudaBackend::check(CudaApi::Status status, const char* doing) {
  if (status != 0) throw DeviceError(api_->error_text(status) + " (while " + doing + ")");
}

void* CudaBackend::allocate(std::size_t bytes) {
  void* memory = nullptr;
  if (const auto status = api_->allocate(memory, bytes); status != 0) {
    throw DeviceError(api_->error_text(status) + " (asked for " + size_text(bytes) + ")");
  }
  return memory;
}

void CudaBackend::fill(void* memory, int byte, std::size_t bytes) {
  check(api_->fill(memory, byte, bytes, stream_), "filling memory");
}

int CudaBackend::blocks_for(std::int64_t items) {
  return static_cast<int>(std::clamp<std::int64_t>((items + device_block - 1) / device_block, 1, most_blocks));
}

void CudaBackend::copy_in(void* memory, std::size_t bytes, const Pack& pack) {
  std::size_t number = 0;
  for (std::size_t first = 0; first < bytes; first += piece_bytes, ++number) {
    const Piece& piece = pieces_[number % 2];
    const std::size_t size = std::min(piece_bytes, bytes - first);
    check(api_->wait_for_event(piece.copied), "copying to the device");  // its last copy, which may be of long ago
    pack(piece.pinned, first, size);
    check(api_->copy_in(static_cast<std::byte*>(memory) + first, piece.pinned, size, stream_), "copying to the device");
    check(api_->record(piece.copied, stream_), "copying to the device");
  }
}

void CudaBackend::copy_out(const void* memory, std::size_t bytes, const Unpack& unpack) {
  const std::size_t count = (bytes + piece_bytes - 1) / piece_bytes;
  const auto size_of = [&](std::size_t number) { return std::min(piece_bytes, bytes - number * piece_bytes); };
  for (std::size_t number = 0; number <= count; ++number) {
    if (number < count) {
      const Piece& piece = pieces_[number % 2];
      check(api_->copy_out(piece.pinned, static_cast<const std::byte*>(memory) + number * piece_bytes, size_of(number),
                           stream_),
            "copying from the device");
      check(api_->record(piece.copied, stream_), "copying from the device");
    }
    if (number > 0) {
      const Piece& piece = pieces_[(number - 1) % 2];
      check(api_->wait_for_event(piece.copied), "computing");  // errors of kernels come to light here
      unpack(piece.pinned, (number - 1) * piece_bytes, size_of(number - 1));
    }
  }
}

void CudaBackend::launch(const compute::Kernel& kernel, std::int64_t items, const void* plan) {
  const void* const entry = entries_(kernel);
  if (entry == nullptr) throw DeviceError(std::string("there is no kernel ") + kernel.name + " for the device");
  check(api_->launch(entry, blocks_for(items), plan, stream_), "starting a kernel");
}

std::unique_ptr<Executor> make_cuda_executor(const compute::ExecutorOptions& options, std::unique_ptr<CudaApi> api,
                                             CudaEntries entries) {
  std::unique_ptr<compute::Backend> device;
  std::string notice;
  try {
    device = std::make_unique<CudaBackend>(std::move(api), entries);
  } catch (const DeviceError& error) {
    notice = std::string("cuda: ") + error.what() + "; computing on the processor";
  }
  return std::make_unique<Executor>(options, std::move(device), notice);
}

}  // namespace erg::cuda
