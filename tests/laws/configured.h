// Runs from configs, for laws of single models.
#pragma once

#include <string>
#include <vector>

#include "core/terrain.h"
#include "sim/config.h"

namespace erg::test {

/// A config of the model with these settings (as for `--set`), for terrains so small that one thread is the fastest.
inline sim::Config configured(const std::string& model, const std::vector<std::string>& settings) {
  sim::Config config(model);
  sim::set_from_text(config, "run.threads=1");
  for (const std::string& setting : settings) sim::set_from_text(config, setting);
  return config;
}

inline const Grid<float>& field(const Terrain& terrain, const std::string& key) {
  return find_field(terrain.fields(), key)->values;
}

}  // namespace erg::test
