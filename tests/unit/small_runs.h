// Small runs of every kind of work that executors do.
#pragma once

#include <string>
#include <vector>

#include "sim/simulation.h"

namespace erg::test {

/// Runs of a blink, one of each kind of work that executors do, on each of them: slabs, slabs under a cover that
/// executors keep, snow with loose layers, grains.
inline std::vector<sim::Config> small_runs() {
  std::vector<sim::Config> all;
  for (const char* executor : {"serial", "cpu"}) {
    for (const char* model : {"momiji", "nield_baas", "snow_packing", "snow_sintering", "grains"}) {
      sim::Config config{std::string(model)};
      for (const char* setting : {"nx=32", "ny=24", "threads=1", "sweeps=4"}) sim::set_from_text(config, setting);
      sim::set_from_text(config, std::string("executor=") + executor);
      if (config.model == "grains") sim::set_from_text(config, "cell_size=0.01");
      if (config.model == "grains" || config.model == "snow_sintering") sim::set_from_text(config, "wind.strength=14");
      if (config.model == "nield_baas") {
        for (const char* setting : {"vegetation=islands", "grass_start=0.6", "steps_per_year=2"})
          sim::set_from_text(config, setting);
      }
      all.push_back(std::move(config));
    }
  }
  return all;
}

inline std::string name_of(const sim::Config& config) { return config.model + " on " + config.run.text("executor"); }

}  // namespace erg::test
