#include "io/files/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "io/files/unfinished_file.h"

namespace erg::io {
namespace {

namespace fs = std::filesystem;

/// Something that is there and is no file to be replaced: a device, a pipe, a folder.
bool is_no_file(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none) && !fs::is_regular_file(path, none);
}

}  // namespace

fs::path unfinished_name(const fs::path& target) { return target.string() + ".part-erg"; }

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, [content](const ByteSink& sink) { sink(content); });
}

void write_file_atomically(const fs::path& path, const std::function<void(const ByteSink&)>& write) {
  if (is_no_file(path)) {
    const Descriptor file = open_file(path.string(), O_WRONLY);
    if (!file.is_open()) fail_to_write(path);
    return write([&](std::string_view content) {
      if (!file.write(content)) fail_to_write(path);
    });
  }
  UnfinishedFile file(link_target(path));
  write([&file](std::string_view content) { file.write(content); });
  file.become_target();
}

void try_to_write(const fs::path& path) {
  if (!is_no_file(path)) {
    const UnfinishedFile file(link_target(path));
    return;
  }
  std::error_code none;
  if (fs::is_directory(path, none)) {
    errno = EISDIR;
    fail_to_write(path);
  }
  if (::access(path.c_str(), W_OK) != 0) fail_to_write(path);
}

}  // namespace erg::io
