#include "io/files/given_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

#include "io/files/text_encoding.h"

namespace erg::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_text = std::size_t{16} << 20;

bool is_there(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

/// The path with each part that is not there replaced by the nearest name in its folder; "" where one has none.
fs::path walked(const fs::path& path) {
  fs::path found = path.root_path();
  for (const fs::path& part : path.relative_path()) {
    if (part.empty() || is_there(found / part)) {
      if (!part.empty()) found /= part;
      continue;
    }
    std::vector<std::string> names;
    std::error_code failed;
    const fs::path folder = found.empty() ? fs::path(".") : found;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
      names.push_back(entry->path().filename().string());
    }
    std::ranges::sort(names);  // or the disk decides between two that are as near
    const std::string near = nearest_word(part.string(), names);
    if (near.empty()) return {};
    found /= near;
  }
  return found;
}

/// Ways in which a path written elsewhere may be meant here.
std::vector<std::string> readings_of(const std::string& path) {
  std::string slashes = path;
  std::ranges::replace(slashes, '\\', '/');
  std::vector<std::string> readings{path, slashes};
  const std::size_t first = slashes.find_first_not_of('/');
  if (first != std::string::npos && first > 0) readings.push_back(slashes.substr(first));
  readings.push_back("/" + slashes);
  const char* const home = std::getenv("HOME");
  if (const std::size_t tilde = slashes.find("~/"); home != nullptr && tilde != std::string::npos) {
    readings.push_back(home + slashes.substr(tilde + 1));
  }
  return readings;
}

Mistake link_trouble(const fs::path& path) {
  std::error_code failed;
  const fs::path target = fs::read_symlink(path, failed);
  return {path.string(), "this is a link to " + quote(target.string()) + ", and nothing is there", "mend the link"};
}

std::string read_all(std::istream& stream, const fs::path& path) {
  constexpr std::size_t piece = std::size_t{1} << 16;
  std::string text;
  while (stream && text.size() <= largest_text) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    stream.read(text.data() + before, piece);
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(path.string(), "cannot read this file", "check the disk");
  if (text.size() > largest_text)
    throw InputError(path.string(), "this file is too large", "give a text of at most 16 MiB; is it the right one?");
  return text;
}

}  // namespace

std::string nearest_path(const fs::path& path) {
  const std::vector<std::string> readings = readings_of(path.string());
  for (const std::string& reading : readings) {
    if (reading != path.string() && is_there(reading)) return reading;
  }
  for (const std::string& reading : readings) {
    // Too far from what was said: a path of one part, and one that begins elsewhere.
    if (reading.find('\\') != std::string::npos || reading == "/" + readings[1]) continue;
    std::error_code failed;
    const fs::path found = walked(reading);
    if (!found.empty() && !fs::is_directory(found, failed)) return found.generic_string();
  }
  return "";
}

std::optional<Mistake> file_trouble(const fs::path& path, const std::string& kind) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (status.type() == fs::file_type::directory) {
    return Mistake{path.string(), "this is a folder", "give the name of a " + kind};
  }
  if (status.type() == fs::file_type::not_found) {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored)) return link_trouble(path);
    const std::string near = nearest_path(path);
    return Mistake{path.string(), "there is no such file",
                   near.empty() ? "check its name and folder" : "did you mean \"" + near + "\"?"};
  }
  if (!failed) return std::nullopt;
  if (failed == std::errc::too_many_symbolic_link_levels) {
    return Mistake{path.string(), "this is a link that leads back to itself", "mend the link"};
  }
  return Mistake{path.string(), "this file cannot be looked at", failed.message()};
}

bool is_stream(const fs::path& path) {
  const std::string text = path.string();
  if (text == "-" || text.starts_with("/dev/") || text.starts_with("/proc/")) return true;
  std::error_code failed;
  const fs::file_type type = fs::status(path, failed).type();
  return type == fs::file_type::fifo || type == fs::file_type::character || type == fs::file_type::socket;
}

std::string read_text_file(const fs::path& path, const std::string& kind) {
  if (path == "-") return utf8_text(read_all(std::cin, "standard input"), "standard input");
  if (const auto trouble = file_trouble(path, kind)) throw InputError({*trouble});
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path.string(), "cannot read this file", std::strerror(errno));
  return utf8_text(read_all(file, path), path.string());
}

}  // namespace erg::io
