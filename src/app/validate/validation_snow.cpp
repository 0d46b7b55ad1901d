// Which forms sintering snow takes, by wind and by the calm hours before it.
#include <cstdio>

#include "analysis/bedforms.h"
#include "app/cli/progress.h"
#include "app/cli/text_table.h"
#include "app/validate/validation.h"
#include "sim/simulation.h"

namespace erg::app {

using sim::set_from_text;

namespace {

struct SnowScene {
  const char* name;
  std::vector<std::string> settings;
  int steps;
};

/// The same defaults everywhere; only cells, slabs and steps are finer for the smaller forms.
std::vector<SnowScene> snow_scenes() {
  return {{"coarse: cells of 0.1 m, slabs of 5 mm, steps of 60 s", {"grid.cell_size=0.1", "scene.sand=40"}, 360},
          {"fine: cells of 0.05 m, slabs of 2.5 mm, steps of 30 s",
           {"grid.cell_size=0.05", "scene.sand=120", "parameters.slab_height=0.0025", "parameters.time_step=30"},
           480}};
}

std::string form(const SnowScene& scene, double wind, int calm_hours) {
  sim::Config config("snow_sintering");
  for (const std::string& setting : scene.settings) set_from_text(config, setting);
  for (const std::string& setting :
       {std::string("grid.nx=128"), std::string("grid.ny=128"), "wind.strength=" + fixed_text(wind, 1),
        "parameters.start_age=" + std::to_string(calm_hours)}) {
    set_from_text(config, setting);
  }
  sim::Simulation simulation(config);
  for (int step = 0; step < scene.steps; ++step) simulation.step();
  const analysis::BedformShape shape = analysis::measure_bedforms(simulation.terrain(), config.wind.at(0).bearing);
  return analysis::bedform_name(shape) + " (" + fixed_text(shape.across, 2) + ", " + fixed_text(shape.skew, 1) + ", " +
         fixed_text(shape.relief * 100, 1) + " cm, " + fixed_text(shape.crust, 2) + ")";
}

/// How `bedform_name` names a form, in words.
std::string naming_rule() {
  return "Named by these numbers: flat under " + fixed_text(analysis::least_relief * 100, 1) + " cm, waves under " +
         fixed_text(analysis::waves_across, 2) + " across, streaks from " + fixed_text(analysis::streaks_across, 2) +
         " on, rough between. Streaks are sastrugi where they are carved: at least " +
         fixed_text(analysis::least_sastrugi_relief * 100, 0) + " cm, skew " +
         fixed_text(analysis::least_sastrugi_skew, 1) + " and " + fixed_text(analysis::least_sastrugi_crust * 100, 0) +
         "% bare bonded snow.";
}

}  // namespace

std::string snow_section(const ValidationOptions& options) {
  const std::vector<double> winds =
      options.quick ? std::vector<double>{4, 12, 22} : std::vector<double>{4, 7, 10, 13, 16, 20, 25};
  const std::vector<int> calm = options.quick ? std::vector<int>{0, 60} : std::vector<int>{0, 24, 120};
  std::string section =
      "## Forms of sintering snow, by wind and calm hours\n\n128 x 128 cells, -10 °C, one seed, the defaults of "
      "`erg model snow_sintering`. In brackets: share of the squared slope that lies across the wind (ridges across it "
      "0, along it 1), skew of the slope along the wind (positive: faces toward the wind are the steeper ones), "
      "standard deviation of height, and share of the cells on which bonded snow lies bare. " +
      naming_rule() + "\n";
  for (const SnowScene& scene : snow_scenes()) {
    TextTable table;
    table.heading = {"calm hours \\ wind, m/s"};
    for (const double wind : winds) table.heading.push_back(fixed_text(wind, 0));
    for (const int hours : calm) {
      std::fprintf(stderr, "validate: snow, %s, %d calm hours\n", scene.name, hours);
      std::vector<std::string> row{std::to_string(hours)};
      for (const double wind : winds) row.push_back(form(scene, wind, hours));
      table.rows.push_back(row);
    }
    section += "\n" + std::string(scene.name) + ", " + std::to_string(scene.steps) + " steps:\n\n" + table.markdown();
  }
  return section;
}

}  // namespace erg::app
