// The preset configs of a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace erg::io {

/// A config that comes with the program.
struct Preset {
  std::string name;  ///< path below the folder without ".json": "barchans", "thesis/star_werner"
  std::filesystem::path path;
};

/// Every preset of a folder and the folders in it: those at the top first, then by name. None when it is not there.
std::vector<Preset> list_presets(const std::filesystem::path& folder);

/// Where a preset's picture lies: NAME.jpg in the folder `gallery` beside the presets (`erg gallery` makes them).
std::filesystem::path preset_picture(const std::filesystem::path& folder, const std::string& name);

}  // namespace erg::io
