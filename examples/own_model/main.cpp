// A program with a model of its own: two fields of dunes from the same sand, over a deep and over a high water table.
//
//   own_model FOLDER
//
// prints how much of the ground is wet and how high the dunes are, and leaves a picture of each in FOLDER.
#include <cstdio>
#include <exception>
#include <string>

#include "analysis/morphometry.h"
#include "io/checkpoint/start_simulation.h"
#include "io/formats/picture.h"
#include "water_table.h"

namespace {

void grow(const std::string& table, const std::string& folder) {
  erg::sim::Config config("water_table");
  for (const char* setting : {"nx=96", "ny=96", "sand=4", "steps=600", "threads=1"}) {
    erg::sim::set_from_text(config, setting);
  }
  erg::sim::set_from_text(config, "water_table=" + table);
  erg::sim::Simulation simulation = erg::io::start_simulation(config);
  const std::int64_t steps = config.run.integer("steps");
  while (simulation.step_count() < steps) simulation.step();

  const erg::analysis::Morphometry shape = erg::analysis::measure(simulation.terrain());
  const double wet = simulation.model().diagnostics().front().value;
  std::printf("water table %s m: %.0f %% of the ground wet, lowest %.2f m, highest %.2f m\n", table.c_str(), 100 * wet,
              shape.lowest, shape.highest);
  erg::io::PictureOptions options;
  options.wind = simulation.last_wind();
  options.caption = "water table at " + table + " m";
  erg::io::write_png(folder + "/water_table_" + table + "m.png", erg::io::draw_picture(simulation.terrain(), options),
                     erg::io::metadata(erg::io::provenance_of(simulation)));
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fprintf(stderr, "usage: own_model FOLDER\n");
    return 2;
  }
  try {
    erg::models::add_model(erg::water_table());
    grow("0", arguments[1]);
    grow("0.7", arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
