#include "app/presets.h"

#include "core/errors.h"
#include "core/program_files.h"

namespace erg {

namespace fs = std::filesystem;

fs::path presets_folder() { return program_folder("cfg"); }

std::vector<Preset> presets() { return list_presets(presets_folder()); }

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
