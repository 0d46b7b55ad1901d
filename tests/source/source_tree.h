// The source text under src/, for tests of what includes what.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace erg::test {

/// Every source file by its path below src/, for example "core/grid.h", with the files of src/ that it includes.
const std::map<std::string, std::vector<std::string>>& source_tree();

/// The layer that a path belongs to: its first folder.
std::string layer_of(const std::string& path);

/// The arrows of src/CMakeLists.txt: layer to the layers that it links.
const std::map<std::string, std::set<std::string>>& arrows();

/// All layers that a layer may include: itself and what lies further along the arrows.
std::set<std::string> may_include(const std::string& layer);

std::string read_text(const std::filesystem::path& path);

/// The root of the source tree.
inline std::filesystem::path source_root() { return ERG_SOURCE_DIR; }

}  // namespace erg::test
