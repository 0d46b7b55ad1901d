// What plants do to the shapes of dunes, beside the same terrain without them.
#include <cmath>

#include "app/validate/validation_nature.h"
#include "app/validate/validation_plants.h"

namespace erg::app {

using analysis::DuneMeans;

namespace {

constexpr double least_sigmas = 3;

/// A shape, and the number that tells it.
struct PlantLaw {
  const char* what;
  PlantScene scene;
  double DuneMeans::*number;
  const char* number_name;
  int sign;  ///< 1 where plants should raise it, -1 where they should lower it
};

std::vector<PlantLaw> plant_laws() {
  return {
      {"arms of parabolic dunes point upwind", {"parabolic", "parabolic", {}, 2000, 25}, &DuneMeans::arms, "arms", -1},
      {"the same of those that began as nebkhas, 96 x 96 cells",
       {"parabolic", "thesis/nield_parabolic", {"nx=96", "ny=96", "mesquite_low=0"}, 1500, 12},
       &DuneMeans::arms,
       "arms",
       -1},
      {"nebkhas have tails", {"nebkhas", "nebkhas", {}, 500, 6}, &DuneMeans::length_over_width, "length / width", 1}};
}

}  // namespace

std::string plants_make_shapes(const ValidationOptions& options) {
  const int seeds = options.quick ? 2 : 6;
  TextTable table;
  table.heading = {"law", "number", "with plants", "without", "sigmas", "differs"};
  for (const PlantLaw& law : plant_laws()) {
    if (options.quick && law.scene.settings.empty() && law.scene.steps > 1000) continue;
    PlantScene bare = law.scene;
    bare.settings.insert(bare.settings.end(), {"grass=false", "mesquite=false", "shrub=false"});
    say_measuring(std::string("plants, ") + law.what, 2 * seeds);
    const std::vector<DuneMeans> all = side_by_side<DuneMeans>(
        2 * seeds, [&](int job) { return shapes(job < seeds ? law.scene : bare, 1 + job % seeds); });
    Sample with;
    Sample without;
    for (int seed = 0; seed < seeds; ++seed) {
      with.add(all[static_cast<std::size_t>(seed)].*law.number);
      without.add(all[static_cast<std::size_t>(seeds + seed)].*law.number);
    }
    const double error = std::hypot(with.spread(), without.spread()) / std::sqrt(seeds);
    const double sigmas = law.sign * (with.mean() - without.mean()) / error;
    table.rows.push_back({law.what, law.number_name, with.text(2), without.text(2), fixed_text(sigmas, 1),
                          sigmas >= least_sigmas       ? "holds"
                          : sigmas >= least_sigmas / 2 ? "partly"
                                                       : "**fails**"});
  }
  return "### Plants make shapes\n\nArms of parabolic dunes are held back by plants and point upwind; nebkhas trail "
         "sand "
         "behind the plants that hold them. Presets of `cfg/` (steps 2000, 1500 and 500), mean over " +
         count_text(seeds, "seed") +
         ", and the same terrain without plants, by the same threshold; arms and length / width as in the section on "
         "dunes "
         "among plants. sigmas: the difference of the means, in the direction of the law, over its standard error; "
         "*holds* from " +
         fixed_text(least_sigmas, 0) + " on.\n\n" + table.markdown();
}

}  // namespace erg::app
