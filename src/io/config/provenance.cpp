#include "io/config/provenance.h"

#include <cmath>

#include "core/number_text.h"
#include "core/random.h"
#include "io/config/config_file.h"
#include "io/files/atomic_file.h"
#include "sim/step_time.h"

namespace erg::io {
namespace {

namespace fs = std::filesystem;

bool stands_within(const Provenance& provenance) { return provenance.config.size() <= longest_config_within; }

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
  MetadataEntries entries{{"erg:version", provenance.version},           {"erg:model", provenance.model},
                          {"erg:seed", std::to_string(provenance.seed)}, {"erg:step", std::to_string(provenance.step)},
                          {"erg:executor", provenance.executor},         {"erg:config-hash", config_hash(provenance)}};
  if (stands_within(provenance)) {
    entries.emplace_back("erg:config", provenance.config);
  } else {
    entries.emplace_back("erg:config-file", config_file_name(provenance));
  }
  if (std::isfinite(provenance.days)) entries.emplace_back("erg:days", format_shortest(provenance.days));
  return entries;
}

void keep_config_beside(const fs::path& path, const Provenance& provenance) {
  std::error_code none;
  if (stands_within(provenance) || (fs::exists(path, none) && !fs::is_regular_file(path, none))) return;
  const fs::path beside = path.parent_path() / config_file_name(provenance);
  if (fs::file_size(beside, none) != provenance.config.size()) write_file_atomically(beside, provenance.config);
}

}  // namespace erg::io
