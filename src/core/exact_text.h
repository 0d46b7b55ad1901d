// Numbers as text that loses nothing.
#pragma once

#include <cstdint>
#include <string>

namespace erg {

/// As few digits as read back as the same number: "0.1", "-2", "1e-06".
std::string exact_text(double value);

/// A hash as people see it: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace erg
