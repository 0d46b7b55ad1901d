#include "app/cli/dune_watch.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "analysis/crests.h"
#include "core/units.h"
#include "forcing/mean_wind.h"
#include "sim/step_time.h"

namespace erg::app {

using analysis::DuneRule;
using io::MeasuredDunes;
using sim::days_after;

namespace {

constexpr std::int64_t look_every = 5;  // steps: dunes move less than half their length in so many

}  // namespace

double DuneWatch::bearing() const {
  if (options_.bearing) return *options_.bearing;
  return forcing::resultant_bearing(simulation_.config().wind).value_or(simulation_.last_wind().mean_bearing());
}

analysis::DuneOutlines DuneWatch::outlines() {
  const Terrain& terrain = simulation_.terrain();
  DuneRule rule = DuneRule::usual(terrain);
  rule.least = options_.least.value_or(rule.least);
  rule.smallest = options_.smallest.value_or(rule.smallest);
  return analysis::find_dunes(terrain, bearing(), rule);
}

void DuneWatch::step() {
  simulation_.step();
  if (looked_ && simulation_.step_count() % look_every == 0) {
    tracker_.observe(simulation_.step_count(), outlines().dunes, simulation_.terrain());
  }
}

MeasuredDunes DuneWatch::as_it_is() {
  const Terrain& terrain = simulation_.terrain();
  MeasuredDunes moment;
  moment.step = simulation_.step_count();
  moment.days = days_after(simulation_.config(), moment.step);
  moment.days_a_step = days_after(simulation_.config(), 1);
  moment.cell_size = terrain.cell_size();
  moment.bearing = bearing();
  moment.outlines = outlines();
  const analysis::CoarseSurface surface = analysis::coarse_surface(terrain, analysis::Layer::surface);
  moment.crest_spacing = terrain.cell_size() * analysis::crest_spacing(surface, moment.bearing);
  moment.spectrum = analysis::measure_spectrum(surface);
  double sand = 0;
  for (const analysis::Dune& dune : moment.outlines.dunes) sand += dune.volume;
  const double all =
      static_cast<double>(terrain.total_mobile()) * terrain.quantum() * moment.cell_size * moment.cell_size;
  moment.sand_share = all > 0 ? sand / all : 0;
  return moment;
}

MeasuredDunes DuneWatch::measure() {
  MeasuredDunes moment = as_it_is();
  if (!looked_ || tracker_.step() != moment.step) {
    tracker_.observe(moment.step, moment.outlines.dunes, simulation_.terrain());
  }
  looked_ = true;
  tracker_.start_ways();
  std::unordered_map<std::int64_t, std::size_t> place;  // of each dune of this moment, by its number
  for (std::size_t i = 0; i < tracker_.dunes().size(); ++i) {
    place[tracker_.tracks()[i].number] = i;
    moment.dunes.push_back({tracker_.tracks()[i].number, tracker_.dunes()[i], {}, 0});
  }
  for (std::int64_t step = 0; step < options_.follow && !simulation_.finished(); ++step) this->step();
  if (tracker_.step() != simulation_.step_count()) {
    tracker_.observe(simulation_.step_count(), outlines().dunes, simulation_.terrain());
  }
  for (const analysis::DuneTracker::Track& track : tracker_.tracks()) {
    const auto dune = place.find(track.number);
    if (dune == place.end()) continue;
    moment.dunes[dune->second].way = track.way;
    moment.dunes[dune->second].steps = tracker_.step() - moment.step;
  }
  return moment;
}

}  // namespace erg::app
