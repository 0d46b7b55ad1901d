#include "io/provenance.h"

#include "io/config_file.h"

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
          .executor = executor_text(executor, threads)};
}

MetadataEntries metadata(const Provenance& provenance) {
  return {{"erg:version", provenance.version},           {"erg:model", provenance.model},
          {"erg:seed", std::to_string(provenance.seed)}, {"erg:step", std::to_string(provenance.step)},
          {"erg:executor", provenance.executor},         {"erg:config", provenance.config}};
}

}  // namespace erg
