#include "io/provenance.h"

#include <cmath>

#include "core/exact_text.h"
#include "io/config_file.h"
#include "sim/step_time.h"

namespace erg {

std::string program_version() { return ERG_VERSION; }

std::string executor_text(const std::string& executor, int threads) {
  return executor + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

Provenance provenance_of(const Config& config, std::int64_t step, const std::string& executor, int threads) {
  return {.config = config_text(config),
          .seed = static_cast<std::uint64_t>(config.run.integer("seed")),
          .step = step,
          .model = config.model,
          .version = program_version(),
          .executor = executor_text(executor, threads),
          .days = days_after(config, step)};
}

MetadataEntries metadata(const Provenance& provenance) {
  MetadataEntries entries{{"erg:version", provenance.version},           {"erg:model", provenance.model},
                          {"erg:seed", std::to_string(provenance.seed)}, {"erg:step", std::to_string(provenance.step)},
                          {"erg:executor", provenance.executor},         {"erg:config", provenance.config}};
  if (std::isfinite(provenance.days)) entries.emplace_back("erg:days", exact_text(provenance.days));
  return entries;
}

}  // namespace erg
