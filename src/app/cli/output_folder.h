// Where files are written to: what is wrong with a name or a folder should be known before long work, not after it.
#pragma once

#include <filesystem>
#include <string>

namespace erg::app {

/// Makes a folder, and those above it, where they are missing. Throws InputError when it cannot.
void make_folder(const std::filesystem::path& folder);

/// Tries whether a file can be written and leaves nothing behind. `place`: what to call it. Throws InputError.
void try_output(const std::string& place, const std::filesystem::path& file);

/// The same for the file that an option such as "--stats" names; an empty `file` is none and is good. `made`: a folder
/// that the command makes before it writes; what will lie in it, or above it, is tried only once it is there.
void check_output(const std::string& option, const std::string& file, const std::filesystem::path& made = {});

}  // namespace erg::app
