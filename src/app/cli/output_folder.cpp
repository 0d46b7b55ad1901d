#include "app/cli/output_folder.h"

#include <algorithm>
#include <system_error>

#include "core/errors.h"
#include "io/files/atomic_file.h"

namespace erg::app {
namespace {

namespace fs = std::filesystem;

/// Whether making `made` makes `folder` too.
bool is_made_with(const fs::path& folder, const fs::path& made) {
  if (made.empty()) return false;
  // Without what a "." or a slash at the end adds.
  const auto plain = [](const fs::path& path) { return (fs::absolute(path) / ".").lexically_normal().parent_path(); };
  const fs::path below = plain(made);
  const fs::path above = plain(folder);
  return std::mismatch(above.begin(), above.end(), below.begin(), below.end()).first == above.end();
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  std::error_code none;
  if (!failed && fs::is_directory(folder, none)) return;
  throw InputError(folder.string(), "cannot make this folder" + (failed ? " (" + failed.message() + ")" : ""),
                   "give a folder that can be written, with --out");
}

void try_output(const std::string& place, const fs::path& file) {
  try {
    io::try_to_write(file);
  } catch (const io::WriteError& error) {  // nothing has been done yet: what was asked for is wrong
    const Mistake& mistake = error.mistakes().front();
    throw InputError(place, mistake.problem, mistake.remedy);
  }
}

void check_output(const std::string& option, const std::string& file, const fs::path& made) {
  if (file.empty()) return;
  const fs::path folder = fs::path(file).parent_path();
  std::error_code none;
  if (folder.empty() || fs::is_directory(folder, none)) return try_output(option + " " + file, file);
  if (is_made_with(folder, made)) return;
  throw InputError(option + " " + file, "there is no folder " + folder.string(), "make it first");
}

}  // namespace erg::app
