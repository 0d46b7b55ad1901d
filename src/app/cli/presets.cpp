#include "app/cli/presets.h"

#include <algorithm>

#include "core/errors.h"
#include "io/files/given_file.h"
#include "process/program_files.h"

namespace erg::app {

using io::Preset;

namespace {

namespace fs = std::filesystem;

/// The preset of this name, or null.
const Preset* preset_named(const std::vector<Preset>& known, const std::string& name) {
  const auto found = std::ranges::find(known, name, &Preset::name);
  return found == known.end() ? nullptr : &*found;
}

/// What was most likely meant by a name that is none, also by one written as a file or with backslashes
/// ("cfg\\Barchans.json"); "" if there is none.
std::string nearest_preset(std::string name, const std::vector<Preset>& known) {
  std::ranges::replace(name, '\\', '/');
  if (name.ends_with(".json")) name.resize(name.size() - 5);
  std::vector<std::string> names;
  for (const Preset& preset : known) names.push_back(preset.name);
  if (const std::string near = nearest_word(name, names); !near.empty()) return near;
  return nearest_word(fs::path(name).filename().string(), names);
}

[[noreturn]] void refuse_name(const std::string& name, const std::string& what, const std::string& near) {
  throw InputError(name, "no such " + what,
                   near.empty() ? "`erg presets` lists the presets" : "did you mean \"" + near + "\"?");
}

}  // namespace

fs::path presets_folder() { return process::program_folder("cfg"); }

std::vector<Preset> presets() { return io::list_presets(presets_folder()); }

Preset find_preset(const std::string& name) {
  const std::vector<Preset> known = presets();
  if (const Preset* preset = preset_named(known, name)) return *preset;
  refuse_name(name, "preset", nearest_preset(name, known));
}

std::string config_path(const std::string& name) {
  if (name == "-") return name;
  const auto trouble = io::file_trouble(name, "config file");
  if (!trouble) return name;
  const std::vector<Preset> known = presets();
  if (const Preset* preset = preset_named(known, name)) return preset->path.string();
  std::error_code failed;
  if (fs::symlink_status(name, failed).type() != fs::file_type::not_found) throw InputError({*trouble});
  // A path is most likely one of a file, a bare word one of a preset.
  const std::string file = io::nearest_path(name);
  const std::string preset = nearest_preset(name, known);
  const bool is_path = name.find_first_of("/\\") != std::string::npos || name.ends_with(".json");
  const bool is_file = !file.empty() && fs::is_regular_file(file, failed);
  refuse_name(name, "config file or preset", is_file && (is_path || preset.empty()) ? file : preset);
}

}  // namespace erg::app
