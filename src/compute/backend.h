// A back end: where kernels run and their arrays lie. The processor is one (cpu_backend.h), a graphics card another
// (cuda/cuda_backend.h). Whatever goes wrong there is a DeviceError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "compute/kernel.h"

namespace erg::compute {

/// A device that is missing, full or broken. The text is a clause: "out of memory (asked for 64 MiB)".
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <typename T>
class Buffer;

class Backend {
 public:
  virtual ~Backend() = default;

  /// "cpu", "cuda".
  virtual std::string name() const = 0;
  /// Rows of a line that one thread follows: few where thousands of threads wait for work, all where a few do it all.
  virtual int rows_a_thread() const = 0;

  /// Memory with undefined contents, aligned for everything.
  virtual void* allocate(std::size_t bytes) = 0;
  virtual void release(void* memory) = 0;
  virtual void fill(void* memory, int byte, std::size_t bytes) = 0;
  /// Copies `bytes` in, in pieces that `pack(target, first byte, bytes)` writes: a card takes one while the next is
  /// packed. Pieces begin at multiples of every element's size.
  using Pack = std::function<void(std::byte* target, std::size_t first, std::size_t bytes)>;
  virtual void copy_in(void* memory, std::size_t bytes, const Pack& pack) = 0;
  /// The same way out: `unpack(source, first byte, bytes)` reads each piece. What was launched before is done by then.
  using Unpack = std::function<void(const std::byte* source, std::size_t first, std::size_t bytes)>;
  virtual void copy_out(const void* memory, std::size_t bytes, const Unpack& unpack) = 0;
  /// Starts a kernel on `items` items at least; launches follow each other.
  virtual void launch(const Kernel& kernel, std::int64_t items, const void* plan) = 0;

  /// The same for those who know the plan.
  template <typename Plan>
  void launch(const KernelOf<Plan>& kernel, std::int64_t items, const Plan& plan) {
    launch(static_cast<const Kernel&>(kernel), items, &plan);
  }
  /// Makes a buffer one of `count` values, which are then undefined, unless it has so many.
  template <typename T>
  void fit(Buffer<T>& buffer, std::size_t count);
  template <typename T>
  void fill(const Buffer<T>& buffer, int byte) {
    fill(buffer.data(), byte, buffer.bytes());
  }
  /// Copies `count` values out.
  template <typename T>
  std::vector<T> fetch(const T* memory, std::size_t count) {
    std::vector<T> values(count);
    copy_out(memory, count * sizeof(T), [&](const std::byte* source, std::size_t first, std::size_t bytes) {
      std::memcpy(reinterpret_cast<std::byte*>(values.data()) + first, source, bytes);
    });
    return values;
  }
  /// Copies values in as they are.
  template <typename T>
  void send(T* memory, const T* values, std::size_t count) {
    copy_in(memory, count * sizeof(T), [&](std::byte* target, std::size_t first, std::size_t bytes) {
      std::memcpy(target, reinterpret_cast<const std::byte*>(values) + first, bytes);
    });
  }
  /// Copies in value(number) of each element.
  template <typename T, typename Value>
  void send_each(const Buffer<T>& buffer, const Value& value);
  /// The sums over all slots of what kernels have counted in `words` words each.
  template <int words>
  Counters<words> read_counters(const Buffer<CounterWord>& buffer);
};

/// An array in a back end's memory, which must outlive it.
template <typename T>
class Buffer {
 public:
  Buffer() = default;
  Buffer(Backend& backend, std::size_t count)
      : backend_(&backend), count_(count), data_(static_cast<T*>(backend.allocate(count * sizeof(T)))) {}
  ~Buffer() { reset(); }
  Buffer(Buffer&& other) noexcept
      : backend_(other.backend_), count_(std::exchange(other.count_, 0)), data_(std::exchange(other.data_, nullptr)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    reset();
    backend_ = other.backend_;
    count_ = std::exchange(other.count_, 0);
    data_ = std::exchange(other.data_, nullptr);
    return *this;
  }

  T* data() const { return data_; }
  std::size_t size() const { return count_; }
  std::size_t bytes() const { return count_ * sizeof(T); }

 private:
  void reset() {
    if (data_ != nullptr) backend_->release(data_);
    data_ = nullptr;
  }

  Backend* backend_ = nullptr;
  std::size_t count_ = 0;
  T* data_ = nullptr;
};

template <typename T>
void Backend::fit(Buffer<T>& buffer, std::size_t count) {
  if (buffer.size() == count) return;
  buffer = Buffer<T>();  // before the new one, which may not fit beside it
  if (count > 0) buffer = Buffer<T>(*this, count);
}

template <typename T, typename Value>
void Backend::send_each(const Buffer<T>& buffer, const Value& value) {
  copy_in(buffer.data(), buffer.bytes(), [&](std::byte* target, std::size_t first, std::size_t bytes) {
    auto* values = reinterpret_cast<T*>(target);
    const std::size_t first_number = first / sizeof(T);
    for (std::size_t k = 0; k < bytes / sizeof(T); ++k) values[k] = value(first_number + k);
  });
}

template <int words>
Counters<words> Backend::read_counters(const Buffer<CounterWord>& buffer) {
  Counters<words> sums;
  const std::vector<CounterWord> all = fetch(buffer.data(), buffer.size());
  for (std::size_t k = 0; k < all.size(); ++k) sums.of[k % words] += static_cast<std::int64_t>(all[k]);
  return sums;
}

}  // namespace erg::compute
