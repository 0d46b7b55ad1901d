#include "process/program_files.h"

#include <system_error>

namespace erg::process {

std::filesystem::path program_folder(const std::string& name) {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return (program.parent_path() / ".." / "share" / "erg" / name).lexically_normal();
}

}  // namespace erg::process
