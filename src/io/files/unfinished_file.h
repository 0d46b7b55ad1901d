// What files are written through: open files, and the one that lies beside the wanted one until it is whole. For
// atomic_file.cpp and growing_file.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace erg::io {

/// Throws the WriteError that `errno` stands for.
[[noreturn]] void fail_to_write(const std::filesystem::path& path);

/// The file that a path means: of a link the one that it leads to. Throws WriteError where links lead in a circle.
std::filesystem::path link_target(const std::filesystem::path& path);

/// What the system calls an open file by; closed whatever happens.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Whether a path leads to this very file.
  bool is_at(const std::string& path) const;
  /// Writes all of it; false, and why in `errno`, when that fails.
  bool write(std::string_view content) const;

 private:
  int number_;
};

/// Opens a file; not open, and why in `errno`, where that fails.
Descriptor open_file(const std::string& path, int flags);

/// Opens a file that nobody else writes to, made when missing; it is locked as long as it is open. Not open when it
/// cannot be, with EWOULDBLOCK in `errno` where somebody else holds it. A file system without locks is taken at its
/// word.
Descriptor open_alone(const std::string& path);

/// The unfinished file beside the wanted one, locked as long as it is written; removed again unless it was renamed.
class UnfinishedFile {
 public:
  /// Throws WriteError, as do the others.
  explicit UnfinishedFile(const std::filesystem::path& target);
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();

  void write(std::string_view content);
  /// Flushes it to the disk and gives it the wanted name. Returns the file, still open and locked.
  Descriptor become_target();

 private:
  std::filesystem::path target_;
  std::string name_;
  Descriptor file_;
  bool renamed_ = false;
};

}  // namespace erg::io
