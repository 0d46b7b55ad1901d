// How many arms a heap of sand grows under several equal winds.

#include "analysis/star_arms.h"
#include "app/validate/validation_nature.h"
#include "core/units.h"

namespace erg::app {

using analysis::StarArms;

namespace {

struct StarScene {
  const char* name;
  const char* model;
  int cone;  ///< slabs: height of the heap at the start
  int side;  ///< cells
  std::vector<std::string> settings;
};

StarArms star_run(const StarScene& scene, int winds, int season, int steps, int seed) {
  const std::string side = std::to_string(scene.side);
  std::vector<std::string> settings{"grid.nx=" + side, "grid.ny=" + side, "scene.sand=0",
                                    "run.seed=" + std::to_string(seed)};
  settings.insert(settings.end(), scene.settings.begin(), scene.settings.end());
  sim::Config config = nature_config(scene.model, settings);
  forcing::WindInterval one = config.wind.intervals.at(0);
  one.steps = season;
  config.wind.intervals.clear();
  for (int wind = 0; wind < winds; ++wind) {
    one.bearing = fold_bearing(20 + 360.0 * wind / winds);  // none along an axis of the grid
    config.wind.intervals.push_back(one);
  }
  sim::Simulation simulation = lone_cones(config, {{scene.side / 2, scene.side / 2, scene.cone}});
  while (simulation.step_count() < steps) simulation.step();
  const std::vector<StarArms> stars = analysis::find_stars(simulation.terrain(), scene.side / 2.0);
  return stars.empty() ? StarArms{} : stars.front();
}

}  // namespace

std::string star_dune_arms(const ValidationOptions& options) {
  const std::vector<StarScene> scenes{
      {"Werner", "werner", 72, 192, {}},
      {"Werner, 8 neighbours, a cone of 120 slabs", "werner", 120, 256, {"neighbours=8"}},
      {"Momiji", "momiji", 72, 192, {}}};
  const std::vector<int> seasons = options.quick ? std::vector<int>{20} : std::vector<int>{10, 40};
  const std::vector<int> winds{3, 4, 5};
  const int seeds = options.quick ? 1 : 3;
  const int steps = options.quick ? 600 : 1800;
  TextTable table;
  table.heading = {"model", "season"};
  for (const int count : winds) {
    table.heading.push_back(std::to_string(count) + " winds: arms, by seed (depth)");
    table.heading.push_back("as many");
  }
  const auto kinds = static_cast<int>(winds.size());
  const auto lengths = static_cast<int>(seasons.size());
  const int jobs = static_cast<int>(scenes.size()) * lengths * kinds * seeds;
  say_measuring("stars", jobs);
  const std::vector<StarArms> all = side_by_side<StarArms>(jobs, [&](int job) {
    const auto at = [](int index) { return static_cast<std::size_t>(index); };
    return star_run(scenes[at(job / seeds / kinds / lengths)], winds[at(job / seeds % kinds)],
                    seasons[at(job / seeds / kinds % lengths)], steps, 1 + job % seeds);
  });
  auto next = all.begin();
  for (const StarScene& scene : scenes) {
    for (const int season : seasons) {
      std::vector<std::string> row{scene.name, std::to_string(season)};
      for (const int count : winds) {
        std::string arms;
        Sample depth;
        int right = 0;
        for (int seed = 0; seed < seeds; ++seed, ++next) {
          arms += (arms.empty() ? "" : ", ") + std::to_string(next->arms);
          depth.add(next->depth);
          if (next->arms == count) ++right;
        }
        row.push_back(arms + " (" + fixed_text(depth.mean(), 2) + ")");
        row.push_back(right == seeds ? "holds" : right > 0 ? "partly" : "**fails**");
      }
      table.rows.push_back(row);
    }
  }
  return "### Arms of star dunes\n\nA heap under n equal winds that add to nothing grows n arms (Zhang et al. 2012). A "
         "cone of 72 slabs on bare ground, 192 x 192 cells (of 120: 256 x 256), " +
         std::to_string(steps) +
         " steps under winds that take turns by *season* steps; arms: harmonics of the plan form about the middle, 0 "
         "for a dome (src/analysis/star_arms.h); *holds*: as many as winds in every seed, *partly*: in some.\n\n" +
         table.markdown() +
         "\nWith slides along rows and columns alone Werner's four arms are the grid's doing: a pyramid with its "
         "corners "
         "along the axes, under five winds too. With 8 neighbours the four ridges of a large heap turn with the winds "
         "([forms](forms.md#star-dunes) has bearings, and what was tried for five).\n";
}

}  // namespace erg::app
