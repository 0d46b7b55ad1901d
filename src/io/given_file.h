// Text files that people give.
#pragma once

#include <filesystem>
#include <string>

namespace erg {

/// All of a file of at most 1 MiB, far more than any config or camera; so a wrong file fills neither memory nor time.
/// `kind` says in errors what it should be: "config file". Throws InputError where it cannot be read.
std::string read_text_file(const std::filesystem::path& path, const std::string& kind);

/// "did you mean" the file in the same folder with nearly the same name, or `otherwise`.
std::string missing_file_remedy(const std::filesystem::path& path, const std::string& otherwise);

}  // namespace erg
