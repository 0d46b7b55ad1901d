// How the length of ripples rises with the wind, from a flat bed on.
#include "analysis/crests.h"
#include "app/validate/validation_nature.h"

namespace erg::app {
namespace {

constexpr double length_exponent_bound = 0.3;

struct RippleRun {
  std::vector<double> lengths;  ///< cm, at each of the watched steps
  double leap = 0;              ///< cm, mean way between two touches of the ground in the first of them
};

RippleRun ripple_run(double friction, const std::vector<int>& watch, int seed) {
  sim::Simulation simulation(
      nature_config("grains", {"grid.nx=256", "grid.ny=32", "strength_is=friction_velocity",
                               "wind.strength=" + fixed_text(friction, 2), "run.seed=" + std::to_string(seed)}));
  RippleRun run;
  for (const int last : watch) {
    while (simulation.step_count() < last) simulation.step();
    run.lengths.push_back(
        analysis::crest_spacing(analysis::coarse_surface(simulation.terrain(), analysis::Layer::surface), 270));
    if (run.leap > 0) continue;
    for (const models::Diagnostic& one : simulation.model().diagnostics()) {
      if (one.key == "hop") run.leap = 100 * one.value;
    }
  }
  return run;
}

}  // namespace

std::string ripples_against_wind(const ValidationOptions& options) {
  const std::vector<double> winds =
      options.quick ? std::vector<double>{0.25, 0.4, 0.6} : std::vector<double>{0.2, 0.3, 0.4, 0.5, 0.6};
  const std::vector<int> watch = options.quick ? std::vector<int>{4, 8} : std::vector<int>{5, 10, 20, 40};
  const int seeds = options.quick ? 1 : 2;
  const auto sizes = static_cast<int>(winds.size());
  say_measuring("ripples", sizes * seeds);
  const std::vector<RippleRun> all = side_by_side<RippleRun>(sizes * seeds, [&](int job) {
    return ripple_run(winds[static_cast<std::size_t>(job % sizes)], watch, 1 + job / sizes);
  });
  TextTable table;
  table.heading = {"step"};
  for (const double wind : winds) table.heading.push_back("u* " + fixed_text(wind, 2));
  table.heading.insert(table.heading.end(), {"by u*", "linear", "by leap", "as the leap"});
  for (std::size_t at = 0; at < watch.size(); ++at) {
    std::vector<Sample> lengths(winds.size());
    Sample by_wind, by_leap;
    for (int seed = 0; seed < seeds; ++seed) {
      std::vector<double> length;
      std::vector<double> leap;
      for (std::size_t wind = 0; wind < winds.size(); ++wind) {
        const RippleRun& run = all[static_cast<std::size_t>(seed) * winds.size() + wind];
        length.push_back(run.lengths[at]);
        leap.push_back(run.leap);
        lengths[wind].add(run.lengths[at]);
      }
      by_wind.add(power_law(winds, length));
      by_leap.add(power_law(leap, length));
    }
    std::vector<std::string> row{std::to_string(watch[at])};
    for (const Sample& length : lengths) row.push_back(length.text(1));
    row.insert(row.end(), {by_wind.text(2), verdict(by_wind.mean() - 1, length_exponent_bound), by_leap.text(2),
                           verdict(by_leap.mean() - 1, length_exponent_bound)});
    table.rows.push_back(row);
  }
  return "### Ripple length against wind\n\nBoth the first length of ripples on a flat bed and the last are linear in "
         "the friction velocity (Andreotti et al. 2006); Bagnold (1941) has them as long as the grains' mean leap. "
         "Model `grains` with its defaults, 256 x 32 cells of 1 cm, mean over " +
         count_text(seeds, "seed") +
         ": length from crest to crest (`crest_spacing`), cm, by steps from a flat bed and friction velocity, m/s; by "
         "u*, by leap: exponent of length against the one and the other, the leaps being those of the young bed "
         "(step " +
         std::to_string(watch.front()) + "); 1 is linear, *holds* within " + fixed_text(length_exponent_bound, 1) +
         ".\n\n" + table.markdown();
}

}  // namespace erg::app
