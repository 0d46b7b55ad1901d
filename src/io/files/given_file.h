// Files that people give: what is wrong with a path, and texts read whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/errors.h"

namespace erg::io {

/// What stands against reading a file under this path, or nothing: that it is not there (with the path that was most
/// likely meant: another case, slashes the other way, a letter off), that it is a folder, that links lead in a circle
/// or to nothing, that it may not be looked at. `kind` says what it should be: "picture". A pipe is a file.
std::optional<Mistake> file_trouble(const std::filesystem::path& path, const std::string& kind);

/// A path that is there and that was most likely meant by one that is not; "" if there is none.
std::string nearest_path(const std::filesystem::path& path);

/// Whether this names no place in a folder: "-" (standard input), a pipe, a device, /dev/stdin, /dev/fd/63.
bool is_stream(const std::filesystem::path& path);

/// All of a file of at most 16 MiB, more than a wind of a hundred thousand seasons takes; so a wrong file fills neither
/// memory nor time.
/// "-" is standard input. `kind` says in errors what it should be: "config file". A mark that says UTF-8 (BOM) is left
/// out. Throws InputError where it cannot be read, and where its text is not UTF-8, with what it is instead.
std::string read_text_file(const std::filesystem::path& path, const std::string& kind);

}  // namespace erg::io
