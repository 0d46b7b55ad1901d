// How the speed of a dune depends on its height: cones of several heights, each alone on bare ground.
#include <algorithm>
#include <cmath>

#include "analysis/dune_tracker.h"
#include "analysis/migration.h"
#include "analysis/morphometry.h"
#include "app/validate/validation_nature.h"

namespace erg::app {

using analysis::DuneTracker;
using analysis::Shift;
using sim::Simulation;

namespace {

constexpr double speed_exponent_bound = 0.2;

struct SpeedScene {
  const char* name;
  const char* model;
  std::vector<std::string> settings;
};

/// The models as in print, then with one rule taken away or put in, to find which rule it is.
std::vector<SpeedScene> speed_scenes() {
  return {{"Werner", "werner", {}},
          {"Momiji", "momiji", {}},
          {"Bishop", "bishop", {}},
          {"Momiji, hops of one length (`linear` 0, `quadratic` 0)", "momiji", {"linear=0", "quadratic=0"}},
          {"Momiji without the square (`quadratic` 0)", "momiji", {"quadratic=0"}}};
}

struct Mover {
  double height = 0;  ///< slabs, mean over the watch
  double speed = 0;   ///< cells a step
};

/// A cone of `height` slabs becomes a dune and is then watched.
Mover cone_run(const SpeedScene& scene, int height, int seed) {
  std::vector<std::string> settings{"grid.nx=320", "grid.ny=192", "scene.sand=0", "run.seed=" + std::to_string(seed)};
  settings.insert(settings.end(), scene.settings.begin(), scene.settings.end());
  Simulation simulation = lone_cones(nature_config(scene.model, settings), {{64, 96, height}});
  constexpr int settle = 200;
  constexpr int watch = 200;
  constexpr int every = 10;
  analysis::MigrationTracker tracker;
  Sample heights;
  for (int step = 1; step <= settle + watch; ++step) {
    simulation.step();
    if (step < settle || step % every != 0) continue;
    tracker.observe(step, analysis::coarse_surface(simulation.terrain(), analysis::Layer::mobile));
    heights.add(analysis::measure(simulation.terrain()).max_slabs);
  }
  const Shift velocity = tracker.velocity().value_or(Shift{});
  return {heights.mean(), std::hypot(velocity.x, velocity.y)};
}

double exponent(const std::vector<Mover>& movers) {
  std::vector<double> heights;
  std::vector<double> speeds;
  for (const Mover& mover : movers) {
    heights.push_back(mover.height);
    speeds.push_back(mover.speed);
  }
  return power_law(heights, speeds);
}

/// The dunes of a field that live through the watch, and how they move then.
std::vector<Mover> field_run(const SpeedScene& scene, int seed) {
  std::vector<std::string> settings{"grid.nx=384", "grid.ny=256", "scene.sand=3", "run.seed=" + std::to_string(seed)};
  settings.insert(settings.end(), scene.settings.begin(), scene.settings.end());
  Simulation simulation(nature_config(scene.model, settings));
  constexpr int settle = 1200;
  constexpr int watch = 100;
  constexpr int every = 10;
  DuneTracker tracker;
  while (simulation.step_count() < settle + watch) {
    simulation.step();
    const std::int64_t step = simulation.step_count();
    if (step < settle || step % every != 0) continue;
    tracker.observe(step, analysis::find_dunes(simulation.terrain(), 270).dunes, simulation.terrain());
    if (step == settle) tracker.start_ways();
  }
  std::vector<Mover> movers;
  for (std::size_t at = 0; at < tracker.dunes().size(); ++at) {
    const DuneTracker::Track& track = tracker.tracks()[at];
    const double speed = std::hypot(track.way.east, track.way.north) / watch;  // cells of a metre
    const bool lived = track.since == settle && speed > 0;
    if (lived) movers.push_back({tracker.dunes()[at].height / simulation.terrain().quantum(), speed});
  }
  return movers;
}

/// A table of the dunes of fields: how many, how high and fast, and the exponent over all of them.
std::string field_table(const std::vector<SpeedScene>& scenes, int seeds) {
  const auto jobs = static_cast<int>(scenes.size()) * seeds;
  say_measuring("speed in a field", jobs);
  const std::vector<std::vector<Mover>> all = side_by_side<std::vector<Mover>>(
      jobs, [&](int job) { return field_run(scenes[static_cast<std::size_t>(job / seeds)], 1 + job % seeds); });
  TextTable table;
  table.heading = {"model", "dunes", "heights", "speeds", "exponent", "1/H"};
  auto next = all.begin();
  for (const SpeedScene& scene : scenes) {
    std::vector<Mover> movers;
    for (int seed = 0; seed < seeds; ++seed, ++next) movers.insert(movers.end(), next->begin(), next->end());
    std::vector<std::string> row{scene.name, std::to_string(movers.size())};
    if (movers.size() < 4) {
      row.insert(row.end(), {"-", "-", "-", "too few"});
    } else {
      const auto [low, high] = std::ranges::minmax(movers, {}, &Mover::height);
      const auto [slow, fast] = std::ranges::minmax(movers, {}, &Mover::speed);
      const double power = exponent(movers);
      row.insert(row.end(), {fixed_text(low.height, 0) + " to " + fixed_text(high.height, 0),
                             fixed_text(slow.speed, 2) + " to " + fixed_text(fast.speed, 2), fixed_text(power, 2),
                             verdict(power + 1, speed_exponent_bound)});
    }
    table.rows.push_back(row);
  }
  return table.markdown();
}

}  // namespace

std::string speed_against_height(const ValidationOptions& options) {
  const std::vector<int> cones = options.quick ? std::vector<int>{60, 96} : std::vector<int>{48, 60, 78, 96};
  const int seeds = options.quick ? 1 : 2;
  TextTable table;
  table.heading = {"model"};
  for (const int height : cones) table.heading.push_back("cone of " + std::to_string(height));
  table.heading.insert(table.heading.end(), {"exponent", "1/H"});
  const std::vector<SpeedScene> scenes = speed_scenes();
  const auto sizes = static_cast<int>(cones.size());
  const int jobs = static_cast<int>(scenes.size()) * sizes * seeds;
  say_measuring("speed against height", jobs);
  const std::vector<Mover> all = side_by_side<Mover>(jobs, [&](int job) {
    return cone_run(scenes[static_cast<std::size_t>(job / (sizes * seeds))],
                    cones[static_cast<std::size_t>(job % sizes)], 1 + job / sizes % seeds);
  });
  auto next = all.begin();
  for (const SpeedScene& scene : scenes) {
    std::vector<Sample> height(cones.size());
    std::vector<Sample> speed(cones.size());
    Sample power;
    for (int seed = 0; seed < seeds; ++seed, next += sizes) {
      const std::vector<Mover> movers(next, next + sizes);
      for (std::size_t i = 0; i < movers.size(); ++i) {
        height[i].add(movers[i].height);
        speed[i].add(movers[i].speed);
      }
      power.add(exponent(movers));
    }
    std::vector<std::string> row{scene.name};
    for (std::size_t i = 0; i < cones.size(); ++i) {
      row.push_back(fixed_text(height[i].mean(), 1) + ": " + speed[i].text(3));
    }
    row.insert(row.end(), {power.text(2), verdict(power.mean() + 1, speed_exponent_bound)});
    table.rows.push_back(row);
  }
  return "### Speed against height\n\nA dune moves as fast as the flux over its crest fills its lee, v = q/H: an "
         "exponent of -1 where q is the same for all (Bagnold 1941). One cone of sand alone on bare ground, three "
         "times "
         "as wide as high, 320 x 192 cells, watched over steps 200 to 400; each column: height of the dune that became "
         "of it (slabs): its speed (cells a step), mean over " +
         count_text(seeds, "seed") + ". *holds* within " + fixed_text(speed_exponent_bound, 1) + ".\n\n" +
         table.markdown() +
         "\n**Momiji and Bishop do not obey 1/H, and it is the published hop law that does it**: a hop that grows by "
         "`linear` with each slab of height carries a flux over the crest that grows with the dune, so v = q/H tends "
         "to a speed of its own, `linear` / `p_sand` = 0.67 cells a step, which avalanches and shadow lower. With hops "
         "of "
         "one length the same model comes near it.\n\nDunes of a field, 3 slabs a cell, 384 x 256 cells, over steps "
         "1200 "
         "to 1300, all seeds together; dunes by the rules of `erg measure`, those that live through the watch; heights "
         "in slabs, speeds in cells a step:\n\n" +
         field_table(scenes, seeds);
}

}  // namespace erg::app
