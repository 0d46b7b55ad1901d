#include "session/settings.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/errors.h"
#include "io/files/atomic_file.h"
#include "io/files/json_print.h"
#include "session/surroundings.h"

namespace erg::session {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// $VARIABLE/erg, else ~/fallback/erg. The variable counts only when it is an absolute path, as its standard says.
fs::path folder_of(const char* variable, const char* fallback) {
  if (const fs::path kept = path_from_environment(variable); !kept.empty()) return kept / "erg";
  const fs::path home = path_from_environment("HOME");
  return home.empty() ? home : home / fallback / "erg";
}

fs::path file_in(const fs::path& folder) { return folder / "settings.json"; }

/// All that the file holds, by its keys: what reads and what writes go by this one list.
template <typename Held, typename Visit>
void for_each_value(Held& settings, const Visit& visit) {
  visit("dark", settings.dark);
  visit("scale", settings.scale, Settings::smallest_scale, Settings::largest_scale);
  visit("window_width", settings.window_width, 320, 16384);
  visit("window_height", settings.window_height, 240, 16384);
  visit("autosave_minutes", settings.autosave_minutes, 0, 1440);
  visit("last_folder", settings.last_folder);
  visit("recent", settings.recent);
  visit("layout", settings.layout);
}

/// Takes a value where the file has one of the right kind in its range.
class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}

  void operator()(const char* key, bool& value) const {
    if (json_.contains(key) && json_[key].is_boolean()) value = json_[key].get<bool>();
  }
  template <typename Number>
  void operator()(const char* key, Number& value, double least, double most) const {
    if (!json_.contains(key) || !json_[key].is_number()) return;
    const double held = json_[key].get<double>();
    if (held >= least && held <= most) value = static_cast<Number>(held);
  }
  void operator()(const char* key, std::string& value) const {
    if (json_.contains(key) && json_[key].is_string()) value = json_[key].get<std::string>();
  }
  void operator()(const char* key, std::vector<std::string>& values) const {
    if (!json_.contains(key) || !json_[key].is_array()) return;
    for (const Json& item : json_[key]) {
      if (item.is_string()) values.push_back(item.get<std::string>());
    }
  }
  void operator()(const char* key, std::map<std::string, double>& values) const {
    if (!json_.contains(key) || !json_[key].is_object()) return;
    for (const auto& [name, item] : json_[key].items()) {
      if (item.is_number()) values[name] = item.get<double>();
    }
  }

 private:
  const Json& json_;
};

}  // namespace

void Settings::add_recent(const fs::path& path) {
  std::error_code failed;
  const std::string absolute = fs::absolute(path, failed).lexically_normal().string();
  std::erase(recent, absolute);
  recent.insert(recent.begin(), absolute);
  if (recent.size() > most_recent) recent.resize(most_recent);
}

fs::path settings_folder() { return folder_of("XDG_CONFIG_HOME", ".config"); }
fs::path state_folder() { return folder_of("XDG_STATE_HOME", ".local/state"); }

Settings read_settings(const fs::path& folder, std::string& complaint) {
  Settings settings;
  complaint.clear();
  std::ifstream file(file_in(folder), std::ios::binary);
  if (!file) return settings;  // the first start
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    complaint = file_in(folder).string() + ": these settings cannot be read; the usual ones are used";
    return settings;
  }
  for_each_value(settings, Reader(json));
  if (settings.recent.size() > Settings::most_recent) settings.recent.resize(Settings::most_recent);
  return settings;
}

void write_settings(const fs::path& folder, const Settings& settings) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw InputError(folder.string(), "cannot make this folder: " + failed.message(), "settings are not kept");
  Json json;
  for_each_value(settings, [&json](const char* key, const auto& value, auto...) { json[key] = value; });
  io::write_file_atomically(file_in(folder), io::pretty_json(json));
}

}  // namespace erg::session
