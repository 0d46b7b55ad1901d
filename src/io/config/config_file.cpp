#include "io/config/config_file.h"

#include "io/config/config_reader.h"
#include "io/files/atomic_file.h"
#include "io/files/given_file.h"

namespace erg::io {

using sim::Config;

namespace {

namespace fs = std::filesystem;

/// The picture's path relative to the working folder, from one relative to the config's folder.
std::string from_config_folder(const std::string& image, const fs::path& config_path) {
  if (image.empty()) return image;
  const fs::path folder = is_stream(config_path) ? fs::path() : config_path.parent_path();
  return (folder / fs::path(image)).lexically_normal().generic_string();
}

/// The way back. A path that cannot be made relative stays absolute.
std::string to_config_folder(const std::string& image, const fs::path& config_path) {
  if (image.empty()) return image;
  const fs::path absolute_image = fs::absolute(image).lexically_normal();
  const fs::path folder = fs::absolute(config_path).lexically_normal().parent_path();
  const fs::path relative = absolute_image.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (fs::path(image).is_relative() || below ? relative : absolute_image).generic_string();
}

/// Replaces every path among the values by `change` of it.
template <typename Change>
void for_paths(ParameterValues& values, const Change& change) {
  for (const Parameter& parameter : values.declared()) {
    if (parameter.kind() == ParameterKind::path) values.set(parameter.key, change(values.text(parameter.key)));
  }
}

/// What would be right where a picture is not there; `written`: as the config has it.
std::string missing_picture_remedy(const fs::path& picture, const std::string& written, const fs::path& config_path) {
  if (const std::string near = nearest_path(picture); !near.empty()) return "did you mean \"" + near + "\"?";
  std::error_code failed;
  if (fs::exists(written, failed)) {
    return "its path is relative to the config's folder: from there it is \"" + to_config_folder(written, config_path) +
           "\"";
  }
  if (const std::string near = nearest_path(written); !near.empty()) return "did you mean \"" + near + "\"?";
  return "its path is relative to the config's folder";
}

/// Brings a group's paths to the working folder; reports the picture that it wants and that is not there.
void read_picture(ParameterValues& values, const fs::path& config_path, int line, MistakeList& mistakes) {
  const Parameter* wanted = wanted_path(values);
  const std::string written = wanted != nullptr ? values.text(wanted->key) : "";
  for_paths(values, [&](const std::string& picture) { return from_config_folder(picture, config_path); });
  if (written.empty()) return;
  const std::string& picture = values.text(wanted->key);
  std::error_code failed;
  if (fs::is_regular_file(picture, failed)) return;
  if (!fs::exists(fs::symlink_status(picture, failed))) {
    mistakes.add(line, "there is no picture " + quote(picture), missing_picture_remedy(picture, written, config_path));
  } else if (const auto trouble = file_trouble(picture, "picture")) {
    mistakes.add(line, quote(picture) + ": " + trouble->problem, trouble->remedy);
  } else {
    mistakes.add(line, quote(picture) + " is a pipe or a device", "a picture has to be a file");
  }
}

}  // namespace

Config read_config(const fs::path& path, std::vector<std::string>* notes) {
  const std::string name = path == "-" ? "standard input" : path.string();
  ConfigReading reading = read_config_text(read_text_file(path, "config file"), name);
  read_picture(reading.config.scene, path, reading.image_line, reading.mistakes);
  read_picture(reading.config.parameters, path, reading.model_image_line, reading.mistakes);
  reading.mistakes.throw_if_any();
  if (notes != nullptr && reading.has_comments) {
    notes->push_back(name + ": its comments are not kept in what is written");
  }
  return std::move(reading.config);
}

Config parse_config(std::string_view text, const std::string& name) {
  ConfigReading reading = read_config_text(text, name);
  reading.mistakes.throw_if_any();
  return std::move(reading.config);
}

void write_config(const fs::path& path, const Config& config) {
  Config portable = config;
  for (ParameterValues* values : {&portable.scene, &portable.parameters}) {
    for_paths(*values, [&](const std::string& picture) { return to_config_folder(picture, path); });
  }
  write_file_atomically(path, config_text(portable));
}

}  // namespace erg::io
