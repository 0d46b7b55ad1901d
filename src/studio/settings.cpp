#include "studio/settings.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/json_print.h"

namespace erg {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// $VARIABLE/erg, else ~/fallback/erg. The variable counts only when it is an absolute path, as its standard says.
fs::path folder_of(const char* variable, const char* fallback) {
  const char* value = std::getenv(variable);
  if (value != nullptr && fs::path(value).is_absolute()) return fs::path(value) / "erg";
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / fallback / "erg";
  return {};
}

fs::path file_in(const fs::path& folder) { return folder / "settings.json"; }

/// Takes a value where the file has one of the right kind in its range.
class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}

  void flag(const char* key, bool& value) const {
    if (json_.contains(key) && json_[key].is_boolean()) value = json_[key].get<bool>();
  }
  template <typename Number>
  void number(const char* key, Number& value, double least, double most) const {
    if (!json_.contains(key) || !json_[key].is_number()) return;
    const double held = json_[key].get<double>();
    if (held >= least && held <= most) value = static_cast<Number>(held);
  }
  void text(const char* key, std::string& value) const {
    if (json_.contains(key) && json_[key].is_string()) value = json_[key].get<std::string>();
  }
  void texts(const char* key, std::vector<std::string>& values) const {
    if (!json_.contains(key) || !json_[key].is_array()) return;
    for (const Json& item : json_[key]) {
      if (item.is_string()) values.push_back(item.get<std::string>());
    }
  }
  void numbers(const char* key, std::map<std::string, double>& values) const {
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
  const Reader reader(json);
  reader.flag("dark", settings.dark);
  double scale = 0;
  reader.number("scale", scale, Settings::smallest_scale, Settings::largest_scale);
  settings.scale = scale;
  reader.number("window_width", settings.window_width, 320, 16384);
  reader.number("window_height", settings.window_height, 240, 16384);
  reader.number("autosave_minutes", settings.autosave_minutes, 0, 1440);
  reader.numbers("layout", settings.layout);
  reader.text("last_folder", settings.last_folder);
  reader.texts("recent", settings.recent);
  if (settings.recent.size() > Settings::most_recent) settings.recent.resize(Settings::most_recent);
  return settings;
}

void write_settings(const fs::path& folder, const Settings& settings) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw InputError(folder.string(), "cannot make this folder: " + failed.message(), "settings are not kept");
  Json json;
  json["dark"] = settings.dark;
  json["scale"] = settings.scale;
  json["window_width"] = settings.window_width;
  json["window_height"] = settings.window_height;
  json["autosave_minutes"] = settings.autosave_minutes;
  json["last_folder"] = settings.last_folder;
  json["recent"] = settings.recent;
  json["layout"] = settings.layout;
  write_file_atomically(file_in(folder), pretty_json(json));
}

}  // namespace erg
