// Where the files lie that the program brings along: shaders, presets.
#pragma once

#include <filesystem>
#include <string>

namespace erg::process {

/// Where the folder `name` ("shaders", "cfg") of the running program belongs: in share/erg beside the program's own
/// folder, as `cmake --install` lays it out (a build tree has links there). It may be missing; there is no second
/// place.
std::filesystem::path program_folder(const std::string& name);

}  // namespace erg::process
