#include "io/config/preset_list.h"

#include <algorithm>

namespace erg::io {

namespace fs = std::filesystem;

std::vector<Preset> list_presets(const fs::path& folder) {
  std::vector<Preset> found;
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) return found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    fs::path name = entry.path().lexically_relative(folder);
    found.push_back({name.replace_extension().generic_string(), entry.path()});
  }
  std::sort(found.begin(), found.end(), [](const Preset& a, const Preset& b) {
    const bool a_deep = a.name.find('/') != std::string::npos;
    const bool b_deep = b.name.find('/') != std::string::npos;
    return a_deep != b_deep ? b_deep : a.name < b.name;
  });
  return found;
}

fs::path preset_picture(const fs::path& folder, const std::string& name) {
  return folder / "gallery" / (name + ".jpg");
}

}  // namespace erg::io
