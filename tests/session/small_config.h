// Configs that run in a blink.
#pragma once

#include <string>

#include "sim/config.h"

namespace erg::test {

/// A small run: Werner on 48 x 40 cells, `executor` with two threads.
inline sim::Config small_config(const std::string& executor = "cpu", int seed = 3) {
  sim::Config config("werner");
  config.grid.set("nx", std::int64_t{48});
  config.grid.set("ny", std::int64_t{40});
  config.scene.set("kind", std::string("random"));
  config.run.set("executor", executor);
  config.run.set("threads", std::int64_t{2});
  config.run.set("sweeps", std::string("4"));
  config.run.set("seed", std::int64_t{seed});
  return config;
}

}  // namespace erg::test
