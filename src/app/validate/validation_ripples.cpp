// Ripples of the grain model beside nature: how long, how high, which way they lie and move, how grains fly.
#include <cmath>
#include <numbers>

#include "app/cli/text_table.h"
#include "app/validate/sample.h"
#include "app/validate/validation.h"
#include "forcing/bearing.h"

namespace erg::app {

using sim::Config;

namespace {

// Cells of a centimetre. Long enough along most winds for a dozen ripples and more, or their number could hardly
// change.
constexpr Extent ripple_ground{256, 48};

Config ripple_config(const std::string& strength_is, double strength, double bearing, int steps) {
  Config config("grains");
  for (const std::string& assignment :
       {"grid.nx=" + std::to_string(ripple_ground.nx), "grid.ny=" + std::to_string(ripple_ground.ny),
        "parameters.strength_is=" + strength_is, "run.steps=" + std::to_string(steps)}) {
    sim::set_from_text(config, assignment);
  }
  config.wind = forcing::WindSchedule::constant(bearing, strength);
  config.title = "ripples, " + strength_is + " " + fixed_text(strength, 1) + " from " + fixed_text(bearing, 0);
  return config;
}

double reading(const SeedRun& run, const std::string& key) {
  for (const models::Diagnostic& one : run.end.diagnostics) {
    if (one.key == key) return one.value;
  }
  return 0;
}

double length_cm(const SeedRun& run) { return run.end.crest_spacing; }  // cells of a centimetre

/// Crest to trough of a sine of the surface's standard deviation, cm.
double height_cm(const SeedRun& run) { return 2 * std::numbers::sqrt2 * run.end.shape.sd_surface * 100; }

/// Cells a step along the wind.
double downwind_speed(const SeedRun& run, double bearing) {
  const forcing::Direction toward = forcing::downwind(bearing);
  return run.end.migration.x * toward.x + run.end.migration.y * toward.y;
}

/// How far the crests are from lying across the wind, degrees, in those runs in which they run one way.
std::string crests_off_text(const std::vector<SeedRun>& runs, double bearing) {
  Sample off;
  for (const SeedRun& run : runs) {
    if (const auto crest = run.end.spectrum.crest_bearing) off.add(std::remainder(*crest - bearing - 90, 180.0));
  }
  return off.empty() ? "-" : off.text(0);
}

constexpr const char* ripples_conclusion = R"(
Ripples lie across the wind and move downwind at every bearing, and they are the longer and faster the stronger the wind
is. The index of natural sand ripples is 10 to 20. The impact angle stays while ripples grow; flights are 8, 23, 45, 62
and 83 cm for u* .2 to .6 over a young bed (step 3) and about half as long again or more here. **Ripples do not saturate**:
they go on growing by merging (at u* .4 they are 19 cm long at step 60 and 32 at step 200), where in nature they stop, so a
length belongs to a number of steps. A crest is counted where the surface climbs from a quarter of its standard deviation
below its mean to as much above it; with half of it lengths are 10 to 16% longer and rise alike.
)";

std::vector<std::string> ripple_row(const std::string& wind, double bearing, const Config& config, int seeds) {
  const std::vector<SeedRun> runs = run_seeds(config, "cpu", seeds);
  const auto text = [&](int digits, const auto& number) { return sample_of(runs, number).text(digits); };
  return {wind,
          fixed_text(bearing, 0),
          text(1, length_cm),
          text(2, height_cm),
          text(1, [](const SeedRun& run) { return length_cm(run) / height_cm(run); }),
          crests_off_text(runs, bearing),
          text(3, [&](const SeedRun& run) { return downwind_speed(run, bearing); }),
          text(1, [](const SeedRun& run) { return 100 * reading(run, "hop"); }),
          text(0, [](const SeedRun& run) { return 100 * reading(run, "flight"); }),
          text(1, [](const SeedRun& run) { return reading(run, "impact_angle"); }),
          text(0, [](const SeedRun& run) { return reading(run, "cut_off"); })};
}

}  // namespace

std::string ripples_section(const ValidationOptions& options) {
  const int seeds = options.quick ? 1 : 3;
  const int steps = options.quick ? 30 : 60;
  TextTable table;
  table.heading = {"wind",  "bearing", "length", "height",       "index",  "crests off",
                   "speed", "leap",    "flight", "impact angle", "cut off"};
  for (const double friction : {0.2, 0.3, 0.4, 0.5, 0.6}) {
    table.rows.push_back(ripple_row("u* " + fixed_text(friction, 1), 270,
                                    ripple_config("friction_velocity", friction, 270, steps), seeds));
  }
  for (const double bearing : {245.0, 225.0}) {
    table.rows.push_back(ripple_row("u* 0.4", bearing, ripple_config("friction_velocity", 0.4, bearing, steps), seeds));
  }
  for (const double speed : {10.0, 12.0, 15.0}) {
    table.rows.push_back(
        ripple_row(fixed_text(speed, 0) + " m/s at 10 m", 270, ripple_config("speed", speed, 270, steps), seeds));
  }
  return "## Sand ripples\n\nModel `grains` with its defaults from a flat bed of 5 cm, " +
         std::to_string(ripple_ground.nx) + " x " + std::to_string(ripple_ground.ny) + " cells of 1 cm, " +
         std::to_string(steps) + " steps on `cpu`, mean over " + count_text(seeds, "seed") +
         ", spread over the seeds in brackets. u*: friction velocity, m/s; length: cm from crest to crest along the "
         "wind, counted (`crest_spacing` of `erg run --stats`); height: cm, of a sine with the surface's standard "
         "deviation; index: length over height; crests off: degrees from lying across the wind; speed: cells a step, "
         "downwind positive; leap: mean way between two touches of the ground, cm; flight: mean way of a grain until "
         "it rests, cm; impact angle: mean, degrees; cut off: flights that never ended.\n\n" +
         table.markdown() + ripples_conclusion;
}

}  // namespace erg::app
