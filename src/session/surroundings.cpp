#include "session/surroundings.h"

#include <cstdlib>

namespace erg::session {

std::string local_time(const char* form, std::time_t moment) {
  std::tm local{};
  ::localtime_r(&moment, &local);
  char text[32];
  std::strftime(text, sizeof text, form, &local);
  return text;
}

std::filesystem::path path_from_environment(const char* name) {
  const char* value = std::getenv(name);
  const std::filesystem::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : std::filesystem::path();
}

}  // namespace erg::session
