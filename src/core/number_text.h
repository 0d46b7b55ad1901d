// Numbers as text that loses nothing.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace erg {

/// As few digits as read back as the same number: "0.1", "-2", "1e-06".
std::string format_shortest(double value);

/// Reads all of `text` as a number; nothing if it is none. "+3" is one.
template <typename Number>
std::optional<Number> number_from(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}
/// A unit as people read it, from its name in files: "°" for deg, "°C" for deg C, "m²" for m2, "kg/m³" for kg/m3;
/// others are the same.
std::string unit_text(std::string_view unit);

/// A hash as people see it: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace erg
