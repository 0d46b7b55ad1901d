#include "analysis/fourier.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace erg::analysis {
namespace {

// Adds `amount` per unit of length, over [from, to) in units of one cell, to blocks `cells` long.
template <typename Add>
void spread(int cell, double cells, int blocks, const Add& add) {
  const double from = cell / cells;
  const double to = (cell + 1) / cells;
  const int first = std::min(static_cast<int>(from), blocks - 1);
  const int last = std::min(static_cast<int>(to), blocks - 1);
  for (int block = first; block <= last; ++block) {
    const double part = std::min(to, block + 1.0) - std::max(from, static_cast<double>(block));
    if (part > 0) add(block, part);
  }
}

double hann(int index, int count) {
  const double wave = std::sin(std::numbers::pi * (index + 0.5) / count);
  return wave * wave;
}

// One-dimensional transforms of all rows, then of all columns. A column is copied to a contiguous buffer and back.
void transform_lines(Spectrum2D& grid, bool forward) {
  Eigen::FFT<double> engine;
  const auto one_line = [&](std::vector<std::complex<double>>& in, std::vector<std::complex<double>>& out) {
    if (in.size() == 1) {
      out = in;
    } else if (forward) {
      engine.fwd(out, in);
    } else {
      engine.inv(out, in);
    }
  };
  std::vector<std::complex<double>> in(static_cast<std::size_t>(grid.nx()));
  std::vector<std::complex<double>> out;
  for (int y = 0; y < grid.ny(); ++y) {
    std::copy(grid.row(y).begin(), grid.row(y).end(), in.begin());
    one_line(in, out);
    std::copy(out.begin(), out.end(), grid.row(y).begin());
  }
  in.resize(static_cast<std::size_t>(grid.ny()));
  for (int x = 0; x < grid.nx(); ++x) {
    for (int y = 0; y < grid.ny(); ++y) in[static_cast<std::size_t>(y)] = grid(x, y);
    one_line(in, out);
    for (int y = 0; y < grid.ny(); ++y) grid(x, y) = out[static_cast<std::size_t>(y)];
  }
}

}  // namespace

CoarseSurface coarse_surface(const Terrain& terrain, Layer layer, Extent extent) {
  check_whole(terrain);
  CoarseSurface coarse{Grid<double>(extent), static_cast<double>(terrain.nx()) / extent.nx,
                       static_cast<double>(terrain.ny()) / extent.ny, terrain.boundary() == Boundary::torus};
  const auto height = [&](int x, int y) {
    return static_cast<double>(layer == Layer::surface ? terrain.height(x, y) : terrain.mobile()(x, y));
  };
  std::vector<double> line(static_cast<std::size_t>(extent.nx));
  for (int y = 0; y < terrain.ny(); ++y) {
    std::fill(line.begin(), line.end(), 0.0);
    for (int x = 0; x < terrain.nx(); ++x) {
      spread(x, coarse.cells_x, extent.nx,
             [&](int block, double part) { line[static_cast<std::size_t>(block)] += part * height(x, y); });
    }
    spread(y, coarse.cells_y, extent.ny, [&](int block, double part) {
      for (int x = 0; x < extent.nx; ++x) coarse.heights(x, block) += part * line[static_cast<std::size_t>(x)];
    });
  }
  return coarse;
}

CoarseSurface coarse_surface(const Terrain& terrain, Layer layer) {
  check_whole(terrain);
  constexpr int largest = 1024;
  return coarse_surface(terrain, layer, {std::min(terrain.nx(), largest), std::min(terrain.ny(), largest)});
}

Spectrum2D transform(const CoarseSurface& surface) {
  const Grid<double>& heights = surface.heights;
  const double sum = std::accumulate(heights.cells().begin(), heights.cells().end(), 0.0);
  const double mean = heights.empty() ? 0 : sum / static_cast<double>(heights.size());
  Spectrum2D spectrum(heights.extent());
  for (int y = 0; y < heights.ny(); ++y) {
    for (int x = 0; x < heights.nx(); ++x) {
      const double fade = surface.periodic ? 1.0 : hann(x, heights.nx()) * hann(y, heights.ny());
      spectrum(x, y) = (heights(x, y) - mean) * fade;
    }
  }
  transform_lines(spectrum, true);
  return spectrum;
}

Grid<double> transform_back(Spectrum2D spectrum) {
  transform_lines(spectrum, false);
  Grid<double> heights(spectrum.extent());
  for (std::size_t cell = 0; cell < heights.size(); ++cell) heights[cell] = spectrum[cell].real();
  return heights;
}

}  // namespace erg::analysis
