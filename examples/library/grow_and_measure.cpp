// Grows the dunes of a config file and measures them: a program that uses Erg as a library.
//
//   grow_and_measure CONFIG OUT
//
// prints a line of numbers ten times in the run and leaves OUT.png, a 16-bit heightmap for other programs, and
// OUT.checkpoint, with which `erg run`, `erg render` and the window go on.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>

#include "analysis/fourier.h"
#include "analysis/migration.h"
#include "analysis/morphometry.h"
#include "core/errors.h"
#include "io/checkpoint/checkpoint.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/formats/heightmap.h"

namespace {

void grow_and_measure(const std::string& config_file, const std::string& out) {
  const erg::sim::Config config = erg::io::read_config(config_file);
  erg::sim::Simulation simulation = erg::io::start_simulation(config);
  const std::int64_t steps = config.run.integer("steps");
  const std::int64_t between = std::max<std::int64_t>(1, steps / 10);

  erg::analysis::MigrationTracker migration;
  std::printf("step,sd_m,highest_m,bare,cells_a_step_east\n");
  while (simulation.step_count() < steps && !simulation.finished()) {
    simulation.step();
    if (simulation.step_count() % between != 0) continue;
    const erg::Terrain& terrain = simulation.terrain();
    const erg::analysis::Morphometry shape = erg::analysis::measure(terrain);
    migration.observe(simulation.step_count(), erg::analysis::coarse_surface(terrain, erg::analysis::Layer::mobile));
    const auto velocity = migration.velocity();
    std::printf("%lld,%.3f,%.3f,%.3f,%.4f\n", static_cast<long long>(simulation.step_count()), shape.sd_surface,
                shape.highest, shape.bare_fraction, velocity ? velocity->x : 0.0);
  }

  erg::io::write_heightmap(out + ".png", simulation.terrain(), erg::io::provenance_of(simulation));
  erg::io::write_checkpoint(out + ".checkpoint", simulation.config(), simulation.state());
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::fprintf(stderr, "usage: grow_and_measure CONFIG OUT\n");
    return 2;
  }
  try {
    grow_and_measure(arguments[1], arguments[2]);
  } catch (const erg::InputError& error) {  // what a person can mend: place, problem, remedy
    for (const erg::Mistake& mistake : error.mistakes()) std::fprintf(stderr, "%s\n", mistake.text().c_str());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
