#include "io/files/growing_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io/files/atomic_file.h"

namespace erg::io {

namespace fs = std::filesystem;

GrowingFile::GrowingFile(const fs::path& path) : path_(link_target(path)) {
  std::error_code none;
  is_new_ = !fs::exists(path_, none);
  is_device_ = !is_new_ && !fs::is_regular_file(path_, none);
  file_ = is_device_ ? open_file(path_.string(), O_WRONLY | O_APPEND) : open_alone(path_.string());
  if (file_.is_open()) return;
  if (errno != EWOULDBLOCK) fail_to_write(path_);
  throw InputError(path_.string(), "another run is writing this file",
                   "give another folder with --out, or wait until it has ended");
}

void GrowingFile::replace(std::string_view content) {
  if (is_device_) {
    if (!file_.write(content)) fail_to_write(path_);
    return;
  }
  try {
    UnfinishedFile file(path_);
    file.write(content);
    file_ = file.become_target();  // which is locked; the lock on what lay there before goes only now
  } catch (const WriteError&) {
    if (is_new_) ::unlink(path_.c_str());
    throw;
  }
  is_new_ = false;
}

void GrowingFile::append(std::string_view content) {
  if (!is_device_ && !file_.is_at(path_.string())) {
    throw WriteError(path_.string(), "another file has taken this name while the run went on",
                     "give each run a folder of its own with --out");
  }
  struct stat before {};
  if (::fstat(file_.number(), &before) != 0) fail_to_write(path_);
  if (!is_device_ && ::lseek(file_.number(), before.st_size, SEEK_SET) < 0) fail_to_write(path_);
  if (file_.write(content)) return;
  const int reason = errno;
  if (!is_device_) static_cast<void>(::ftruncate(file_.number(), before.st_size));
  errno = reason;
  fail_to_write(path_);
}

}  // namespace erg::io
