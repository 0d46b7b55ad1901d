#include "app/presets.h"

#include "core/errors.h"
#include "core/program_files.h"

namespace erg {
namespace {

namespace fs = std::filesystem;

/// The preset of this name; throws InputError that calls it `what` where there is none.
Preset preset_or_throw(const std::string& name, const char* what) {
  const std::vector<Preset> known = presets();
  std::vector<std::string> names;
  for (const Preset& preset : known) {
    if (preset.name == name) return preset;
    names.push_back(preset.name);
  }
  const std::string near = nearest_word(name, names);
  throw InputError(name, std::string("no such ") + what,
                   near.empty() ? "`erg presets` lists the presets" : "did you mean \"" + near + "\"?");
}

}  // namespace

fs::path presets_folder() { return program_folder("cfg"); }

std::vector<Preset> presets() { return list_presets(presets_folder()); }

Preset find_preset(const std::string& name) { return preset_or_throw(name, "preset"); }

std::string config_path(const std::string& name) {
  return fs::is_regular_file(name) ? name : preset_or_throw(name, "config file or preset").path.string();
}

}  // namespace erg
