#include "io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "core/errors.h"

namespace erg {
namespace {

namespace fs = std::filesystem;

/// A new file beside the wanted one; removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target), name_(target.string() + ".XXXXXX") {
    descriptor_ = ::mkstemp(name_.data());
    if (descriptor_ < 0) fail();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail();
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void become_target() {
    if (::fchmod(descriptor_, permissions()) != 0) fail();
    if (::fsync(descriptor_) != 0) fail();
    if (::close(std::exchange(descriptor_, -1)) != 0) fail();
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail();
    renamed_ = true;
    flush_folder();
  }

 private:
  /// Those of the file that is replaced, else the usual ones (mkstemp's are the owner's alone).
  mode_t permissions() const {
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) return old.st_mode & 0777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }

  /// Makes the rename itself last. Some file systems cannot; the file is whole all the same.
  void flush_folder() const {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    if (opened < 0) return;
    ::fsync(opened);
    ::close(opened);
  }

  [[noreturn]] void fail() const {
    const int reason = errno;
    std::string remedy = "check that its folder exists, may be written and has room";
    if (reason == EISDIR) remedy = "it is a folder; give the name of a file";
    throw InputError(target_.string(), std::string("cannot write this file (") + std::strerror(reason) + ")", remedy);
  }

  fs::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view content) {
  TemporaryFile file(path);
  file.write(content);
  file.become_target();
}

void write_file_atomically(const fs::path& path, const std::function<void(const ByteSink&)>& write) {
  TemporaryFile file(path);
  write([&file](std::string_view content) { file.write(content); });
  file.become_target();
}

}  // namespace erg
