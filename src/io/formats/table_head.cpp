#include "io/formats/table_head.h"

#include <map>
#include <optional>

#include "core/errors.h"
#include "io/config/config_file.h"
#include "io/files/given_file.h"

namespace erg::io {

using sim::Config;

namespace {

/// The entries of a head (comments.h): "# name: text", or "# name:" and the lines of its text.
std::map<std::string, std::string> entries_of(const std::vector<std::string>& head) {
  std::map<std::string, std::string> entries;
  std::string* open = nullptr;
  for (const std::string& line : head) {
    const std::size_t end = line.find(':', line.find(':') + 1);  // names hold a colon: "erg:seed"
    if (!line.starts_with("# erg:")) {
      if (open != nullptr && line.size() >= 2) *open += line.substr(2) + "\n";
    } else if (end != std::string::npos) {
      open = &entries[line.substr(2, end - 2)];
      if (end + 2 < line.size()) *open = line.substr(end + 2);
    }
  }
  return entries;
}

/// The config that a head tells of; nothing where it does not, or not in a way that this program reads.
std::optional<Config> config_of(const std::map<std::string, std::string>& entries,
                                const std::filesystem::path& folder) {
  try {
    const auto within = entries.find("erg:config");
    if (within != entries.end()) return parse_config(within->second, "");
    const auto beside = entries.find("erg:config-file");
    if (beside != entries.end()) {
      const std::filesystem::path file = folder / std::filesystem::path(beside->second).filename();
      return parse_config(read_text_file(file, "config file"), "");
    }
  } catch (const InputError&) {
  }
  return std::nullopt;
}

/// The first value that is read only at the start and differs.
std::string first_difference(const Config& theirs, const Config& ours) {
  for (const sim::ConfigGroup& group : sim::config_groups()) {
    const ParameterValues& values = theirs.*group.values;
    for (const Parameter& parameter : values.declared()) {
      if (!parameter.at_start) continue;
      const ParameterValue& here = (ours.*group.values).value(parameter.key);
      if (values.value(parameter.key) == here) continue;
      return group.key + "." + parameter.key + " is " + value_text(values.value(parameter.key)) + " there and " +
             value_text(here) + " here";
    }
  }
  return {};
}

}  // namespace

std::string why_another_run(const std::vector<std::string>& head, const Provenance& provenance,
                            const std::filesystem::path& folder) {
  const std::map<std::string, std::string> entries = entries_of(head);
  const auto differs = [&](const std::string& name, const std::string& here) -> std::string {
    const auto there = entries.find("erg:" + name);
    if (there == entries.end() || there->second == here) return {};
    return name + " is " + there->second + " there and " + here + " here";
  };
  if (std::string why = differs("model", provenance.model); !why.empty()) return why;
  if (std::string why = differs("seed", std::to_string(provenance.seed)); !why.empty()) return why;
  const std::optional<Config> theirs = config_of(entries, folder);
  return theirs ? first_difference(*theirs, parse_config(provenance.config, "")) : std::string();
}

}  // namespace erg::io
