// A name that one program at a time writes files under.
#pragma once

#include <filesystem>
#include <string>

#include "io/files/unfinished_file.h"

namespace erg::io {

/// Holds a name as long as it lives; a program that is killed lets go of it. Beside the files of that name lies a
/// hidden one meanwhile, locked. Where it cannot be made, or the file system knows no locks, nobody is kept out.
class HeldName {
 public:
  /// `path`: a folder that is there, and how the names of the files in it begin. Throws InputError where another run
  /// holds that name.
  explicit HeldName(const std::filesystem::path& path);
  HeldName(const HeldName&) = delete;
  HeldName& operator=(const HeldName&) = delete;
  ~HeldName();

 private:
  std::string lock_;
  Descriptor file_;
};

}  // namespace erg::io
