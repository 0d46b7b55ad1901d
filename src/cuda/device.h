// A graphics card as the executor uses it: memory that frees itself, copies in pieces through pinned memory, launches.
// Whatever goes wrong is a DeviceError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cuda/device_calls.h"

namespace erg {

/// A device that is missing, full or broken. The text is a clause: "out of memory (asked for 64 MiB)".
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <typename T>
class DeviceArray;

class Device {
 public:
  /// The first device. Throws DeviceError if there is none that works.
  explicit Device(std::unique_ptr<DeviceCalls> calls);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const std::string& name() const { return name_; }

  void* allocate(std::size_t bytes);
  void release(void* memory) { calls_->release(memory); }
  /// Makes an array one of `count` values, which are then undefined, unless it has so many.
  template <typename T>
  void fit(DeviceArray<T>& array, std::size_t count);
  void fill(void* memory, int byte, std::size_t bytes);
  /// Starts a kernel on `items` items.
  template <typename Kernel, typename Plan>
  void launch(Kernel kernel, std::int64_t items, const Plan& plan) {
    check(calls_->launch(kernel, blocks_for(items), plan, stream_), "starting a kernel");
  }

  /// Copies `bytes` to the device, in pieces that `pack(target, first byte, bytes)` writes: the processor packs one
  /// while the one before is on its way.
  using Pack = std::function<void(std::byte* target, std::size_t first, std::size_t bytes)>;
  void copy_in(void* memory, std::size_t bytes, const Pack& pack);
  /// The same from the device: `unpack(source, first byte, bytes)` reads each piece.
  using Unpack = std::function<void(const std::byte* source, std::size_t first, std::size_t bytes)>;
  void copy_out(const void* memory, std::size_t bytes, const Unpack& unpack);

  /// Copies `count` values from the device.
  template <typename T>
  std::vector<T> fetch(const T* memory, std::size_t count) {
    std::vector<T> values(count);
    copy_out(memory, count * sizeof(T), [&](const std::byte* source, std::size_t first, std::size_t bytes) {
      std::memcpy(reinterpret_cast<std::byte*>(values.data()) + first, source, bytes);
    });
    return values;
  }
  /// Sends values from the processor's memory as they are.
  template <typename T>
  void send(T* memory, const T* values, std::size_t count) {
    copy_in(memory, count * sizeof(T), [&](std::byte* target, std::size_t first, std::size_t bytes) {
      std::memcpy(target, reinterpret_cast<const std::byte*>(values) + first, bytes);
    });
  }

  /// Sends value(number) of each element of an array.
  template <typename Value>
  void send_each(const DeviceArray<std::int32_t>& array, const Value& value);

  /// Bytes of a piece; a multiple of every element's size.
  static constexpr std::size_t piece_bytes = std::size_t{1} << 22;

 private:
  struct Piece {
    std::byte* pinned = nullptr;
    void* copied = nullptr;  // event
  };
  void open();
  void close();
  static int blocks_for(std::int64_t items);
  void check(DeviceCalls::Status status, const char* doing);

  std::unique_ptr<DeviceCalls> calls_;
  std::string name_;
  void* stream_ = nullptr;
  Piece pieces_[2];
};

/// An array in the device's memory.
template <typename T>
class DeviceArray {
 public:
  DeviceArray() = default;
  DeviceArray(Device& device, std::size_t count)
      : device_(&device), count_(count), data_(static_cast<T*>(device.allocate(count * sizeof(T)))) {}
  ~DeviceArray() { reset(); }
  DeviceArray(DeviceArray&& other) noexcept
      : device_(other.device_), count_(std::exchange(other.count_, 0)), data_(std::exchange(other.data_, nullptr)) {}
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    reset();
    device_ = other.device_;
    count_ = std::exchange(other.count_, 0);
    data_ = std::exchange(other.data_, nullptr);
    return *this;
  }

  T* data() const { return data_; }
  std::size_t size() const { return count_; }
  std::size_t bytes() const { return count_ * sizeof(T); }

 private:
  void reset() {
    if (data_ != nullptr) device_->release(data_);
    data_ = nullptr;
  }

  Device* device_ = nullptr;
  std::size_t count_ = 0;
  T* data_ = nullptr;
};

template <typename T>
void Device::fit(DeviceArray<T>& array, std::size_t count) {
  if (array.size() == count) return;
  array = DeviceArray<T>();  // before the new one, which may not fit beside it
  if (count > 0) array = DeviceArray<T>(*this, count);
}

template <typename Value>
void Device::send_each(const DeviceArray<std::int32_t>& array, const Value& value) {
  copy_in(array.data(), array.bytes(), [&](std::byte* target, std::size_t first, std::size_t bytes) {
    auto* values = reinterpret_cast<std::int32_t*>(target);
    const std::size_t first_number = first / sizeof(std::int32_t);
    for (std::size_t k = 0; k < bytes / sizeof(std::int32_t); ++k) values[k] = value(first_number + k);
  });
}

}  // namespace erg
