// A file that grows while a run goes on, and that one program at a time writes to.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/files/unfinished_file.h"

namespace erg::io {

/// Holds a file locked as long as it lives, under whatever name it was given; a program that is killed lets go of it.
/// Where a file system knows no locks nobody is kept out.
class GrowingFile {
 public:
  /// Takes the file; it is made when missing. Throws InputError where another run holds it, WriteError where it cannot
  /// be written.
  explicit GrowingFile(const std::filesystem::path& path);

  /// Writes it anew, whole or not at all. Throws WriteError; it is then as it was, or gone where it was not there
  /// before.
  void replace(std::string_view content);
  /// Adds to its end, whole or not at all. Throws WriteError where that fails, or where another file has taken the
  /// name since.
  void append(std::string_view content);

 private:
  std::filesystem::path path_;
  Descriptor file_;
  bool is_new_ = false;     ///< nothing was ever written
  bool is_device_ = false;  ///< or a pipe: neither locked nor replaced
};

}  // namespace erg::io
