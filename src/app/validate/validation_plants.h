// Dunes among plants, measured: for the section of plants, and for that of laws of nature.
#pragma once

#include <string>
#include <vector>

#include "analysis/dune_outlines.h"

namespace erg::app {

/// A preset of plants, or the same terrain changed by `settings`, at one step.
struct PlantScene {
  const char* name;
  const char* preset;
  std::vector<std::string> settings;
  int steps;
  int least;  ///< slabs: thinner sand is no dune
};

/// Its dunes' means, on `cpu` with one thread. Throws InputError where the preset is missing.
analysis::DuneMeans shapes(const PlantScene& scene, int seed);

}  // namespace erg::app
