#include "io/files/unfinished_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "io/files/atomic_file.h"

namespace erg::io {
namespace {

namespace fs = std::filesystem;

const char* remedy_of(int reason) {
  switch (reason) {
    case EISDIR:
      return "it is a folder; give the name of a file";
    case ENAMETOOLONG:
      return "give a shorter name";
    case ENOSPC:
    case EDQUOT:
      return "make room on its disk";
    case EFBIG:
      return "files may not grow so large here (ulimit -f)";
    case EACCES:
    case EPERM:
    case EROFS:
      return "give a folder that you may write to";
    case ELOOP:
      return "its links lead in a circle";
    default:
      return "check that its folder exists, may be written and has room";
  }
}

// What take_disk_notice tells, once in the life of the program.
enum class Flushing { works, refused, told };
std::atomic<Flushing> flushing{Flushing::works};

/// Whether a file's content is lost, or may be: the other errors say that a file system has no such call.
bool is_lost(int reason) {
  return reason == EIO || reason == ENOSPC || reason == EDQUOT || reason == EFBIG || reason == ESTALE ||
         reason == EBADF;
}

/// Brings a file to the disk; false, and why in `errno`, when it does not arrive there. A file system that does not
/// know fsync writes in its own time; some of those tell what went wrong when a file is closed.
bool flush(const Descriptor& file) {
  while (::fsync(file.number()) != 0) {
    if (errno == EINTR) continue;
    if (is_lost(errno)) return false;
    Flushing before = Flushing::works;
    flushing.compare_exchange_strong(before, Flushing::refused);
    const int copy = ::dup(file.number());
    return copy < 0 || ::close(copy) == 0 || !is_lost(errno);
  }
  return true;
}

}  // namespace

std::string take_disk_notice() {
  Flushing before = Flushing::refused;
  if (!flushing.compare_exchange_strong(before, Flushing::told)) return {};
  return "the file system does not let files be flushed to the disk (fsync); they are written all the same, and safe "
         "from a power cut only once the system has written them";
}

void fail_to_write(const fs::path& path) {
  const int reason = errno;
  throw WriteError(path.string(), std::string("cannot write this file (") + std::strerror(reason) + ")",
                   remedy_of(reason));
}

fs::path link_target(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  fs::path target = fs::weakly_canonical(path, error);
  if (!error) return target;
  errno = error.value();
  fail_to_write(path);
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

bool Descriptor::is_at(const std::string& path) const {
  struct stat opened {};
  struct stat named {};
  return ::fstat(number_, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

bool Descriptor::write(std::string_view content) const {
  while (!content.empty()) {
    const ssize_t written = ::write(number_, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

Descriptor open_file(const std::string& path, int flags) {
  int number = -1;
  do {
    number = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  } while (number < 0 && errno == EINTR);
  return Descriptor(number);
}

Descriptor open_alone(const std::string& path) {
  while (true) {
    Descriptor file = open_file(path, O_WRONLY | O_CREAT | O_NOFOLLOW);
    if (!file.is_open()) return file;
    if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      file = Descriptor();
      errno = EWOULDBLOCK;
      return file;
    }
    // A writer that ended in the meantime has taken the file away, or given it its own name.
    if (file.is_at(path)) return file;
  }
}

UnfinishedFile::UnfinishedFile(const fs::path& target) : target_(target) {
  // A name is taken while another writer lives. One that was killed has left its lock, and its file is written over.
  for (int attempt = 0; !file_.is_open() && attempt < 100; ++attempt) {
    name_ = unfinished_name(target).string() + (attempt > 0 ? std::to_string(attempt) : "");
    file_ = open_alone(name_);
  }
  if (!file_.is_open() || ::ftruncate(file_.number(), 0) != 0) fail_to_write(target_);
}

UnfinishedFile::~UnfinishedFile() {
  // Before the file is closed and another writer may have its name.
  if (!renamed_ && file_.is_open()) ::unlink(name_.c_str());
}

void UnfinishedFile::write(std::string_view content) {
  if (!file_.write(content)) fail_to_write(target_);
}

Descriptor UnfinishedFile::become_target() {
  struct stat old {};
  if (::stat(target_.c_str(), &old) == 0) ::fchmod(file_.number(), old.st_mode & 0777);  // else the usual permissions
  // Closed only afterwards: until it has its name nobody else may write to it.
  if (!flush(file_) || ::rename(name_.c_str(), target_.c_str()) != 0) fail_to_write(target_);
  renamed_ = true;
  // Makes the rename itself last. Some file systems cannot; the file is whole all the same.
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  const Descriptor opened = open_file(folder.string(), O_RDONLY | O_DIRECTORY);
  if (opened.is_open()) ::fsync(opened.number());
  return std::move(file_);
}

}  // namespace erg::io
