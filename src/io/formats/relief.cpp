#include "io/formats/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/fourier.h"
#include "core/units.h"

namespace erg::io {

using analysis::coarse_surface;
using analysis::CoarseSurface;
using analysis::Layer;

namespace {

// Slabs are rounded off over this many cells before they are drawn.
constexpr double slab_sigma = 0.9;

int neighbour(int index, int count, bool periodic) {
  if (index >= 0 && index < count) return index;
  return periodic ? wrap(index, count) : std::clamp(index, 0, count - 1);
}

// Weighted sums along one line: out[i] = sum of weights[i][k] * in[first[i] + k].
struct LineFilter {
  std::vector<int> first;
  std::vector<std::vector<float>> weights;
  std::size_t size() const { return first.size(); }
};

LineFilter gaussian_filter(int count, double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  std::vector<float> weights;
  double sum = 0;
  for (int step = -reach; step <= reach; ++step) sum += std::exp(-0.5 * step * step / (sigma * sigma));
  for (int step = -reach; step <= reach; ++step) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * step * step / (sigma * sigma)) / sum));
  }
  LineFilter filter;
  for (int index = 0; index < count; ++index) {
    filter.first.push_back(index - reach);
    filter.weights.push_back(weights);
  }
  return filter;
}

LineFilter spline_filter(int count, int zoom) {
  LineFilter filter;
  for (int pixel = 0; pixel < count * zoom; ++pixel) {
    const double place = (pixel + 0.5) / zoom - 0.5;
    const double below = std::floor(place);
    const double t = place - below;
    const double s = 1 - t;
    filter.first.push_back(static_cast<int>(below) - 1);
    filter.weights.push_back(
        {static_cast<float>(s * s * s / 6), static_cast<float>((3 * t * t * t - 6 * t * t + 4) / 6),
         static_cast<float>((3 * s * s * s - 6 * s * s + 4) / 6), static_cast<float>(t * t * t / 6)});
  }
  return filter;
}

Grid<float> apply(const Grid<float>& in, const LineFilter& across, const LineFilter& up, bool periodic) {
  Grid<float> half({static_cast<int>(across.size()), in.ny()});
  for (int y = 0; y < in.ny(); ++y) {
    for (int x = 0; x < half.nx(); ++x) {
      const auto at = static_cast<std::size_t>(x);
      float sum = 0;
      for (std::size_t k = 0; k < across.weights[at].size(); ++k) {
        sum += across.weights[at][k] * in(neighbour(across.first[at] + static_cast<int>(k), in.nx(), periodic), y);
      }
      half(x, y) = sum;
    }
  }
  Grid<float> out({half.nx(), static_cast<int>(up.size())});
  for (int y = 0; y < out.ny(); ++y) {
    const auto at = static_cast<std::size_t>(y);
    for (std::size_t k = 0; k < up.weights[at].size(); ++k) {
      const auto from = half.row(neighbour(up.first[at] + static_cast<int>(k), half.ny(), periodic));
      const auto to = out.row(y);
      for (std::size_t x = 0; x < to.size(); ++x) to[x] += up.weights[at][k] * from[x];
    }
  }
  return out;
}

Grid<float> as_floats(const Grid<double>& values, double scale) {
  Grid<float> result(values.extent());
  std::transform(values.cells().begin(), values.cells().end(), result.cells().begin(),
                 [scale](double value) { return static_cast<float>(value * scale); });
  return result;
}

// Bilinear height at a place in pixels.
float height_at(const Relief& relief, double x, double y) {
  const int left = static_cast<int>(std::floor(x));
  const int below = static_cast<int>(std::floor(y));
  const auto right_share = static_cast<float>(x - left);
  const auto above_share = static_cast<float>(y - below);
  const auto [nx, ny] = relief.extent();
  const int x0 = neighbour(left, nx, relief.periodic);
  const int x1 = neighbour(left + 1, nx, relief.periodic);
  const int y0 = neighbour(below, ny, relief.periodic);
  const int y1 = neighbour(below + 1, ny, relief.periodic);
  const Grid<float>& h = relief.surface;
  const float low = h(x0, y0) + (h(x1, y0) - h(x0, y0)) * right_share;
  const float high = h(x0, y1) + (h(x1, y1) - h(x0, y1)) * right_share;
  return low + (high - low) * above_share;
}

// The tangent of the highest elevation angle seen from a pixel looking along (dx, dy); below `least` it does not matter
// and the search ends where even the `highest` ground would not reach it.
double horizon(const Relief& relief, int x, int y, double dx, double dy, double highest, double least) {
  constexpr double farthest = 512;  // pixels
  const double here = relief.surface(x, y);
  const double enough = std::min(farthest, (highest - here) / (least * relief.pixel_size));
  double steepest = 0;
  for (double distance = 1; distance <= enough; distance += 1 + distance / 64) {
    const double rise = height_at(relief, x + dx * distance, y + dy * distance) - here;
    steepest = std::max(steepest, rise / (distance * relief.pixel_size));
  }
  return steepest;
}

double smooth_step(double from, double to, double value) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The share of the sky that is seen, from the horizon in eight directions at doubling distances up to `reach` pixels.
double open_sky(const Relief& relief, int x, int y, int reach) {
  constexpr std::array<std::array<int, 2>, 8> directions = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  const auto [nx, ny] = relief.extent();
  const float here = relief.surface(x, y);
  double seen = 0;
  for (const auto& [dx, dy] : directions) {
    const double step = relief.pixel_size * std::sqrt(dx * dx + dy * dy);
    double steepest = 0;
    for (int distance = 1; distance <= reach; distance *= 2) {
      const float there = relief.surface(neighbour(x + dx * distance, nx, relief.periodic),
                                         neighbour(y + dy * distance, ny, relief.periodic));
      steepest = std::max(steepest, (there - here) / (distance * step));
    }
    seen += 1 / (1 + steepest * steepest);  // cosine squared of the horizon: an even sky over level ground
  }
  return seen / static_cast<double>(directions.size());
}

}  // namespace

MapScale map_scale(Extent grid, int pixels) {
  const int longest = std::max(grid.nx, grid.ny);
  if (longest <= pixels + pixels / 2) {
    return {grid, std::max(1, static_cast<int>(std::lround(static_cast<double>(pixels) / longest)))};
  }
  const double shrink = static_cast<double>(pixels) / longest;
  const auto side = [shrink](int cells) { return std::max(1, static_cast<int>(std::lround(cells * shrink))); };
  return {{side(grid.nx), side(grid.ny)}, 1};
}

Grid<float> nearest_blocks(const Grid<float>& values, Extent blocks) {
  if (values.extent() == blocks) return values;
  Grid<float> result(blocks);
  for (int y = 0; y < blocks.ny; ++y) {
    for (int x = 0; x < blocks.nx; ++x) {
      result(x, y) = values(static_cast<int>((x + 0.5) * values.nx() / blocks.nx),
                            static_cast<int>((y + 0.5) * values.ny() / blocks.ny));
    }
  }
  return result;
}

Grid<float> smooth_enlarge(const Grid<float>& values, double sigma, int zoom, bool periodic) {
  const Grid<float> smooth =
      apply(values, gaussian_filter(values.nx(), sigma), gaussian_filter(values.ny(), sigma), periodic);
  return apply(smooth, spline_filter(values.nx(), zoom), spline_filter(values.ny(), zoom), periodic);
}

Relief make_relief(const Terrain& terrain, const MapScale& scale) {
  check_whole(terrain);
  Relief relief;
  relief.periodic = terrain.boundary() == Boundary::torus;
  relief.pixel_size = terrain.cell_size() * terrain.nx() / scale.blocks.nx / scale.zoom;
  const double sigma = slab_sigma * scale.blocks.nx / terrain.nx();
  const CoarseSurface surface = coarse_surface(terrain, Layer::surface, scale.blocks);
  const CoarseSurface sand = coarse_surface(terrain, Layer::mobile, scale.blocks);
  Grid<double> bedrock = surface.heights;
  for (std::size_t cell = 0; cell < bedrock.size(); ++cell) bedrock[cell] -= sand.heights[cell];
  const double lowest = *std::min_element(bedrock.cells().begin(), bedrock.cells().end());
  for (double& height : bedrock.cells()) height -= lowest;
  const auto to_pixels = [&](const Grid<double>& values, double unit) {
    return smooth_enlarge(as_floats(values, unit), sigma, scale.zoom, relief.periodic);
  };
  relief.surface = to_pixels(surface.heights, terrain.quantum());
  relief.sand = to_pixels(sand.heights, 1.0);
  relief.bedrock = to_pixels(bedrock, terrain.quantum());
  return relief;
}

Light light_up(const Relief& relief, const Sun& sun) {
  const int nx = relief.extent().nx;
  const int ny = relief.extent().ny;
  const double tangent = std::tan(radians(sun.altitude));
  const double east = std::sin(radians(sun.bearing));
  const double north = std::cos(radians(sun.bearing));
  const double highest = *std::max_element(relief.surface.cells().begin(), relief.surface.cells().end());
  const double penumbra = 0.12 * (tangent + 0.2);
  constexpr int near_by = 32;  // pixels
  Light light{Grid<float>(relief.extent()), Grid<float>(relief.extent())};
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      const auto at = [&](int dx, int dy) {
        return relief.surface(neighbour(x + dx, nx, relief.periodic), neighbour(y + dy, ny, relief.periodic));
      };
      const double slope_x = (at(1, 0) - at(-1, 0)) / (2 * relief.pixel_size);
      const double slope_y = (at(0, 1) - at(0, -1)) / (2 * relief.pixel_size);
      const double steepness = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
      const double facing = (1 - (slope_x * east + slope_y * north) / tangent) / steepness;
      const double skyline = horizon(relief, x, y, east, north, highest, tangent - penumbra);
      const double hidden = smooth_step(tangent - penumbra, tangent + penumbra, skyline);
      light.sun(x, y) = static_cast<float>(std::max(0.0, facing) * (1 - hidden));
      light.sky(x, y) = static_cast<float>(open_sky(relief, x, y, near_by) * 0.5 * (1 + 1 / steepness));
    }
  }
  return light;
}

}  // namespace erg::io
