// Where the preset configs lie, and how the command line finds one by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/config/preset_list.h"

namespace erg::app {

/// The program's folder of presets (program_folder); it may be missing, then there are none.
std::filesystem::path presets_folder();

/// Every preset, by name.
std::vector<io::Preset> presets();

/// The preset of this name. Throws InputError with the nearest.
io::Preset find_preset(const std::string& name);

/// The config file that a person means by `name`: that file when it exists, else the preset of this name. Throws
/// InputError with the nearest preset.
std::string config_path(const std::string& name);

}  // namespace erg::app
