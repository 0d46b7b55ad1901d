#include "analysis/fourier.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace erg::analysis {
namespace {

/// Which blocks a cell lies in, and how much of a block its part in each is: the second is 0 where it lies in one.
struct Share {
  int block = 0;
  double first = 0;
  double second = 0;
};

/// For each of `cells` cells, where they make up `blocks` blocks, no smaller than a cell.
std::vector<Share> shares(int cells, int blocks) {
  const double cells_a_block = static_cast<double>(cells) / blocks;
  std::vector<Share> all(static_cast<std::size_t>(cells));
  for (int cell = 0; cell < cells; ++cell) {
    const double from = cell / cells_a_block;
    const double to = (cell + 1) / cells_a_block;
    Share& share = all[static_cast<std::size_t>(cell)];
    share.block = std::min(static_cast<int>(from), blocks - 1);
    const double border = share.block + 1.0;
    share.first = std::min(to, border) - from;
    if (share.block + 1 < blocks) share.second = std::max(0.0, to - border);
  }
  return all;
}

double hann(int index, int count) {
  const double wave = std::sin(std::numbers::pi * (index + 0.5) / count);
  return wave * wave;
}

using Complex = std::complex<double>;

Eigen::FFT<double> fft_of_real() {
  return Eigen::FFT<double>(Eigen::default_fft_impl<double>(), Eigen::FFT<double>::HalfSpectrum);
}

/// Some columns, copied out of the grid so that each lies in one piece, and back.
class ColumnTransforms {
 public:
  static constexpr int most = 8;  // side by side, as memory likes it

  explicit ColumnTransforms(Grid<Complex>& grid)
      : grid_(grid), length_(static_cast<std::size_t>(grid.ny())), columns_(most * length_), out_(length_) {}

  void transform(int first, bool forward) {
    const int count = std::min(most, grid_.nx() - first);
    for (int y = 0; y < grid_.ny(); ++y) {
      for (int k = 0; k < count; ++k) column(k)[y] = grid_(first + k, y);
    }
    for (int k = 0; k < count; ++k) {
      if (forward) {
        engine_.fwd(out_.data(), column(k), grid_.ny());
      } else {
        engine_.inv(out_.data(), column(k), grid_.ny());
      }
      std::copy(out_.begin(), out_.end(), column(k));
    }
    for (int y = 0; y < grid_.ny(); ++y) {
      for (int k = 0; k < count; ++k) grid_(first + k, y) = column(k)[y];
    }
  }

 private:
  Complex* column(int k) { return columns_.data() + static_cast<std::size_t>(k) * length_; }

  Grid<Complex>& grid_;
  std::size_t length_;
  std::vector<Complex> columns_;
  std::vector<Complex> out_;
  Eigen::FFT<double> engine_;
};

void transform_columns(Grid<Complex>& grid, bool forward, const ShareWork& share) {
  if (grid.ny() < 2) return;
  constexpr int most = ColumnTransforms::most;
  share((grid.nx() + most - 1) / most, [&](std::int64_t begin, std::int64_t end) {
    ColumnTransforms columns(grid);
    for (auto k = static_cast<int>(begin); k < end; ++k) columns.transform(k * most, forward);
  });
}

}  // namespace

CoarseSurface coarse_surface(const Terrain& terrain, Layer layer, Extent extent) {
  check_whole(terrain);
  CoarseSurface coarse{Grid<double>(extent), static_cast<double>(terrain.nx()) / extent.nx,
                       static_cast<double>(terrain.ny()) / extent.ny, terrain.boundary() == Boundary::torus};
  const auto height = [&](int x, int y) {
    return static_cast<double>(layer == Layer::surface ? terrain.height(x, y) : terrain.mobile()(x, y));
  };
  const std::vector<Share> across = shares(terrain.nx(), extent.nx);
  const std::vector<Share> up = shares(terrain.ny(), extent.ny);
  const auto width = static_cast<std::size_t>(extent.nx);
  std::vector<double> line(width + 1);  // with room for the share of the last cell beyond the last block, which is 0
  const auto add_line = [&](int block, double part) {
    const std::span<double> row = coarse.heights.row(block);
    for (std::size_t x = 0; x < width; ++x) row[x] += part * line[x];
  };
  for (int y = 0; y < terrain.ny(); ++y) {
    std::fill(line.begin(), line.end(), 0.0);
    for (int x = 0; x < terrain.nx(); ++x) {
      const Share& share = across[static_cast<std::size_t>(x)];
      const double value = height(x, y);
      line[static_cast<std::size_t>(share.block)] += share.first * value;
      line[static_cast<std::size_t>(share.block) + 1] += share.second * value;
    }
    const Share& share = up[static_cast<std::size_t>(y)];
    add_line(share.block, share.first);
    if (share.second > 0) add_line(share.block + 1, share.second);
  }
  return coarse;
}

CoarseSurface coarse_surface(const Terrain& terrain, Layer layer, int most) {
  check_whole(terrain);
  return coarse_surface(terrain, layer, {std::min(terrain.nx(), most), std::min(terrain.ny(), most)});
}

Spectrum2D transform(const CoarseSurface& surface, const ShareWork& share) {
  const Grid<double>& heights = surface.heights;
  const int nx = heights.nx();
  Spectrum2D spectrum{Grid<Complex>(heights.empty() ? Extent{} : Extent{nx / 2 + 1, heights.ny()}), nx};
  if (heights.empty()) return spectrum;
  const double mean =
      std::accumulate(heights.cells().begin(), heights.cells().end(), 0.0) / static_cast<double>(heights.size());
  std::vector<double> fade(static_cast<std::size_t>(nx), 1.0);
  if (!surface.periodic) {
    for (int x = 0; x < nx; ++x) fade[static_cast<std::size_t>(x)] = hann(x, nx);
  }
  share(heights.ny(), [&](std::int64_t begin, std::int64_t end) {
    Eigen::FFT<double> engine = fft_of_real();
    std::vector<double> line(static_cast<std::size_t>(nx));
    for (auto y = static_cast<int>(begin); y < end; ++y) {
      const double faded = surface.periodic ? 1.0 : hann(y, heights.ny());
      for (std::size_t x = 0; x < line.size(); ++x) line[x] = (heights.row(y)[x] - mean) * fade[x] * faded;
      if (nx == 1) {
        spectrum.values(0, y) = line.front();
      } else {
        engine.fwd(spectrum.values.row(y).data(), line.data(), nx);
      }
    }
  });
  transform_columns(spectrum.values, true, share);
  return spectrum;
}

Grid<double> transform_back(Spectrum2D spectrum, const ShareWork& share) {
  transform_columns(spectrum.values, false, share);
  Grid<double> heights(spectrum.values.empty() ? Extent{} : Extent{spectrum.nx, spectrum.values.ny()});
  share(heights.ny(), [&](std::int64_t begin, std::int64_t end) {
    Eigen::FFT<double> engine = fft_of_real();
    for (auto y = static_cast<int>(begin); y < end; ++y) {
      if (heights.nx() == 1) {
        heights(0, y) = spectrum.values(0, y).real();
      } else {
        engine.inv(heights.row(y).data(), spectrum.values.row(y).data(), heights.nx());
      }
    }
  });
  return heights;
}

}  // namespace erg::analysis
