#include "io/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/errors.h"

namespace erg {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_text = std::size_t{1} << 20;

}  // namespace

std::string missing_file_remedy(const fs::path& path, const std::string& otherwise) {
  std::vector<std::string> names;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  const std::string near = nearest_word(path.filename().string(), names);
  return near.empty() ? otherwise : "did you mean \"" + (path.parent_path() / near).string() + "\"?";
}

std::string read_text_file(const fs::path& path, const std::string& kind) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path.string(), "this is a folder", "give the name of a " + kind);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const int reason = errno;
    if (fs::exists(path, error)) throw InputError(path.string(), "cannot read this file", std::strerror(reason));
    throw InputError(path.string(), "there is no such file", missing_file_remedy(path, "check its name and folder"));
  }
  std::string text(largest_text + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad()) throw InputError(path.string(), "cannot read this file", "check the disk");
  if (text.size() > largest_text)
    throw InputError(path.string(), "this file is too large", "give a text of at most 1 MiB; is it the right one?");
  return text;
}

}  // namespace erg
