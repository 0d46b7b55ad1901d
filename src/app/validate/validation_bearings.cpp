// Whether dunes are the same dunes at every bearing of the wind: one barchan, crests under two winds, and fields; with
// a wind that swings and with one that does not.
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/dune_map.h"
#include "analysis/spectrum.h"
#include "app/cli/text_table.h"
#include "app/validate/sample.h"
#include "app/validate/validation.h"
#include "app/validate/validation_nature.h"
#include "core/units.h"
#include "forcing/bearing.h"

namespace erg::app {

using analysis::DuneMap;
using analysis::GridPoint;
using analysis::mean_map;
using analysis::SpectrumNumbers;
using forcing::bearing_of;
using models::natural_spread;
using sim::Config;
using sim::set_from_text;
using sim::Simulation;

namespace {

constexpr int reach = 90;           // cells around a dune's middle
constexpr double least_sand = 0.5;  // m: thinner is no horn

/// Degrees from -180 to 180.
double signed_angle(double angle) { return std::remainder(angle, 360.0); }

// --- one barchan ---

/// A cone of sand that becomes one barchan.
struct LoneDune {
  const char* name;
  const char* model;
  std::vector<std::string> settings;
  double inflow;  ///< slabs a step that come in for each cell across the wind over open edges; 0 on a torus
  int seeds;
  bool on_serial;
};

/// A lone dune of Werner's model gives off sand all round. On a torus that comes back to it otherwise at every bearing,
/// so it stands on an open grid into which the same comes from all.
std::vector<LoneDune> lone_dunes() {
  const std::vector<std::string> cone{"scene.height=12", "scene.radius=36"};
  const std::vector<std::string> open{"scene.height=20", "scene.radius=60", "grid.nx=288", "grid.ny=288",
                                      "grid.boundary=open"};
  std::vector<std::string> round = open;
  round.emplace_back("parameters.neighbours=8");
  return {{"werner", "werner", open, 3, 4, false},
          {"werner, 8 neighbours", "werner", round, 3, 4, true},
          {"momiji", "momiji", cone, 0, 3, true},
          {"bishop", "bishop", cone, 0, 3, true}};
}

/// Bearings to watch one barchan at; `few`: where that takes long.
std::vector<double> barchan_bearings(bool few) {
  if (few) return {270, 285, 300};
  return {225, 250, 270, 285, 300, 315, 330};
}

struct BarchanLook {
  LoneDune dune;
  std::string executor;
  double spread;
};

struct BarchanRun {
  DuneMap map;
  GridPoint velocity;  ///< cells a step
};

BarchanRun grow_barchan(const BarchanLook& look, double bearing, int steps, int seed) {
  Config config(look.dune.model);
  for (const std::string& setting :
       {std::string("scene.kind=cone"), std::string("scene.sand=0"), "run.executor=" + look.executor,
        std::string("run.threads=1"), "run.seed=" + std::to_string(seed)}) {
    set_from_text(config, setting);
  }
  for (const std::string& setting : look.dune.settings) set_from_text(config, setting);
  if (look.dune.inflow > 0) {  // a cell of the edge that faces the wind most stands for less than one across it
    const double share = std::max(std::abs(std::sin(radians(bearing))), std::abs(std::cos(radians(bearing))));
    set_from_text(config, "grid.inflow=" + std::to_string(look.dune.inflow * share));
  }
  config.wind.intervals.front().bearing = bearing;
  config.wind.intervals.front().spread = look.spread;
  Simulation simulation(config);
  const auto step_to = [&](int step) {
    while (simulation.step_count() < step) simulation.step();
    return analysis::dune_centre(simulation.terrain()).value();
  };
  const GridPoint before = step_to(steps / 2);
  const GridPoint after = step_to(steps);
  const int watched = steps - steps / 2;
  const Extent extent = simulation.terrain().extent();
  return {analysis::dune_map(simulation.terrain(), bearing, reach),
          {std::remainder(after.x - before.x, extent.nx) / watched,
           std::remainder(after.y - before.y, extent.ny) / watched}};
}

/// A barchan at one bearing, over the seeds.
struct BarchanAt {
  double bearing;
  DuneMap map;
  double horns;  ///< sand in the left one over sand in the right one, geometric mean
  double speed;  ///< cells a step
  double off;    ///< direction of migration from the wind's, degrees
};

BarchanAt barchan_at(double bearing, const std::vector<BarchanRun>& runs) {
  std::vector<DuneMap> maps;
  double logs = 0;
  GridPoint velocity;
  for (const BarchanRun& run : runs) {
    maps.push_back(run.map);
    const analysis::HornVolumes horns = analysis::find_horns(run.map, least_sand);
    logs += std::log((horns.left + 1) / (horns.right + 1));  // a hornless dune has a ratio too
    velocity.x += run.velocity.x / static_cast<double>(runs.size());
    velocity.y += run.velocity.y / static_cast<double>(runs.size());
  }
  return {bearing, mean_map(maps), std::exp(logs / static_cast<double>(runs.size())),
          std::hypot(velocity.x, velocity.y), signed_angle(bearing_of({velocity.x, velocity.y}) - bearing)};
}

double height_of(const DuneMap& map) { return *std::ranges::max_element(map.height.cells()); }

void add_barchan_rows(TextTable& table, const BarchanLook& look, const std::vector<double>& bearings, int steps,
                      int seeds) {
  const int jobs = static_cast<int>(bearings.size()) * seeds;
  say_measuring(
      std::string("one barchan, ") + look.dune.name + ", " + look.executor + ", spread " + fixed_text(look.spread, 0),
      jobs);
  const std::vector<BarchanRun> runs = side_by_side<BarchanRun>(jobs, [&](int job) {
    return grow_barchan(look, bearings[static_cast<std::size_t>(job / seeds)], steps, 1 + job % seeds);
  });
  std::vector<BarchanAt> dunes;
  std::vector<DuneMap> maps;
  double mean_speed = 0;
  for (std::size_t k = 0; k < bearings.size(); ++k) {
    const auto first = runs.begin() + static_cast<std::ptrdiff_t>(k) * seeds;
    dunes.push_back(barchan_at(bearings[k], {first, first + seeds}));
    maps.push_back(dunes.back().map);
    mean_speed += dunes.back().speed / static_cast<double>(bearings.size());
  }
  const DuneMap all = mean_map(maps);
  for (const BarchanAt& dune : dunes) {
    table.rows.push_back({look.dune.name, look.executor, fixed_text(look.spread, 0), fixed_text(dune.bearing, 0),
                          fixed_text(analysis::asymmetry(dune.map), 3), fixed_text(dune.horns, 2),
                          fixed_text(analysis::mismatch(dune.map, all), 3), fixed_text(height_of(dune.map), 1),
                          fixed_text(dune.speed, 3), fixed_text((dune.speed / mean_speed - 1) * 100, 1) + "%",
                          fixed_text(dune.off, 1)});
  }
}

std::string one_barchan(const ValidationOptions& options) {
  const int steps = options.quick ? 128 : 384;  // whole rounds of draws, or the dune would remember the last ones
  TextTable table;
  table.heading = {"model",    "executor", "spread", "bearing",     "asymmetry",    "horns",
                   "mismatch", "height",   "speed",  "of the mean", "direction off"};
  for (const LoneDune& dune : lone_dunes()) {
    const int seeds = options.quick ? 1 : dune.seeds;
    for (const char* executor : {"cpu", "serial"}) {
      const bool slow = executor == std::string("serial");
      if (slow && (options.quick || !dune.on_serial)) continue;
      add_barchan_rows(table, {dune, executor, natural_spread}, barchan_bearings(options.quick || slow), steps, seeds);
    }
    add_barchan_rows(table, {dune, "cpu", 0}, barchan_bearings(options.quick), steps, seeds);
  }
  return "One dune, a cone of 12 m and 36 cells' radius at the start, " + std::to_string(steps) +
         " steps with the model's defaults on 256 x 256 cells, in the mean of " +
         (options.quick ? "1 seed" : "3 seeds") +
         " turned into the wind. Werner's dunes give off sand all round, and what comes back over the edges of a torus "
         "comes otherwise at each bearing: there a cone of 20 m and 60 cells' radius stands on an open grid of 288 x "
         "288 cells into which 3 slabs a step come for each cell across the wind, in the mean of " +
         (options.quick ? "1 seed" : "4 seeds") +
         ". asymmetry: the share of sand that would have to move for its mirror image (2%, of Werner's 4%, is noise of "
         "the seeds); horns: sand in the left one over that in the right one, of what lies further downwind than the "
         "foot of the slip face; mismatch: the share of sand that lies elsewhere than in the mean over the bearings; "
         "height: m; speed: cells a step; direction off: of the migration from the wind, degrees. Asked of the rows "
         "with a spread: asymmetry and mismatch up to 0.06, horns from 0.6 to 1.6, speed within 5% of the mean, "
         "direction within 1 degree.\n\n" +
         table.markdown() +
         "\nWerner's windward slopes are as steep as sand stands. Slides along rows and columns make the toe a corner "
         "of a "
         "pyramid that points along the axes, at whatever bearing: that is the lean of Werner's rows between axis and "
         "diagonal. With `neighbours` 8, slides along diagonals too, its dunes are round and alike on `cpu`, but for "
         "the "
         "diagonal, where they lose more sand and are the faster for it (5.5%), and for a drift of 1.1 degrees at 250. "
         "On `serial` a lean of 0.09 is left, and they drift toward the axis by up to 4 degrees.\n"
         "\nTried for the lean, Momiji at 250 and 300 degrees with a spread of 10 (asymmetry): shadow from the next "
         "cell of an oblique line, as along an axis, 0.071 and 0.085 (a spread of 13 or 15 degrees: 0.070 and 0.074 at "
         "300, with shorter horns; 8 neighbours: 0.130); from the second row where the line bends and from the next "
         "one elsewhere 0.096 and 0.058; from the second row, the next one counting as two rows away, 0.076 and 0.112; "
         "from the third row for two thirds of a step 0.053 at 300; from the second row, the next one counting as "
         "four: the rows above (with 8 neighbours 0.115 at 300: they help Werner's dunes only). The same along the "
         "axes would leave Bishop's published barchans 16% too low, so there the rule is that of print.\n";
}

// --- crests under two winds ---

SpectrumNumbers crests_of(const std::string& model, double spread, double middle, int steps, int seed) {
  Config config(model);
  for (const std::string& setting : {std::string("scene.sand=10"), std::string("run.executor=cpu"),
                                     std::string("run.threads=1"), "run.seed=" + std::to_string(seed)}) {
    set_from_text(config, setting);
  }
  forcing::WindInterval season = config.wind.intervals.front();
  season.steps = 10;
  season.spread = spread;
  season.bearing = fold_bearing(middle + 30);
  config.wind.intervals = {season, season};
  config.wind.intervals[1].bearing = fold_bearing(middle - 30);
  Simulation simulation(config);
  while (simulation.step_count() < steps) simulation.step();
  return analysis::measure_spectrum(analysis::coarse_surface(simulation.terrain(), analysis::Layer::surface));
}

std::string two_winds(const ValidationOptions& options) {
  const int seeds = options.quick ? 1 : 3;
  const int steps = options.quick ? 500 : 1000;
  const std::array<double, 4> middles{270, 285, 300, 315};
  TextTable table;
  table.heading = {"model", "spread"};
  for (const double middle : middles) table.heading.push_back(fixed_text(middle, 0));
  for (const char* model : {"werner", "momiji"}) {
    for (const double spread : {natural_spread, 0.0}) {
      const int jobs = static_cast<int>(middles.size()) * seeds;
      say_measuring(std::string("two winds, ") + model + ", spread " + fixed_text(spread, 0), jobs);
      const std::vector<SpectrumNumbers> runs = side_by_side<SpectrumNumbers>(jobs, [&](int job) {
        return crests_of(model, spread, middles[static_cast<std::size_t>(job / seeds)], steps, 1 + job % seeds);
      });
      std::vector<std::string> row{model, fixed_text(spread, 0)};
      for (int job = 0; job < jobs; ++job) {
        const SpectrumNumbers& crests = runs[static_cast<std::size_t>(job)];
        const double across = middles[static_cast<std::size_t>(job / seeds)] + 90;
        const std::string off =
            crests.crest_bearing ? fixed_text(std::remainder(*crests.crest_bearing - across, 180.0), 0) : "none";
        const std::string text = off + " (" + fixed_text(crests.alignment, 2) + ")";
        if (job % seeds == 0) row.push_back(text);
        if (job % seeds != 0) row.back() += ", " + text;
      }
      table.rows.push_back(row);
    }
  }
  return "Two equal winds 60 degrees apart that take turns of 10 steps, 10 slabs of sand, " + std::to_string(steps) +
         " steps on `cpu`, by the bearing of their middle, each seed by itself: degrees by which crests are off lying "
         "across it, in brackets how far they run one way (`alignment`). Far from 0, or hardly aligned: the sand is "
         "raked into ribs along the wind. none: aligned too little to have a bearing.\n\n" +
         table.markdown();
}

// --- fields ---

std::string barchan_fields(const ValidationOptions& options) {
  const int seeds = options.quick ? 1 : 3;
  const std::string side = "256";
  const std::string steps = options.quick ? "400" : "1000";
  const auto speed = [](const SeedRun& run) { return std::hypot(run.end.migration.x, run.end.migration.y); };
  struct Field {
    const char* preset;
    const char* model;
    const char* polling;
  };
  TextTable table;
  table.heading = {"model", "polling", "spread", "bearing", "sd", "of 270", "speed", "of 270", "direction off"};
  for (const Field& field : {Field{"momiji_barchans", "Momiji", "repeated"},
                             {"momiji_barchans", "Momiji", "nonrepeated"},
                             {"werner_barchans", "Werner", "repeated"}}) {
    for (const double spread : {natural_spread, 0.0}) {
      Sample straight_sd;
      Sample straight_speed;
      for (const double bearing : {270.0, 250.0, 225.0}) {
        Config config = thesis_config(field.preset);
        for (const std::string& assignment : {"grid.nx=" + side, "grid.ny=" + side, "run.steps=" + steps,
                                              std::string("parameters.polling=") + field.polling}) {
          set_from_text(config, assignment);
        }
        config.wind.intervals.front().bearing = bearing;
        config.wind.intervals.front().spread = spread;
        config.title = std::string(field.model) + " barchans, wind from " + fixed_text(bearing, 0) + ", spread " +
                       fixed_text(spread, 0) + ", " + field.polling;
        const std::vector<SeedRun> runs = run_seeds(config, "cpu", seeds);
        const Sample sd = sample_of(runs, [](const SeedRun& run) { return run.end.shape.sd_slabs; });
        const Sample velocity = sample_of(runs, speed);
        const Sample off = sample_of(runs, [bearing](const SeedRun& run) {
          return signed_angle(bearing_of({run.end.migration.x, run.end.migration.y}) - bearing);
        });
        if (straight_sd.empty()) {
          straight_sd = sd;
          straight_speed = velocity;
        }
        table.rows.push_back({field.model, field.polling, fixed_text(spread, 0), fixed_text(bearing, 0), sd.text(2),
                              fixed_text(sd.mean() / straight_sd.mean() * 100, 0) + "%", velocity.text(3),
                              fixed_text(velocity.mean() / straight_speed.mean() * 100, 0) + "%", off.text(1)});
      }
    }
  }
  return "Fields: barchans, 3 slabs a cell, " + side + " x " + side + " cells, " + steps +
         " steps on `cpu` with K 16, mean over " + count_text(seeds, "seed") +
         ". sd: standard deviation of height, slabs; speed of migration, cells a step; direction off: between the "
         "direction of migration and the wind, degrees. \"of 270\": against the west wind.\n\n" +
         table.markdown() +
         "\nWithout a spread dunes move faster where the wind is oblique, on the diagonal by a third, since shadow is "
         "looked for otherwise there ([conventions](conventions.md#wind)), and non-repeated polling keeps dunes small "
         "along the grid: there every hop is the same whole number of cells and every cell is polled exactly once, a "
         "regularity that an oblique or swinging wind breaks by rounding its hops at random (our explanation, not "
         "proven).\n";
}

}  // namespace

std::string bearings_section(const ValidationOptions& options) {
  return "## Oblique winds\n\nOn a square grid a wind from one bearing for ever leans dunes to one side "
         "([conventions](conventions.md#wind)). Models start with a wind that swings by " +
         fixed_text(natural_spread, 0) + " degrees; the rows of spread 0 say how far each leans without.\n\n" +
         one_barchan(options) + "\n" + two_winds(options) + "\n" + barchan_fields(options);
}

}  // namespace erg::app
