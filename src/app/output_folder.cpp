#include "app/output_folder.h"

#include <system_error>

#include "core/errors.h"

namespace erg {

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!failed && std::filesystem::is_directory(folder)) return;
  throw InputError(folder.string(), "cannot make this folder" + (failed ? ": " + failed.message() : ""),
                   "give a folder that can be written, with --out");
}

void check_folder_of(const std::string& option, const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  throw InputError(option + " " + file, "there is no folder " + folder.string(), "make it first");
}

}  // namespace erg
