// What a file browser shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace erg::session {

/// A file or folder in a folder.
struct FolderEntry {
  std::string name;
  std::filesystem::path path;
  bool folder = false;
  std::uint64_t bytes = 0;  ///< 0 for folders
  std::string changed;      ///< "2026-03-01 14:05", local; "" when unknown
};

/// One folder, read.
struct FolderListing {
  std::filesystem::path folder;      ///< absolute, without "." and ".."
  std::vector<FolderEntry> entries;  ///< folders first, then by name as people sort: without case, 2 before 10
  std::string problem;               ///< why it cannot be read; else empty
};

/// Reads a folder. Of the files only those whose name ends in one of `endings` (".json"; none: all) and contains
/// `filter`, whatever its case. Hidden files are left out unless the filter begins with a dot.
FolderListing list_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings = {},
                          const std::string& filter = {});

/// A place to start from.
struct Place {
  std::string label;
  std::filesystem::path path;
};
/// Home, documents and desktop where there are such, working folder, presets, root.
std::vector<Place> places(const std::filesystem::path& presets);

/// The path that a person means by what is typed while `folder` is shown: "~" is home, relative to the folder else.
std::filesystem::path typed_path(const std::string& text, const std::filesystem::path& folder);

/// The path with `ending` added unless it has it already.
std::filesystem::path with_ending(std::filesystem::path path, const std::string& ending);

/// What stands in the way of saving to this path.
enum class SaveQuestion {
  none,       ///< nothing: a new file in a folder that is there
  overwrite,  ///< there is such a file: ask
  no_folder,  ///< its folder does not exist
  is_folder,  ///< it is a folder itself
  no_name     ///< nothing was typed
};
/// Looks at the disk.
SaveQuestion save_question(const std::filesystem::path& path);

}  // namespace erg::session
