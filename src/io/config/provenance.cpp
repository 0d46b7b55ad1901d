#include "io/config/provenance.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "core/random.h"
#include "io/config/config_file.h"
#include "io/files/atomic_file.h"
#include "sim/step_time.h"

namespace erg::io {
namespace {

namespace fs = std::filesystem;

/// Whether the config goes into a file beside `path`.
bool stands_beside(const fs::path& path, const Provenance& provenance) {
  std::error_code none;
  if (provenance.config.size() <= longest_config_within) return false;
  return !fs::exists(path, none) || fs::is_regular_file(path, none);
}

std::string config_file_name(const Provenance& provenance) { return "config-" + config_hash(provenance) + ".json"; }

}  // namespace

std::string program_version() { return ERG_VERSION; }

std::string executor_text(const std::string& executor, int threads) {
  return executor + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

Provenance provenance_of(const sim::Config& config, std::int64_t step, const std::string& executor, int threads) {
  return {.config = config_text(config),
          .seed = static_cast<std::uint64_t>(config.run.integer("seed")),
          .step = step,
          .model = config.model,
          .version = program_version(),
          .executor = executor_text(executor, threads),
          .days = sim::days_after(config, step)};
}

std::string config_hash(const Provenance& provenance) {
  std::uint64_t hash = provenance.config.size();
  for (const char byte : provenance.config) hash = mix64(hash ^ static_cast<unsigned char>(byte));
  return hash_text(hash);
}

MetadataEntries metadata(const Provenance& provenance) {
  MetadataEntries entries{{"erg:version", provenance.version},
                          {"erg:model", provenance.model},
                          {"erg:seed", std::to_string(provenance.seed)},
                          {"erg:step", std::to_string(provenance.step)},
                          {"erg:executor", provenance.executor},
                          {"erg:config-hash", config_hash(provenance)},
                          {"erg:config", provenance.config}};
  if (std::isfinite(provenance.days)) entries.emplace_back("erg:days", format_shortest(provenance.days));
  return entries;
}

MetadataEntries metadata_of_file(const fs::path& path, const Provenance& provenance) {
  MetadataEntries entries = metadata(provenance);
  if (!stands_beside(path, provenance)) return entries;
  const std::string name = config_file_name(provenance);
  const fs::path beside = path.parent_path() / name;
  std::error_code none;
  if (fs::file_size(beside, none) != provenance.config.size()) write_file_atomically(beside, provenance.config);
  *std::ranges::find(entries, "erg:config", &MetadataEntries::value_type::first) = {"erg:config-file", name};
  return entries;
}

}  // namespace erg::io
