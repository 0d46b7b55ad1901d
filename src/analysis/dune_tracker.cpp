#include "analysis/dune_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace erg::analysis {
namespace {

constexpr double most_growth = 1.1;  // in volume, between two looks

double distance(const Dune& from, const Dune& to, const Terrain& terrain) {
  const DuneWay way = way_between(from, to, terrain);
  return std::hypot(way.east, way.north);
}

/// The nearest of `others` to each of `dunes`; their count where there are none.
std::vector<std::size_t> nearest_of(const std::vector<Dune>& dunes, const std::vector<Dune>& others,
                                    const Terrain& terrain) {
  std::vector<std::size_t> nearest(dunes.size(), others.size());
  for (std::size_t i = 0; i < dunes.size(); ++i) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < others.size(); ++k) {
      const double away = distance(dunes[i], others[k], terrain);
      if (away >= least) continue;
      least = away;
      nearest[i] = k;
    }
  }
  return nearest;
}

bool may_be_one(const Dune& earlier, const Dune& later, const Terrain& terrain) {
  if (distance(earlier, later, terrain) >= 0.5 * std::max(earlier.length, earlier.width)) return false;
  return earlier.volume <= most_growth * later.volume && later.volume <= most_growth * earlier.volume;
}

}  // namespace

DuneWay way_between(const Dune& from, const Dune& to, const Terrain& terrain) {
  if (terrain.boundary() != Boundary::torus) return {to.x - from.x, to.y - from.y};
  return {std::remainder(to.x - from.x, terrain.nx() * terrain.cell_size()),
          std::remainder(to.y - from.y, terrain.ny() * terrain.cell_size())};
}

std::vector<std::optional<std::size_t>> match_dunes(const std::vector<Dune>& earlier, const std::vector<Dune>& later,
                                                    const Terrain& terrain) {
  const std::vector<std::size_t> before = nearest_of(later, earlier, terrain);
  const std::vector<std::size_t> after = nearest_of(earlier, later, terrain);
  std::vector<std::optional<std::size_t>> matches(later.size());
  for (std::size_t i = 0; i < later.size(); ++i) {
    const std::size_t candidate = before[i];
    if (candidate == earlier.size() || after[candidate] != i) continue;
    if (may_be_one(earlier[candidate], later[i], terrain)) matches[i] = candidate;
  }
  return matches;
}

void DuneTracker::observe(std::int64_t step, std::vector<Dune> dunes, const Terrain& terrain) {
  const auto matches = match_dunes(dunes_, dunes, terrain);
  std::vector<Track> tracks(dunes.size());
  for (std::size_t i = 0; i < dunes.size(); ++i) {
    if (matches[i]) {
      tracks[i] = tracks_[*matches[i]];
      const DuneWay way = way_between(dunes_[*matches[i]], dunes[i], terrain);
      tracks[i].way.east += way.east;
      tracks[i].way.north += way.north;
    } else {
      tracks[i] = {++last_number_, step, {}};
    }
  }
  dunes_ = std::move(dunes);
  tracks_ = std::move(tracks);
  step_ = step;
}

void DuneTracker::start_ways() {
  for (Track& track : tracks_) {
    track.since = step_;
    track.way = {};
  }
}

}  // namespace erg::analysis
