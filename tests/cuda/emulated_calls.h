// A graphics card that is not there: the runtime's calls on ordinary memory, kernels run by threads of the processor in
// shuffled order. Any call can be made to fail.
#pragma once

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/random.h"
#include "cuda/cuda_backend.h"

namespace erg::test {

/// What a test sees of the card, and what it makes of it.
struct Card {
  int devices = 1;
  int threads = 1;                ///< of the processor, for a kernel's blocks
  int block = 64;                 ///< threads of a block; fewer than the real card's, so that small grids have several
  int most_blocks = 7;            ///< so that threads have several items
  std::uint64_t shuffle = 1;      ///< seed of the order of blocks and threads
  long long fail_at = -1;         ///< this call (counted from 0) and all that follow fail
  std::string fail_kind;          ///< or only calls of this kind, from `fail_at` of them on
  std::size_t memory = SIZE_MAX;  ///< bytes of device memory

  long long calls = 0;
  std::size_t bytes_out = 0;  ///< copied back
  std::map<std::string, long long> of_kind;
  std::map<void*, std::size_t> device_blocks;
  std::size_t device_bytes = 0;
  std::set<void*> pinned;
  int handles = 0;  ///< streams and events alive
};

inline constexpr int out_of_memory = 2;
inline constexpr int broken = 719;
inline constexpr int wrong_use = 1;

class EmulatedApi : public cuda::CudaApi {
 public:
  explicit EmulatedApi(std::shared_ptr<Card> card) : card_(std::move(card)) {}

  Status count_devices(int& count) override {
    count = card_->devices;
    return take("count");
  }
  Status choose_device(int number) override { return number < card_->devices ? take("choose") : wrong_use; }
  Status name_device(int, std::string& name) override {
    name = "an emulated card";
    return take("name");
  }
  std::string error_text(Status status) override {
    return status == out_of_memory ? "out of memory" : status == broken ? "unspecified launch failure" : "wrong use";
  }

  Status allocate(void*& memory, std::size_t bytes) override {
    if (const Status status = take("allocate"); status != 0) return out_of_memory;
    if (card_->device_bytes + bytes > card_->memory) return out_of_memory;
    memory = ::operator new (bytes, std::align_val_t{256});
    std::memset(memory, 0xa5, bytes);  // a real card hands out what was there
    card_->device_blocks[memory] = bytes;
    card_->device_bytes += bytes;
    return 0;
  }
  void release(void* memory) override {
    card_->device_bytes -= card_->device_blocks.at(memory);
    card_->device_blocks.erase(memory);
    ::operator delete (memory, std::align_val_t{256});
  }
  Status allocate_pinned(void*& memory, std::size_t bytes) override {
    if (const Status status = take("pin"); status != 0) return out_of_memory;
    memory = ::operator new(bytes);
    card_->pinned.insert(memory);
    return 0;
  }
  void release_pinned(void* memory) override {
    if (card_->pinned.erase(memory) == 1) ::operator delete(memory);
  }

  Status create_stream(void*& stream) override { return create(stream, "stream"); }
  void destroy_stream(void* stream) override { destroy(stream); }
  Status wait_for_stream(void*) override { return take("wait"); }
  Status create_event(void*& event) override { return create(event, "event"); }
  void destroy_event(void* event) override { destroy(event); }
  Status record(void*, void*) override { return take("record"); }
  Status wait_for_event(void*) override { return take("wait"); }

  Status copy_in(void* device, const void* pinned, std::size_t bytes, void*) override {
    if (!on_device(device, bytes)) return wrong_use;
    if (const Status status = take("copy"); status != 0) return status;
    std::memcpy(device, pinned, bytes);
    return 0;
  }
  Status copy_out(void* pinned, const void* device, std::size_t bytes, void*) override {
    if (!on_device(device, bytes)) return wrong_use;
    if (const Status status = take("copy"); status != 0) return status;
    std::memcpy(pinned, device, bytes);
    card_->bytes_out += bytes;
    return 0;
  }
  Status fill(void* device, int byte, std::size_t bytes, void*) override {
    if (!on_device(device, bytes)) return wrong_use;
    if (const Status status = take("fill"); status != 0) return status;
    std::memset(device, byte, bytes);
    return 0;
  }
  Status launch(const void* entry, int blocks, const void* plan, void*) override {
    if (const Status status = take("launch"); status != 0) return status;
    run(*static_cast<const compute::Kernel*>(entry),
        std::min(blocks * cuda::device_block / card_->block + 1, card_->most_blocks), plan);
    return 0;
  }

 private:
  Status take(const std::string& kind) {
    const long long number = card_->fail_kind.empty() ? card_->calls : card_->of_kind[kind];
    ++card_->calls;
    ++card_->of_kind[kind];
    const bool concerned = card_->fail_kind.empty() || card_->fail_kind == kind;
    return concerned && card_->fail_at >= 0 && number >= card_->fail_at ? broken : 0;
  }

  Status create(void*& handle, const char* kind) {
    if (const Status status = take(kind); status != 0) return status;
    handle = new int(0);
    ++card_->handles;
    return 0;
  }
  void destroy(void* handle) {
    delete static_cast<int*>(handle);
    --card_->handles;
  }

  bool on_device(const void* memory, std::size_t bytes) const {
    const auto* first = static_cast<const std::byte*>(memory);
    for (const auto& [block, size] : card_->device_blocks) {
      const auto* start = static_cast<const std::byte*>(block);
      if (first >= start && first + bytes <= start + size) return true;
    }
    return false;
  }

  std::vector<int> shuffled(int count, std::uint64_t word) const {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t last = order.size(); last > 1; --last) {
      word = mix64(word);
      std::swap(order[last - 1], order[word % last]);
    }
    return order;
  }

  /// Every thread of the launch once: blocks in shuffled order, shared out over real threads; within a block shuffled.
  void run(const compute::Kernel& kernel, int blocks, const void* plan) {
    const std::uint64_t word = mix64(card_->shuffle + static_cast<std::uint64_t>(card_->calls));
    const std::vector<int> block_order = shuffled(blocks, word);
    const std::vector<std::byte> given(static_cast<const std::byte*>(plan),
                                       static_cast<const std::byte*>(plan) + kernel.plan_bytes);  // by value
    const auto serve = [&](int member) {
      for (std::size_t k = static_cast<std::size_t>(member); k < block_order.size();
           k += static_cast<std::size_t>(card_->threads)) {
        const int block = block_order[k];
        for (const int thread : shuffled(card_->block, word ^ static_cast<std::uint64_t>(block))) {
          kernel.run(given.data(), {block * card_->block + thread, blocks * card_->block});
        }
      }
    };
    std::vector<std::thread> others;
    for (int member = 1; member < card_->threads; ++member) others.emplace_back(serve, member);
    serve(0);
    for (std::thread& other : others) other.join();
  }

  std::shared_ptr<Card> card_;
};

/// On this card a kernel is its own entry.
inline const void* emulated_entry(const compute::Kernel& kernel) { return &kernel; }

inline std::unique_ptr<cuda::CudaBackend> emulated_backend(const std::shared_ptr<Card>& card) {
  return std::make_unique<cuda::CudaBackend>(std::make_unique<EmulatedApi>(card), emulated_entry);
}

/// The executor "cuda" on an emulated card.
inline std::unique_ptr<compute::Executor> emulated_executor(const compute::ExecutorOptions& options,
                                                            const std::shared_ptr<Card>& card) {
  return cuda::make_cuda_executor(options, std::make_unique<EmulatedApi>(card), emulated_entry);
}

}  // namespace erg::test
