#include "app/presets.h"

#include <algorithm>

#include "core/errors.h"

namespace erg {

namespace fs = std::filesystem;

fs::path presets_folder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path installed = program.parent_path() / ".." / "share" / "erg" / "cfg";
  if (!failed && fs::is_directory(installed)) return installed.lexically_normal();
  const fs::path source = ERG_SOURCE_PRESETS;
  return fs::is_directory(source) ? source : fs::path();
}

fs::path gallery_folder() { return presets_folder() / "gallery"; }

std::vector<Preset> presets() {
  std::vector<Preset> found;
  const fs::path folder = presets_folder();
  if (folder.empty()) return found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    fs::path name = entry.path().lexically_relative(folder);
    found.push_back({name.replace_extension().generic_string(), entry.path()});
  }
  // Those at the top first, then the folders.
  std::sort(found.begin(), found.end(), [](const Preset& a, const Preset& b) {
    const bool a_deep = a.name.find('/') != std::string::npos;
    const bool b_deep = b.name.find('/') != std::string::npos;
    return a_deep != b_deep ? b_deep : a.name < b.name;
  });
  return found;
}

std::string config_path(const std::string& name) {
  if (fs::is_regular_file(name)) return name;
  const std::vector<Preset> known = presets();
  std::vector<std::string> names;
  for (const Preset& preset : known) {
    if (preset.name == name) return preset.path.string();
    names.push_back(preset.name);
  }
  const std::string near = nearest_word(name, names);
  throw InputError(name, "no such config file or preset",
                   near.empty() ? "`erg presets` lists the presets" : "did you mean \"" + near + "\"?");
}

}  // namespace erg
