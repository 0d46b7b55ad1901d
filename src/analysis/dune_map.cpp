#include "analysis/dune_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/errors.h"
#include "core/units.h"

namespace erg::analysis {
namespace {

double of_dune(std::int32_t thickness) { return thickness >= thinnest_dune ? thickness : 0; }

/// The circular mean of weights that stand on a ring.
std::optional<double> ring_mean(std::span<const double> weights) {
  double east = 0;
  double north = 0;
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(weights.size());
    east += weights[k] * std::cos(angle);
    north += weights[k] * std::sin(angle);
    sum += weights[k];
  }
  if (std::hypot(east, north) <= 1e-9 * sum) return std::nullopt;
  const double turns = std::atan2(north, east) / (2 * std::numbers::pi);
  return (turns < 0 ? turns + 1 : turns) * static_cast<double>(weights.size());
}

/// The mean of the four cells around a place, round the torus.
double interpolated(const Grid<std::int32_t>& mobile, double x, double y) {
  const double left = std::floor(x);
  const double below = std::floor(y);
  const int x0 = wrap(static_cast<int>(left), mobile.nx());
  const int y0 = wrap(static_cast<int>(below), mobile.ny());
  const int x1 = wrap(x0 + 1, mobile.nx());
  const int y1 = wrap(y0 + 1, mobile.ny());
  const double low = std::lerp(of_dune(mobile(x0, y0)), of_dune(mobile(x1, y0)), x - left);
  const double high = std::lerp(of_dune(mobile(x0, y1)), of_dune(mobile(x1, y1)), x - left);
  return std::lerp(low, high, y - below);
}

}  // namespace

std::optional<GridPoint> dune_centre(const Terrain& terrain) {
  check_whole(terrain);
  const Grid<std::int32_t>& mobile = terrain.mobile();
  std::vector<double> columns(static_cast<std::size_t>(mobile.nx()));
  std::vector<double> rows(static_cast<std::size_t>(mobile.ny()));
  for (int y = 0; y < mobile.ny(); ++y) {
    for (int x = 0; x < mobile.nx(); ++x) {
      columns[static_cast<std::size_t>(x)] += of_dune(mobile(x, y));
      rows[static_cast<std::size_t>(y)] += of_dune(mobile(x, y));
    }
  }
  const auto x = ring_mean(columns);
  const auto y = ring_mean(rows);
  if (!x || !y) return std::nullopt;
  return GridPoint{*x, *y};
}

double DuneMap::volume() const {
  double sum = 0;
  for (const double one : height.cells()) sum += one;
  return sum;
}

DuneMap dune_map(const Terrain& terrain, double bearing, int reach) {
  const auto centre = dune_centre(terrain);
  if (!centre) throw InputError("", "there is no dune to be mapped", "take a terrain with one heap of sand");
  const double turn = radians(bearing);
  const GridPoint downwind{-std::sin(turn), -std::cos(turn)};
  DuneMap map{reach, Grid<double>(Extent{2 * reach + 1, 2 * reach + 1})};
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const double east = centre->x + x * downwind.x - y * downwind.y;
      const double north = centre->y + x * downwind.y + y * downwind.x;
      map.height(x + reach, y + reach) = terrain.quantum() * interpolated(terrain.mobile(), east, north);
    }
  }
  return map;
}

DuneMap mean_map(std::span<const DuneMap> maps) {
  DuneMap mean = maps.front();
  for (std::size_t cell = 0; cell < mean.height.size(); ++cell) {
    double sum = 0;
    for (const DuneMap& map : maps) sum += map.height[cell];
    mean.height[cell] = sum / static_cast<double>(maps.size());
  }
  return mean;
}

double mismatch(const DuneMap& one, const DuneMap& other) {
  double difference = 0;
  for (std::size_t cell = 0; cell < one.height.size(); ++cell) {
    difference += std::abs(one.height[cell] - other.height[cell]);
  }
  const double sand = one.volume() + other.volume();
  return sand > 0 ? difference / sand : 0;
}

double asymmetry(const DuneMap& map) {
  DuneMap mirrored = map;
  for (int y = -map.reach; y <= map.reach; ++y) {
    for (int x = -map.reach; x <= map.reach; ++x) {
      mirrored.height(x + map.reach, y + map.reach) = map.at(x, -y);
    }
  }
  return mismatch(map, mirrored);
}

HornVolumes find_horns(const DuneMap& map, double least) {
  const auto axis = [&](int x) {
    double sum = 0;
    for (int y = -2; y <= 2; ++y) sum += map.at(x, y);
    return sum / 5;
  };
  int foot = -map.reach;
  for (int x = -map.reach; x <= map.reach; ++x) {
    if (axis(x) > axis(foot)) foot = x;
  }
  while (foot <= map.reach && axis(foot) >= least) ++foot;
  HornVolumes horns;
  for (int x = foot; x <= map.reach; ++x) {
    for (int y = 1; y <= map.reach; ++y) {
      const auto add = [&](double height, double& volume, int& length) {
        if (height < least) return;
        volume += height;
        length = x - foot + 1;
      };
      add(map.at(x, y), horns.left, horns.left_length);
      add(map.at(x, -y), horns.right, horns.right_length);
    }
  }
  return horns;
}

}  // namespace erg::analysis
