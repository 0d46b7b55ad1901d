// Files written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/errors.h"

namespace erg::io {

/// A file that cannot be written: no room, no permission, no folder. What lay under its name is untouched.
class WriteError : public InputError {
 public:
  using InputError::InputError;
};

/// What a file is called until it is whole (a number follows where several programs write it at once). A writer that is
/// killed leaves it behind; the next one writes over it.
std::filesystem::path unfinished_name(const std::filesystem::path& target);

/// Writes `content` to `path`: first into a new file beside it, flushed to the disk, then renamed over it. So a reader,
/// or the next start after a power cut, sees the old file or the new one and nothing between. Folders must exist.
/// A link stays a link; a device or a pipe (/dev/stdout) is written to, not replaced.
/// Throws WriteError when it cannot; the old file is then untouched.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// Takes the next bytes of a file.
using ByteSink = std::function<void(std::string_view)>;

/// The same for content too large to hold in memory: `write` hands it over piece by piece. When `write` throws, the old
/// file is untouched too.
void write_file_atomically(const std::filesystem::path& path, const std::function<void(const ByteSink&)>& write);

/// Tries whether a file can be written under this name, as the above would, and leaves nothing behind: what is wrong
/// should be known before long work, not after it. Throws WriteError.
void try_to_write(const std::filesystem::path& path);

/// What the user should know of the disk, once in the life of the program: that its file system cannot flush. Empty
/// otherwise.
std::string take_disk_notice();

}  // namespace erg::io
