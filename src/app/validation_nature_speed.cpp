// How the speed of a dune depends on its height: cones of several heights, each alone on bare ground.
#include <cmath>

#include "analysis/migration.h"
#include "analysis/morphometry.h"
#include "app/validation_nature.h"

namespace erg {
namespace {

constexpr double exponent_bound = 0.2;

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
  std::vector<std::string> settings{"grid.nx=320",
                                    "grid.ny=192",
                                    "scene.kind=cone",
                                    "scene.sand=0",
                                    "scene.height=" + fixed_text(height / 3.0, 3),
                                    "scene.radius=" + fixed_text(height * 2.0 / 3, 1),
                                    "run.seed=" + std::to_string(seed)};
  settings.insert(settings.end(), scene.settings.begin(), scene.settings.end());
  Simulation simulation(nature_config("", scene.model, settings));
  constexpr int settle = 200;
  constexpr int watch = 200;
  constexpr int every = 10;
  MigrationTracker tracker;
  Sample heights;
  for (int step = 1; step <= settle + watch; ++step) {
    simulation.step();
    if (step < settle || step % every != 0) continue;
    tracker.observe(step, coarse_surface(simulation.terrain(), Layer::mobile));
    heights.add(measure(simulation.terrain()).max_slabs);
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

}  // namespace

std::string speed_against_height(const ValidationOptions& options) {
  const std::vector<int> cones = options.quick ? std::vector<int>{36, 72} : std::vector<int>{36, 48, 60, 78, 96};
  const int seeds = options.quick ? 1 : 3;
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
    row.insert(row.end(), {power.text(2), verdict(power.mean() + 1, exponent_bound)});
    table.rows.push_back(row);
  }
  return "### Speed against height\n\nA dune moves as fast as the flux over its crest fills its lee, v = q/H: an "
         "exponent of -1 (Bagnold 1941). One cone of sand alone on bare ground, 320 x 192 cells, a third of its width "
         "high (slabs of a third of a cell), watched over steps 200 to 400; each column: height of the dune that "
         "became of it (slabs): its speed (cells a step), mean over " +
         count_text(seeds, "seed") + ". *holds* within " + fixed_text(exponent_bound, 1) + ".\n\n" + table.markdown();
}

}  // namespace erg
