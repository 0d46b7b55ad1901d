// Stamps: by them a thing knows whether what it keeps of another (a copy in a form of its own) is still so.
#pragma once

#include <cstdint>
#include <utility>

namespace erg {

/// A number that stands for what its owner holds now. No two stamps of a program are ever alike, so equal numbers mean
/// equal contents, whoever owned them: an owner that changes renews its stamp, a copy has one of its own, and what is
/// moved takes its stamp along and leaves a new one behind. Stamps say nothing about order and are not for files.
class Stamp {
 public:
  Stamp() : value_(next()) {}
  Stamp(const Stamp&) : Stamp() {}
  Stamp(Stamp&& other) noexcept : value_(std::exchange(other.value_, next())) {}
  Stamp& operator=(const Stamp& other) {
    if (this != &other) renew();
    return *this;
  }
  Stamp& operator=(Stamp&& other) noexcept {
    if (this != &other) value_ = std::exchange(other.value_, next());
    return *this;
  }
  ~Stamp() = default;

  /// To be called before every change of what it stands for.
  void renew() { value_ = next(); }
  /// Never 0, which stands for nothing.
  std::uint64_t value() const { return value_; }

 private:
  static std::uint64_t next() noexcept;  // any thread may ask

  std::uint64_t value_;
};

/// A value with its stamp: whoever keeps something made from it keeps the stamp too.
template <typename T>
class Stamped {
 public:
  Stamped() = default;
  explicit Stamped(T value) : value_(std::move(value)) {}

  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }
  /// Writable, to be written before anyone reads the stamp again.
  T& edit() {
    stamp_.renew();
    return value_;
  }
  std::uint64_t stamp() const { return stamp_.value(); }

 private:
  T value_{};
  Stamp stamp_;
};

}  // namespace erg
