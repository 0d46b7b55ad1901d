#include "io/provenance.h"

namespace erg {

MetadataEntries metadata(const Provenance& provenance) {
  return {{"erg:version", provenance.version},           {"erg:model", provenance.model},
          {"erg:seed", std::to_string(provenance.seed)}, {"erg:step", std::to_string(provenance.step)},
          {"erg:executor", provenance.executor},         {"erg:config", provenance.config}};
}

}  // namespace erg
