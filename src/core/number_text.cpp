#include "core/number_text.h"

#include <cstdio>

namespace erg {

std::string format_shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string unit_text(std::string_view unit) {
  std::string text(unit);
  std::erase(text, '^');
  if (text.starts_with("deg")) text.replace(0, text.starts_with("deg ") ? 4 : 3, "°");
  if (text.ends_with('2')) text.replace(text.size() - 1, 1, "²");
  if (text.ends_with('3')) text.replace(text.size() - 1, 1, "³");
  return text;
}

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace erg
