// Which way crests run under two winds that take turns.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/spectrum.h"
#include "app/validate/validation_nature.h"
#include "core/units.h"

namespace erg::app {

using forcing::WindInterval;

namespace {

constexpr double orientation_bound = 10;      // degrees
constexpr double flux_up = 1.6;               // Gao et al. 2015
constexpr double least_mean_alignment = 0.3;  // less: crests run no one way, and their bearing means nothing

/// Two winds from `divergence` degrees apart; the first blows `ratio` times as long.
struct TwoWinds {
  double ratio;
  double divergence;
};

/// The trends (degrees from the middle between the winds, positive toward the first) at which crests gain most by both
/// winds: the maxima of the sum of q |sin a| (1 + gamma |sin a|), a between crest and wind. `gamma` 0: the gross
/// transport across the crest (Rubin & Hunter 1987); else the growth rate of a bedform whose crest the wind crosses
/// with 1 + gamma |sin a| times the flux of level ground (Courrech du Pont et al. 2014). More than one where equal.
std::vector<double> favoured_trends(TwoWinds winds, double gamma) {
  constexpr int first_tenth = -899;  // of a degree: -90 is 90
  std::vector<double> gains;
  for (int tenth = first_tenth; tenth < first_tenth + 1800; ++tenth) {
    const auto gain = [&](double wind) {
      const double across = std::abs(std::sin(radians(tenth / 10.0 - wind)));
      return across * (1 + gamma * across);
    };
    gains.push_back(winds.ratio * gain(winds.divergence / 2) + gain(-winds.divergence / 2));
  }
  const double most = *std::ranges::max_element(gains);
  std::vector<double> trends;
  for (std::size_t at = 0; at < gains.size(); ++at) {
    if (gains[at] < most * (1 - 1e-9)) continue;
    trends.push_back((static_cast<double>(at) + first_tenth) / 10);
  }
  return trends;
}

/// From the nearest of the trends, degrees; an axis has no sign.
double off(const std::vector<double>& trends, double trend) {
  double nearest = 90;
  for (const double one : trends) {
    const double away = std::remainder(trend - one, 180.0);
    if (std::abs(away) < std::abs(nearest)) nearest = away;
  }
  return nearest;
}

std::string trends_text(const std::vector<double>& trends) {
  std::string text;
  for (const double trend : trends) text += (text.empty() ? "" : " or ") + fixed_text(trend, 0);
  return text;
}

struct CrestRun {
  double trend = 0;  ///< degrees from the middle between the winds
  double alignment = 0;
};

struct CrestScene {
  const char* model;
  int side;
  int steps;
};

CrestRun crest_run(const CrestScene& scene, TwoWinds winds, int season, double middle, int seed) {
  const std::string side = std::to_string(scene.side);
  sim::Config config = nature_config(
      scene.model, {"grid.nx=" + side, "grid.ny=" + side, "scene.sand=10", "run.seed=" + std::to_string(seed)});
  WindInterval first = config.wind.intervals.at(0);
  WindInterval second = first;
  first.bearing = fold_bearing(middle + winds.divergence / 2);
  first.steps = std::llround(season * winds.ratio);
  second.bearing = fold_bearing(middle - winds.divergence / 2);
  second.steps = season;
  config.wind.intervals = {first, second};
  sim::Simulation simulation(config);
  const std::int64_t cycle = first.steps + second.steps;
  while (simulation.step_count() < scene.steps || simulation.step_count() % cycle != 0) simulation.step();
  const analysis::SpectrumNumbers crests =
      analysis::measure_spectrum(analysis::coarse_surface(simulation.terrain(), analysis::Layer::surface));
  return {std::remainder(crests.axis - middle, 180.0), crests.alignment};
}

/// The mean axis, degrees from -90 to 90.
double mean_trend(const std::vector<CrestRun>& runs) {
  double cosine = 0;
  double sine = 0;
  for (const CrestRun& run : runs) {
    cosine += std::cos(radians(2 * run.trend));
    sine += std::sin(radians(2 * run.trend));
  }
  return degrees(0.5 * std::atan2(sine, cosine));
}

/// Root mean square over the runs of what a law leaves.
double misfit(const std::vector<CrestRun>& runs, const std::vector<double>& trends) {
  double squares = 0;
  for (const CrestRun& run : runs) squares += std::pow(off(trends, run.trend), 2);
  return std::sqrt(squares / static_cast<double>(runs.size()));
}

struct CrestPlan {
  std::vector<TwoWinds> winds;
  std::vector<double> middles;
  int seeds;
};

CrestPlan crest_plan(bool quick) {
  CrestPlan plan{{}, {270, 285, 300, 315}, 2};
  std::vector<double> ratios{1, 1.5, 2};
  std::vector<double> divergences{45, 60, 75, 90, 105, 120, 135, 150};
  if (quick) {
    plan = {{}, {270, 300}, 1};
    ratios = {1, 2};
    divergences = {60, 90, 120};
  }
  for (const double ratio : ratios) {
    for (const double divergence : divergences) plan.winds.push_back({ratio, divergence});
  }
  return plan;
}

std::string crest_table(const CrestScene& scene, const CrestPlan& plan, const std::vector<int>& seasons) {
  TextTable table;
  table.heading = {"ratio", "divergence", "g 0", "g " + fixed_text(flux_up, 1)};
  for (const int season : seasons) {
    const std::string name = "seasons of " + std::to_string(season) + ": ";
    table.heading.insert(table.heading.end(),
                         {name + "crests", "aligned", "off g 0", "off g " + fixed_text(flux_up, 1)});
  }
  const int bearings = static_cast<int>(plan.middles.size());
  const int each = bearings * plan.seeds;
  const auto lengths = static_cast<int>(seasons.size());
  const int jobs = static_cast<int>(plan.winds.size()) * lengths * each;
  say_measuring(std::string("crests, ") + scene.model, jobs);
  const std::vector<CrestRun> all = side_by_side<CrestRun>(jobs, [&](int job) {
    const auto at = [&](int index) { return static_cast<std::size_t>(index); };
    return crest_run(scene, plan.winds[at(job / each / lengths)], seasons[at(job / each % lengths)],
                     plan.middles[at(job % bearings)], 1 + job % each / bearings);
  });
  auto next = all.begin();
  for (const TwoWinds& winds : plan.winds) {
    const std::vector<double> gross = favoured_trends(winds, 0);
    const std::vector<double> growing = favoured_trends(winds, flux_up);
    std::vector<std::string> row{fixed_text(winds.ratio, 1), fixed_text(winds.divergence, 0), trends_text(gross),
                                 trends_text(growing)};
    for (int season = 0; season < lengths; ++season, next += each) {
      const std::vector<CrestRun> runs(next, next + each);
      Sample alignment;
      for (const CrestRun& run : runs) alignment.add(run.alignment);
      const bool aligned = alignment.mean() >= least_mean_alignment;
      const auto judged = [&](const std::vector<double>& trends) -> std::string {
        if (!aligned) return trends.size() > 1 ? "mixed" : "**no one way**";
        return fixed_text(misfit(runs, trends), 0) + " " + verdict(misfit(runs, trends), orientation_bound);
      };
      row.insert(row.end(), {aligned ? fixed_text(mean_trend(runs), 0) : "-", fixed_text(alignment.mean(), 2),
                             judged(gross), judged(growing)});
    }
    table.rows.push_back(row);
  }
  return table.markdown();
}

}  // namespace

std::string crests_under_two_winds(const ValidationOptions& options) {
  const CrestPlan plan = crest_plan(options.quick);
  const std::vector<int> seasons{10, 50};
  const CrestScene werner{"werner", 192, 500};
  const CrestScene momiji{"momiji", 192, 500};
  std::string text =
      "### Crests under two winds\n\nCrests should lie where the winds together carry most sand across them, |q1 sin "
      "a1| + |q2 sin a2| (Rubin & Hunter 1987: g 0), or where a bedform grows fastest if a crest speeds the wind up, "
      "the "
      "sum of q |sin a| (1 + g |sin a|) with g 1.6 (Courrech du Pont et al. 2014; Gao et al. 2015). Both winds of the "
      "default strength, the first blows *ratio* times as long as the second, whose seasons last as many steps as the "
      "heading says; 10 slabs of sand a cell, " +
      std::to_string(werner.side) + " x " + std::to_string(werner.side) + " cells, " + std::to_string(werner.steps) +
      " steps and on to the end of a cycle. Directions in degrees from the middle between the winds, positive toward "
      "the first: 90 is across, 0 along. crests: mean over " +
      count_text(plan.seeds, "seed") + " at each of " + std::to_string(plan.middles.size()) +
      " bearings of the middle; aligned: 1 for crests that all run one way, 0 for none; off: root mean square over "
      "these runs, *holds* within " +
      fixed_text(orientation_bound, 0) + " degrees. Where crests are aligned by less than " +
      fixed_text(least_mean_alignment, 1) +
      " they have no direction: *mixed* where the law has two that are equal, else it fails.\n\n";
  text += "Werner:\n\n" + crest_table(werner, plan, seasons);
  if (!options.quick) text += "\nMomiji:\n\n" + crest_table(momiji, plan, seasons);
  text +=
      "\nOver 90 degrees of divergence the error hangs on the length of the seasons: in long ones each wind builds "
      "crests "
      "across itself before the other comes.\n";
  return text;
}

}  // namespace erg::app
