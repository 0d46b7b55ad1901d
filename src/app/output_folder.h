// Folders that files are written into: what is wrong with them should be known before long work, not after it.
#pragma once

#include <filesystem>
#include <string>

namespace erg {

/// Makes a folder, and those above it, where they are missing. Throws InputError when it cannot.
void make_folder(const std::filesystem::path& folder);

/// Throws InputError when the folder of a file is not there. `option`: what named the file, such as "--stats"; an empty
/// `file` is none and is good.
void check_folder_of(const std::string& option, const std::string& file);

}  // namespace erg
