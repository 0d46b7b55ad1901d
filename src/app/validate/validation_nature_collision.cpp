// What becomes of a small barchan that comes upon a larger one from behind.
#include <algorithm>
#include <cmath>

#include "analysis/dune_outlines.h"
#include "app/validate/validation_nature.h"

namespace erg::app {

using analysis::Dune;
using analysis::find_dunes;

namespace {

constexpr double least_share = 0.02;  // of all sand: a smaller patch counts for no dune

struct CollisionScene {
  const char* name;
  const char* model;
  std::vector<std::string> settings;
  int small;  ///< slabs: height of the cone behind
  int large;  ///< slabs: height of the cone in front
  int aside;  ///< cells that the small one lies beside the axis of the large one
};

struct Collision {
  double before = 0;  ///< sand of the small one over that of the large one, before they meet
  int met = 0;        ///< step of the first look at which one outline holds both; 0: never
  int parted = 0;     ///< step of the first later look at which two dunes stand there again; 0: never
  double front = 0;   ///< then: sand of the one in front over that of the one behind
  double kept = 0;    ///< sand within dunes over all sand, in the end
};

constexpr int columns = 512;
constexpr int rows = 192;

std::vector<Dune> large_enough(const Terrain& terrain) {
  const double all = static_cast<double>(terrain.total_mobile()) * terrain.quantum();
  std::vector<Dune> dunes = find_dunes(terrain, 270).dunes;
  std::erase_if(dunes, [&](const Dune& dune) { return dune.volume < least_share * all; });
  std::ranges::sort(dunes, std::ranges::greater{}, &Dune::volume);
  return dunes;
}

/// Sand of the dune farther downwind over that of the other: of the two largest, on the shorter way around the torus.
double front_over_back(const std::vector<Dune>& dunes) {
  const double ahead = std::remainder(dunes[1].x - dunes[0].x, columns);
  return ahead > 0 ? dunes[1].volume / dunes[0].volume : dunes[0].volume / dunes[1].volume;
}

Collision collide(const CollisionScene& scene, int steps, int seed) {
  std::vector<std::string> settings{"grid.nx=" + std::to_string(columns), "grid.ny=" + std::to_string(rows),
                                    "scene.sand=0", "run.seed=" + std::to_string(seed)};
  settings.insert(settings.end(), scene.settings.begin(), scene.settings.end());
  const int gap = scene.large / 2 + scene.small / 2 + 40;
  sim::Simulation simulation =
      lone_cones(nature_config(scene.model, settings),
                 {{80, rows / 2 + scene.aside, scene.small}, {80 + gap, rows / 2, scene.large}});
  Collision collision;
  constexpr int every = 25;
  constexpr int become_dunes = 100;
  while (simulation.step_count() < steps) {
    for (int step = 0; step < every; ++step) simulation.step();
    const auto now = static_cast<int>(simulation.step_count());
    const std::vector<Dune> dunes = large_enough(simulation.terrain());
    if (now == become_dunes && dunes.size() >= 2) collision.before = dunes[1].volume / dunes[0].volume;
    if (now >= become_dunes && collision.met == 0 && dunes.size() == 1) collision.met = now;
    if (collision.met > 0 && collision.parted == 0 && dunes.size() >= 2) {
      collision.parted = now;
      collision.front = front_over_back(dunes);
    }
  }
  double sand = 0;
  for (const Dune& dune : find_dunes(simulation.terrain(), 270).dunes) sand += dune.volume;
  collision.kept = sand / (static_cast<double>(simulation.terrain().total_mobile()) * simulation.terrain().quantum());
  return collision;
}

std::string outcome(const Collision& collision) {
  if (collision.before == 0) return "one of them is no dune";
  if (collision.met == 0) return "never meet";
  if (collision.parted == 0) return "merge at " + std::to_string(collision.met);
  return "meet at " + std::to_string(collision.met) + ", part at " + std::to_string(collision.parted) + ", front " +
         fixed_text(collision.front, 2);
}

}  // namespace

std::string barchan_collision(const ValidationOptions& options) {
  const std::vector<std::string> level{"linear=0", "quadratic=0"};
  std::vector<CollisionScene> scenes;
  for (const auto& [small, aside] : {std::pair{54, 0}, {66, 0}, {78, 0}, {66, 32}}) {
    if (options.quick && small != 66) continue;
    scenes.push_back({"Werner", "werner", {}, small, 96, aside});
    scenes.push_back({"Momiji", "momiji", {}, small, 96, aside});
  }
  const int steps = options.quick ? 1200 : 3000;
  const int seeds = options.quick ? 1 : 2;
  const int jobs = static_cast<int>(scenes.size()) * seeds;
  say_measuring("collision", jobs);
  const std::vector<Collision> all = side_by_side<Collision>(
      jobs, [&](int job) { return collide(scenes[static_cast<std::size_t>(job / seeds)], steps, 1 + job % seeds); });
  TextTable table;
  table.heading = {"model", "cones", "aside", "small over large", "what happens, by seed"};
  auto next = all.begin();
  for (const CollisionScene& scene : scenes) {
    Sample before;
    std::string outcomes;
    for (int seed = 0; seed < seeds; ++seed, ++next) {
      before.add(next->before);
      outcomes += (outcomes.empty() ? "" : "; ") + outcome(*next);
    }
    table.rows.push_back({scene.name, std::to_string(scene.small) + " behind " + std::to_string(scene.large),
                          std::to_string(scene.aside), before.text(2), outcomes});
  }
  return "### Two barchans collide\n\nA small barchan that comes upon a much larger one is taken up by it; one that is "
         "not so small gives it sand until a dune leaves it in front, as if the small one had passed through (Duran et "
         "al. 2005; Jarvis et al. 2023, who find the change at half the area, in two dimensions). Two cones on bare "
         "ground, " +
         std::to_string(columns) + " x " + std::to_string(rows) +
         " cells, heights in slabs, the small one upwind and so many cells aside; " + std::to_string(steps) +
         " steps, looked at every 25; dunes by the rules of `erg measure`, none with less than " +
         fixed_text(100 * least_share, 0) +
         "% of the sand. small over large: of their sand at step 100; *meet*: one outline holds both; *part*: two "
         "stand "
         "there again, *front* being the sand of the one in front over that of the one behind.\n\n" +
         table.markdown();
}

}  // namespace erg::app
