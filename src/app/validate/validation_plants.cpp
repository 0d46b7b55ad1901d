// Shapes of dunes among plants: how long and wide, and which way their arms point.
#include <cstdio>

#include "app/cli/presets.h"
#include "app/cli/text_table.h"
#include "app/validate/sample.h"
#include "app/validate/validation.h"
#include "app/validate/validation_plants.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"

namespace erg::app {

using analysis::DuneMeans;
using analysis::DuneRule;
using sim::set_from_text;

namespace {

std::vector<PlantScene> plant_scenes() {
  const std::vector<std::string> bare{"grass=false", "mesquite=false"};
  const std::vector<std::string> bare_plain{"grass=false", "shrub=false"};
  const std::vector<std::string> small{"nx=96", "ny=96", "mesquite_low=0"};
  const std::vector<std::string> small_bare{"nx=96", "ny=96", "grass=false", "mesquite=false"};
  return {{"nebkhas", "nebkhas", {}, 500, 6},
          {"the same without plants", "nebkhas", bare, 500, 6},
          {"parabolic dunes", "parabolic", {}, 2000, 25},
          {"the same without plants", "parabolic", bare_plain, 2000, 25},
          {"nebkhas that went on, as in print", "thesis/nield_parabolic", {}, 1500, 12},
          {"the same without plants", "thesis/nield_parabolic", bare, 1500, 12},
          {"the same with `mesquite_low` 0 on 96 x 96 cells", "thesis/nield_parabolic", small, 1500, 12},
          {"the same without plants", "thesis/nield_parabolic", small_bare, 1500, 12},
          {"blowouts", "blowouts", {}, 4000, 25}};
}

std::vector<std::string> shape_row(const PlantScene& scene, int seeds) {
  std::fprintf(stderr, "validate: shapes, %s, %s\n", scene.name, count_text(seeds, "seed").c_str());
  Sample dunes, ratio, arms;
  for (const DuneMeans& means : side_by_side<DuneMeans>(seeds, [&](int job) { return shapes(scene, 1 + job); })) {
    dunes.add(means.dunes);
    ratio.add(means.length_over_width);
    arms.add(means.arms);
  }
  return {scene.name,  std::to_string(scene.steps), std::to_string(scene.least), dunes.text(1), ratio.text(2),
          arms.text(2)};
}

}  // namespace

DuneMeans shapes(const PlantScene& scene, int seed) {
  sim::Config config = io::read_config(config_path(scene.preset));
  for (const std::string& setting : scene.settings) set_from_text(config, setting);
  set_from_text(config, "run.executor=cpu");
  set_from_text(config, "run.threads=1");  // small terrains: two threads would wait for each other more than they work
  set_from_text(config, "run.seed=" + std::to_string(seed));
  sim::Simulation simulation = io::start_simulation(config);
  while (simulation.step_count() < scene.steps && !simulation.finished()) simulation.step();
  const DuneRule rule{.base = 0, .least = scene.least};
  return analysis::mean_of_dunes(
      analysis::find_dunes(simulation.terrain(), simulation.last_wind().mean_bearing(), rule).dunes);
}

std::string plants_section(const ValidationOptions& options) {
  const int seeds = options.quick ? 1 : 6;
  TextTable table;
  table.heading = {"scene", "step", "dune from, slabs", "dunes", "length / width", "arms"};
  for (const PlantScene& scene : plant_scenes()) table.rows.push_back(shape_row(scene, seeds));
  return "## Shapes of dunes among plants\n\nThe presets of `cfg/` on `cpu`, mean over " + count_text(seeds, "seed") +
         ", spread over the seeds in brackets. A dune is a patch of at least " + std::to_string(DuneRule{}.smallest) +
         " cells whose sand is as thick as the third column says; length along the wind, width across it. Arms: mean "
         "of x y^2 over its spreads, x downwind and y across from the dune's middle; negative where the sides lie "
         "upwind of the middle (parabolic), positive where they lie downwind (barchan), 0 for an ellipse.\n\n" +
         table.markdown() +
         "\n**Parabolic dunes that begin as blowouts have clear arms, those that begin as nebkhas hardly any**: on 256 "
         "x 256 cells single ones have them, their mean does not differ from terrain without plants. Around a smaller "
         "torus, where dunes come by more often in as many steps, it does. Terrain with and without plants is outlined "
         "from the same thickness on: nebkhas are then longer than the bare dunes beside them, which are low.\n";
}

}  // namespace erg::app
