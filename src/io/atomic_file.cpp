#include "io/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "core/errors.h"

namespace erg {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const fs::path& path) {
  const int reason = errno;
  const char* remedy = reason == EISDIR ? "it is a folder; give the name of a file"
                                        : "check that its folder exists, may be written and has room";
  throw WriteError(path.string(), std::string("cannot write this file (") + std::strerror(reason) + ")", remedy);
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// What the system calls an open file by; closed whatever happens.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

 private:
  int number_;
};

/// A file that was opened.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags) : path_(path), file_(::open(path.c_str(), flags | O_CLOEXEC)) {
    if (!file_.is_open()) fail_to_write(path_);
  }

  void write(std::string_view content) const {
    if (!write_all(file_.number(), content)) fail_to_write(path_);
  }
  /// The same; what had been written of it when it failed is taken back.
  void write_whole(std::string_view content) const {
    struct stat before {};
    if (::fstat(file_.number(), &before) != 0) fail_to_write(path_);
    if (write_all(file_.number(), content)) return;
    const int reason = errno;
    if (S_ISREG(before.st_mode)) static_cast<void>(::ftruncate(file_.number(), before.st_size));
    errno = reason;
    fail_to_write(path_);
  }

 private:
  fs::path path_;
  Descriptor file_;
};

bool same_file(const struct stat& one, const struct stat& other) {
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

/// Opens a file that nobody else writes to, made when missing; not open when somebody does, or when it cannot be.
Descriptor open_alone(const std::string& name) {
  while (true) {
    Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!file.is_open()) return file;
    const bool taken = ::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (taken) return Descriptor(-1);
    struct stat opened {};
    struct stat named {};
    // A writer that ended in the meantime has taken the file away, or given it its own name.
    const bool there =
        ::fstat(file.number(), &opened) == 0 && ::stat(name.c_str(), &named) == 0 && same_file(opened, named);
    if (there) return file;
  }
}

/// The unfinished file beside the wanted one, locked as long as it is written; removed again unless it was renamed.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const fs::path& target) : target_(target) {
    // A name is taken while another writer lives. One that was killed has left its lock, and its file is written over.
    for (int attempt = 0; !file_.is_open() && attempt < 100; ++attempt) {
      name_ = unfinished_name(target).string() + (attempt > 0 ? std::to_string(attempt) : "");
      file_ = open_alone(name_);
    }
    if (!file_.is_open() || ::ftruncate(file_.number(), 0) != 0) fail_to_write(target_);
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile() {
    if (!renamed_) ::unlink(name_.c_str());  // before the file is closed and another writer may have its name
  }

  void write(std::string_view content) {
    if (!write_all(file_.number(), content)) fail_to_write(target_);
  }

  void become_target() {
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(file_.number(), old.st_mode & 0777);  // else the usual permissions
    // Closed only afterwards: until it has its name nobody else may write to it.
    if (::fsync(file_.number()) != 0 || ::rename(name_.c_str(), target_.c_str()) != 0) fail_to_write(target_);
    renamed_ = true;
    flush_folder();
  }

 private:
  /// Makes the rename itself last. Some file systems cannot; the file is whole all the same.
  void flush_folder() const {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.is_open()) ::fsync(opened.number());
  }

  fs::path target_;
  std::string name_;
  Descriptor file_{-1};
  bool renamed_ = false;
};

}  // namespace

fs::path unfinished_name(const fs::path& target) { return target.string() + ".part-erg"; }

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, [content](const ByteSink& sink) { sink(content); });
}

void write_file_atomically(const fs::path& path, const std::function<void(const ByteSink&)>& write) {
  std::error_code none;
  if (fs::exists(path, none) && !fs::is_regular_file(path, none)) {
    const OpenFile file(path, O_WRONLY);
    return write([&file](std::string_view content) { file.write(content); });
  }
  UnfinishedFile file(fs::is_symlink(path, none) ? fs::weakly_canonical(path) : path);
  write([&file](std::string_view content) { file.write(content); });
  file.become_target();
}

void append_to_file(const fs::path& path, std::string_view content) {
  OpenFile(path, O_WRONLY | O_APPEND).write_whole(content);
}

}  // namespace erg
