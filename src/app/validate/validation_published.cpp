// Published maxima, and the identities that are algebra.
#include <cmath>
#include <optional>

#include "app/cli/text_table.h"
#include "app/validate/sample.h"
#include "app/validate/validation.h"
#include "core/units.h"
#include "kernels/shadow.h"

namespace erg::app {

using sim::Config;

namespace {

/// A row of print: one run of one program. Its settings stand in tables 6.1 to 6.7 of Cimbura 2022 and the text beside
/// them, its height in the captions of figures 6.1 to 6.13.
struct PublishedScene {
  const char* preset;  ///< in cfg/thesis/
  int max_slabs;       ///< 0: not printed
  bool large;          ///< left out by --quick
};

constexpr PublishedScene published_scenes[] = {
    {"werner_barchans", 26, false}, {"werner_transverse", 28, false}, {"werner_star", 23, false},
    {"werner_linear", 0, false},    {"momiji_barchans", 26, false},   {"momiji_transverse", 34, true},
    {"momiji_star", 22, false},     {"bishop_barchans", 28, false},   {"momiji_barchans_1024", 29, true},
    {"momiji_rocks", 0, true},      {"nield_nebkhas", 58, false},     {"nield_parabolic", 85, true},
    {"nield_blowouts", 76, true},   {"nield_islands", 57, false},     {"snow_ripples", 0, false},
};

constexpr double most_deviation = 0.15;  // of a height in print

/// The deviations of some heights from print, and how many are small enough.
class Deviations {
 public:
  /// In bold where it is too large.
  std::string add(double value, double reference) {
    const double deviation = value / reference - 1;
    const std::string text = fixed_text(deviation * 100, 0) + "%";
    ++all_;
    if (std::abs(deviation) > most_deviation) return "**" + text + "**";
    ++met_;
    return text;
  }
  /// "28 of 28"
  std::string met() const { return std::to_string(met_) + " of " + std::to_string(all_); }

 private:
  int met_ = 0;
  int all_ = 0;
};

/// The scene under a wind that swings as the model has it by itself; nothing where that has none.
std::optional<Config> with_natural_spread(const Config& config) {
  const double spread = Config(config.model).wind.intervals.front().spread;
  if (spread == 0) return std::nullopt;
  Config swinging = config;
  for (forcing::WindInterval& season : swinging.wind.intervals) season.spread = spread;
  swinging.title += ", spread " + fixed_text(spread, 0);
  return swinging;
}

double max_slabs(const SeedRun& run) { return run.end.shape.max_slabs; }

struct Identity {
  std::string what;
  double exact;
  double measured;
};

/// One step on a flat bed of sand on which every cell is polled once and nothing lies in shadow.
Identity flat_bed(const char* what, const char* chance, double exact) {
  Config config("werner");
  for (const std::string& assignment :
       {std::string("scene.kind=flat"), std::string("scene.sand=50"), std::string("parameters.polling=nonrepeated"),
        std::string("parameters.shadow_angle=80"), std::string("parameters.p_sand=") + chance}) {
    sim::set_from_text(config, assignment);
  }
  sim::Simulation simulation(config);
  const models::StepReport report = simulation.step();
  return {what, exact, report.travel / static_cast<double>(report.lifts)};
}

}  // namespace

std::vector<std::string> published_presets() {
  std::vector<std::string> presets;
  for (const PublishedScene& scene : published_scenes) presets.push_back(scene.preset);
  return presets;
}

std::string published_section(const ValidationOptions& options) {
  const int seeds = options.quick ? 1 : 3;
  TextTable table;
  Deviations steady;
  Deviations swung;
  table.heading = {"scene", "in print", "serial", "deviation", "cpu", "deviation", "cpu, spread 10", "deviation"};
  for (const PublishedScene& scene : published_scenes) {
    if (!options.scene.empty() ? options.scene != scene.preset : options.quick && scene.large) continue;
    const Config config = thesis_config(scene.preset);
    std::vector<std::string> row{config.title, scene.max_slabs > 0 ? std::to_string(scene.max_slabs) : "-"};
    const auto add = [&](const Sample& highest, Deviations& deviations) {
      row.push_back(highest.text(1));
      row.push_back(scene.max_slabs > 0 ? deviations.add(highest.mean(), scene.max_slabs) : "-");
    };
    for (const char* executor : {"serial", "cpu"})
      add(sample_of(run_seeds(config, executor, seeds), max_slabs), steady);
    const std::optional<Config> swinging = with_natural_spread(config);
    if (swinging && !scene.large) {
      add(sample_of(run_seeds(*swinging, "cpu", seeds), max_slabs), swung);
    } else {
      row.insert(row.end(), 2, "-");
    }
    table.rows.push_back(row);
  }
  return "## Thickest column, in slabs, beside print\n\nPrinted figures: one run each of another program (Cimbura "
         "2022, captions of figures 6.1 to 6.13; settings from tables 6.1 to 6.7 and the text beside them; -: no "
         "height is printed). Ours: mean over " +
         count_text(seeds, "seed") +
         ", spread over the seeds in brackets. The presets have winds that do not swing, as in print; the last columns "
         "are of the same with the spread that Werner's, Momiji's and Bishop's models have by themselves (small scenes "
         "only).\n\n" +
         table.markdown() + "\nWithin " + fixed_text(most_deviation * 100, 0) +
         "% of print (others bold): " + steady.met() + " heights under the winds of print, " + swung.met() +
         " with a spread, where under an oblique wind shadow is looked for farther upwind "
         "([conventions](conventions.md#wind)).\n";
}

std::string identities_section() {
  const Identity identities[] = {
      flat_bed("mean travel of a slab on flat sand, L 5, p_s .6: 5/.6 cells (so 8.33 slabs pass a cell a step)", "0.6",
               5 / 0.6),
      flat_bed("mean travel with the chance of bare ground, .4: 5/.4 cells", "0.4", 5 / 0.4),
      {"repose 33.69°, slab 1/3 of a cell: step in slabs", 2, double(critical_step(33.69, 1.0, 1.0 / 3))},
      {"shadow line of 15°, slab 1/3 of a cell: fall in slabs a cell", 3 * std::tan(radians(15)),
       kernels::shadow_fall(15, 1.0, 1.0 / 3)},
  };
  TextTable table;
  table.heading = {"what", "exact", "measured"};
  for (const Identity& identity : identities) {
    table.rows.push_back({identity.what, fixed_text(identity.exact, 3), fixed_text(identity.measured, 3)});
  }
  return "## Identities\n\nAlgebra says what these must be; the measured travel is a mean over 65536 slabs, so its "
         "third digit is chance.\n\n" +
         table.markdown();
}

}  // namespace erg::app
