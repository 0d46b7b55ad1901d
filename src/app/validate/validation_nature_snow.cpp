// Mounds of snow that bonds slow down and stop, beside the same mounds of snow that does not bond.
#include <cmath>

#include "analysis/heap_middle.h"
#include "app/validate/validation_nature.h"

namespace erg::app {

using analysis::heap_middle;

namespace {

constexpr double slow_down_bound = 0.1;  // beyond which a ratio of speeds differs from its control

struct Mound {
  const char* name;
  int radius;          ///< cells of 0.1 m
  const char* height;  ///< m
  bool stops;          ///< in nature
};

struct MoundSpeeds {
  double first_hour = 0;  ///< way of its middle, cells
  double last_hour = 0;
  double left = 0;  ///< share of the snow within its first outline
};

MoundSpeeds mound_run(const Mound& mound, bool bonds, int hours, int seed) {
  sim::Simulation simulation(nature_config(
      "snow_sintering",
      {"grid.nx=160", "grid.ny=96", "grid.cell_size=0.1", "scene.kind=cone", "scene.sand=0",
       std::string("scene.height=") + mound.height, "scene.radius=" + std::to_string(mound.radius), "wind.strength=9",
       bonds ? "bonding_time=12" : "bonding_time=1000000", "run.seed=" + std::to_string(seed)}));
  const Grid<std::int32_t> before = simulation.terrain().mobile();
  MoundSpeeds speeds;
  for (int hour = 1; hour <= hours; ++hour) {
    const double start = heap_middle(simulation.terrain().mobile(), mound.radius);
    for (int step = 0; step < 60; ++step) simulation.step();
    const double end = heap_middle(simulation.terrain().mobile(), mound.radius);
    (hour == 1 ? speeds.first_hour : speeds.last_hour) = std::remainder(end - start, 160.0);
  }
  double inside = 0;
  for (std::size_t cell = 0; cell < before.size(); ++cell) {
    if (before[cell] > 0) inside += simulation.terrain().mobile()[cell];
  }
  speeds.left = inside / static_cast<double>(simulation.terrain().total_mobile());
  return speeds;
}

}  // namespace

std::string sintering_slows_mounds(const ValidationOptions& options) {
  const std::vector<Mound> mounds{{"2 m across, 0.2 m high", 10, "0.2", false},
                                  {"8 m across, 0.8 m high", 40, "0.8", true}};
  const int seeds = options.quick ? 1 : 3;
  const int hours = options.quick ? 6 : 12;
  const std::string last = "hour " + std::to_string(hours);
  TextTable table;
  table.heading = {"mound", "snow", "kept where it lay", "hour 1", last, last + " over hour 1", "as the law says"};
  const auto each = 2 * seeds;
  const int jobs = static_cast<int>(mounds.size()) * each;
  say_measuring("sintering", jobs);
  const std::vector<MoundSpeeds> all = side_by_side<MoundSpeeds>(jobs, [&](int job) {
    return mound_run(mounds[static_cast<std::size_t>(job / each)], job % each < seeds, hours, 1 + job % seeds);
  });
  auto next = all.begin();
  for (const Mound& mound : mounds) {
    Sample ratios[2];
    for (const bool bonds : {true, false}) {
      Sample left, first, final, ratio;
      for (int seed = 0; seed < seeds; ++seed, ++next) {
        left.add(next->left);
        first.add(next->first_hour);
        final.add(next->last_hour);
        ratio.add(next->last_hour / next->first_hour);
      }
      ratios[bonds ? 0 : 1] = ratio;
      table.rows.push_back({bonds ? mound.name : "", bonds ? "bonds" : "does not", left.text(2), first.text(2),
                            final.text(2), ratio.text(2), ""});
    }
    const double slower = ratios[1].mean() - ratios[0].mean();
    table.rows.back().back() = (slower > slow_down_bound) == mound.stops ? "holds" : "**fails**";
  }
  return "### Bonding stops mounds of snow\n\nSintering overtakes what moves slowly: large dunes of snow stop, small "
         "ones go on (Sharma et al. 2019). Mounds at 9 m/s and -10 °C, mean over " +
         count_text(seeds, "seed") +
         "; *does not*: `bonding_time` 1000000 h. Way of the middle of what lies near the thickest line across the "
         "wind, cells of 0.1 m in an hour. *holds*: with bonding the ratio of the last hour to the first is lower than "
         "without by more than " +
         fixed_text(slow_down_bound, 1) +
         " for the large mound, and is not for the small one. How much of a mound lies where it lay tells nothing: a "
         "large one keeps its snow "
         "without bonding too, for want of time.\n\n" +
         table.markdown();
}

}  // namespace erg::app
