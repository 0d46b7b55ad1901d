#include "analysis/star_arms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/units.h"

namespace erg::analysis {
namespace {

constexpr int directions = 360;

/// Calls `use(dx, dy, height)` for every cell whose middle lies within `reach` of the middle of cell (x, y).
template <typename Use>
void each_within(const Grid<double>& heights, int x, int y, double reach, const Use& use) {
  const int most = static_cast<int>(reach);
  for (int dy = -most; dy <= most; ++dy) {
    for (int dx = -most; dx <= most; ++dx) {
      if (dx * dx + dy * dy <= reach * reach) use(dx, dy, heights.wrapped(x + dx, y + dy));
    }
  }
}

struct Relief {
  double low;
  double high;
};

Relief relief_within(const Grid<double>& heights, int x, int y, double reach) {
  Relief relief{heights.wrapped(x, y), heights.wrapped(x, y)};
  each_within(heights, x, y, reach, [&](int, int, double height) {
    relief.low = std::min(relief.low, height);
    relief.high = std::max(relief.high, height);
  });
  return relief;
}

/// Sand over `low` along each direction from (x, y), counted by the square of its distance.
std::array<double, directions> spokes(const Grid<double>& heights, double x, double y, double reach, double low) {
  std::array<double, directions> sums{};
  for (int i = 0; i < directions; ++i) {
    const double turn = 2 * std::numbers::pi * i / directions;
    for (double far = 0.5; far <= reach; far += 0.5) {
      const auto column = static_cast<int>(std::lround(x + far * std::sin(turn)));
      const auto row = static_cast<int>(std::lround(y + far * std::cos(turn)));
      sums[static_cast<std::size_t>(i)] += far * far * (heights.wrapped(column, row) - low);
    }
  }
  return sums;
}

std::complex<double> harmonic(const std::array<double, directions>& sums, int order) {
  std::complex<double> sum;
  for (int i = 0; i < directions; ++i) {
    sum += std::polar(sums[static_cast<std::size_t>(i)], -2 * std::numbers::pi * order * i / directions);
  }
  return sum;
}

Grid<double> mean_of_three(const Terrain& terrain) {
  Grid<double> mean(terrain.extent());
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) mean(x, y) += terrain.mobile().wrapped(x + dx, y + dy) / 9.0;
      }
    }
  }
  return mean;
}

double distance_on_torus(double x, double y, const Extent& extent) {
  return std::hypot(std::remainder(x, extent.nx), std::remainder(y, extent.ny));
}

}  // namespace

StarArms count_arms(const Grid<double>& heights, int x, int y, double reach) {
  const Relief relief = relief_within(heights, x, y, reach);
  StarArms star;
  star.height = relief.high - relief.low;
  star.harmonics.assign(most_arms + 1, 0);
  if (!(star.height > 0)) return star;
  double weight = 0;
  double middle_x = 0;
  double middle_y = 0;
  each_within(heights, x, y, reach, [&](int dx, int dy, double height) {
    const double above = std::max(0.0, height - relief.low - 0.5 * star.height);
    weight += above;
    middle_x += above * dx;
    middle_y += above * dy;
  });
  const double at_x = x + middle_x / weight;
  const double at_y = y + middle_y / weight;
  star.x = at_x - heights.nx() * std::floor(at_x / heights.nx());
  star.y = at_y - heights.ny() * std::floor(at_y / heights.ny());
  const std::array<double, directions> sums = spokes(heights, at_x, at_y, reach, relief.low);
  const double mean = std::abs(harmonic(sums, 0));
  if (!(mean > 0)) return star;
  for (int order = 1; order <= most_arms; ++order) {
    const std::complex<double> part = harmonic(sums, order);
    star.harmonics[static_cast<std::size_t>(order)] = 2 * std::abs(part) / mean;
    if (order < 2 || 2 * std::abs(part) / mean <= star.depth) continue;
    star.depth = 2 * std::abs(part) / mean;
    star.arms = order;
    const double period = 360.0 / order;
    const double bearing = -degrees(std::arg(part)) / order;
    star.bearing = bearing - period * std::floor(bearing / period);
  }
  if (star.depth < least_depth) star.arms = 0;
  return star;
}

std::vector<StarArms> find_stars(const Terrain& terrain, double apart) {
  check_whole(terrain);
  const Grid<double> heights = mean_of_three(terrain);
  std::vector<std::size_t> order(heights.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return heights[a] > heights[b]; });
  std::vector<StarArms> stars;
  if (order.empty()) return stars;
  const double low = heights[order.back()];
  const double least = low + 0.5 * (heights[order.front()] - low);
  std::vector<std::size_t> tops;
  for (const std::size_t cell : order) {
    if (heights[cell] < least || !(heights[cell] > low)) break;
    const int x = static_cast<int>(cell % static_cast<std::size_t>(heights.nx()));
    const int y = static_cast<int>(cell / static_cast<std::size_t>(heights.nx()));
    const bool stands_alone = std::none_of(tops.begin(), tops.end(), [&](std::size_t top) {
      const int top_x = static_cast<int>(top % static_cast<std::size_t>(heights.nx()));
      const int top_y = static_cast<int>(top / static_cast<std::size_t>(heights.nx()));
      return distance_on_torus(x - top_x, y - top_y, heights.extent()) < apart;
    });
    if (!stands_alone) continue;
    tops.push_back(cell);
    stars.push_back(count_arms(heights, x, y, 0.5 * apart));
  }
  return stars;
}

}  // namespace erg::analysis
