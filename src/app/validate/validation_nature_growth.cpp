// How spacing, height and defects of transverse dunes go on over time, and when one crest is left.
#include <cmath>
#include <numbers>

#include "analysis/crest_defects.h"
#include "analysis/crests.h"
#include "analysis/morphometry.h"
#include "app/validate/validation_nature.h"

namespace erg::app {

using analysis::coarse_surface;
using analysis::crest_spacing;
using analysis::Layer;
using sim::Simulation;

namespace {

struct GrowthRun {
  std::vector<double> spacing;  ///< cells, at each of the watched steps
  std::vector<double> height;   ///< slabs: crest to trough of a sine of the same standard deviation
  std::vector<double> defects;  ///< on the whole grid
};

GrowthRun growth_run(const std::string& model, const std::vector<int>& watch, int seed) {
  Simulation simulation(
      nature_config(model, {"grid.nx=256", "grid.ny=256", "scene.sand=10", "run.seed=" + std::to_string(seed)}));
  GrowthRun run;
  for (const int last : watch) {
    while (simulation.step_count() < last) simulation.step();
    const analysis::CoarseSurface surface = coarse_surface(simulation.terrain(), Layer::surface);
    run.spacing.push_back(crest_spacing(surface, 270));
    run.height.push_back(2 * std::numbers::sqrt2 * analysis::measure(simulation.terrain()).sd_slabs);
    run.defects.push_back(analysis::count_crest_defects(surface, 270, run.spacing.back()));
  }
  return run;
}

/// The first of the watched steps at which no line of a small torus meets two crests closer than the torus is long.
double one_crest_at(const std::string& model, int last, int seed) {
  constexpr int side = 96;
  constexpr int every = 100;
  Simulation simulation(nature_config(model, {"grid.nx=" + std::to_string(side), "grid.ny=" + std::to_string(side),
                                              "scene.sand=10", "run.seed=" + std::to_string(seed)}));
  while (simulation.step_count() < last) {
    for (int step = 0; step < every; ++step) simulation.step();
    const double spacing = crest_spacing(coarse_surface(simulation.terrain(), Layer::surface), 270);
    if (spacing > 0.9 * side) return static_cast<double>(simulation.step_count());
  }
  return 0;
}

std::string one_crest_text(const std::string& model, int last, int seeds) {
  const std::vector<double> steps =
      side_by_side<double>(seeds, [&](int job) { return one_crest_at(model, last, 1 + job); });
  std::string text;
  for (const double step : steps) {
    text += (text.empty() ? "" : ", ") + (step > 0 ? fixed_text(step, 0) : "not by " + std::to_string(last));
  }
  return text;
}

using GrowthNumber = std::vector<double> GrowthRun::*;

/// A row: the number at each step, and its exponents over the first and second half of the steps.
std::vector<std::string> growth_row(const std::string& name, const std::vector<GrowthRun>& runs, GrowthNumber number,
                                    const std::vector<int>& watch) {
  std::vector<std::string> row{name};
  for (std::size_t at = 0; at < watch.size(); ++at) {
    Sample sample;
    for (const GrowthRun& run : runs) sample.add((run.*number)[at]);
    row.push_back(sample.text(1));
  }
  const std::size_t middle = watch.size() / 2;
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, middle}, {middle, watch.size() - 1}}) {
    Sample exponent;
    for (const GrowthRun& run : runs) {
      std::vector<double> steps;
      std::vector<double> values;
      for (std::size_t at = from; at <= to; ++at) {
        steps.push_back(watch[at]);
        values.push_back(std::max((run.*number)[at], 0.5));  // no defect: less than one
      }
      exponent.add(power_law(steps, values));
    }
    row.push_back(exponent.text(2));
  }
  return row;
}

}  // namespace

std::string growth_of_crests(const ValidationOptions& options) {
  const std::vector<int> watch =
      options.quick ? std::vector<int>{100, 200, 400} : std::vector<int>{100, 200, 400, 800, 1600, 3200, 6400};
  const int seeds = options.quick ? 1 : 3;
  const int longest = options.quick ? 2000 : 20000;
  TextTable table;
  table.heading = {"model, number"};
  for (const int step : watch) table.heading.push_back("step " + std::to_string(step));
  const std::string middle = std::to_string(watch[watch.size() / 2]);
  table.heading.insert(table.heading.end(), {"exponent to " + middle, "exponent from " + middle});
  std::string filled;
  for (const char* model : {"werner", "momiji"}) {
    say_measuring(std::string("growth, ") + model, seeds);
    const std::vector<GrowthRun> runs =
        side_by_side<GrowthRun>(seeds, [&](int job) { return growth_run(model, watch, 1 + job); });
    const std::string name = model;
    table.rows.push_back(growth_row(name + ", spacing", runs, &GrowthRun::spacing, watch));
    table.rows.push_back(growth_row(name + ", height", runs, &GrowthRun::height, watch));
    table.rows.push_back(growth_row(name + ", defects", runs, &GrowthRun::defects, watch));
    filled += "; " + name + ": " + one_crest_text(model, longest, seeds);
  }
  return "### Growth of transverse dunes\n\nSpacing grows as crests end and join, so defects become fewer as it does "
         "(Werner & Kocurek 1999). No exponents are in print for these models: the figures are ours. 10 slabs of sand "
         "a "
         "cell, 256 x 256 cells, mean over " +
         count_text(seeds, "seed") +
         ": spacing from crest to crest along the wind (cells), height from trough to crest of a sine of the surface's "
         "standard deviation (slabs), defects (ends of crests on the whole grid; where there is none the exponent "
         "takes "
         "half a one).\n\n" +
         table.markdown() +
         "\nWhere the torus is small one crest is all that is left in the end and the growth stops for want of room. "
         "On "
         "96 x 96 cells that was first so at step" +
         filled.substr(1) + ".\n";
}

}  // namespace erg::app
