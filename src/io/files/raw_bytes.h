// Values as they lie in memory, for files in binary. All of them are little-endian.
#pragma once

#include <bit>
#include <string>

namespace erg::io {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

/// Adds the bytes of a number, or of an array of numbers, to `bytes`.
template <typename T>
void append_raw(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace erg::io
