#include "sim/height_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors.h"

namespace erg::sim {
namespace {

/// A cell is without data where more of it was not measured.
constexpr float most_missing = 0.5f;

/// Part of a picture, in pixels.
struct Part {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

Part part_of(Extent picture, Extent grid, PictureFit fit) {
  Part all{0, 0, static_cast<double>(picture.nx), static_cast<double>(picture.ny)};
  if (fit == PictureFit::stretch) return all;
  const double pixels_a_cell = std::min(all.width / grid.nx, all.height / grid.ny);
  const double width = pixels_a_cell * grid.nx;
  const double height = pixels_a_cell * grid.ny;
  return {0.5 * (all.width - width), 0.5 * (all.height - height), width, height};
}

/// Calls `look` with each cell beside one.
template <typename Look>
void for_beside(const Grid<float>& grid, std::size_t cell, const Look& look) {
  const auto nx = static_cast<std::size_t>(grid.nx());
  if (cell % nx > 0) look(cell - 1);
  if (cell % nx + 1 < nx) look(cell + 1);
  if (cell >= nx) look(cell - nx);
  if (cell + nx < grid.size()) look(cell + nx);
}

enum Known : std::uint8_t { known, unknown, in_ring };

/// Gives unknown cells beside known ones the mean of these, ring by ring, until all are known. The order of cells
/// decides nothing.
void carry_on(Grid<float>& values, std::vector<Known> states) {
  std::vector<std::size_t> ring;
  const auto join = [&](std::size_t cell) {
    if (states[cell] != unknown) return;
    states[cell] = in_ring;
    ring.push_back(cell);
  };
  for (std::size_t cell = 0; cell < states.size(); ++cell) {
    bool at_edge = false;
    for_beside(values, cell, [&](std::size_t beside) { at_edge = at_edge || states[beside] == known; });
    if (at_edge) join(cell);
  }
  while (!ring.empty()) {
    for (const std::size_t cell : ring) {
      float sum = 0;
      int count = 0;
      for_beside(values, cell, [&](std::size_t beside) {
        if (states[beside] != known) return;
        sum += values[beside];
        ++count;
      });
      values[cell] = sum / static_cast<float>(count);
    }
    const std::vector<std::size_t> done = std::exchange(ring, {});
    for (const std::size_t cell : done) states[cell] = known;
    for (const std::size_t cell : done) for_beside(values, cell, join);
  }
}

}  // namespace

// Weights of the picture's pixels for one row of cells: a tent as wide as a cell or a pixel, whichever is wider.
std::vector<PictureResampler::Taps> PictureResampler::taps(int cells, int pixels, double begin, double length) {
  const double pixels_a_cell = length / cells;
  const double reach = std::max(1.0, pixels_a_cell);
  std::vector<Taps> all(static_cast<std::size_t>(cells));
  for (int cell = 0; cell < cells; ++cell) {
    const double centre = begin + (cell + 0.5) * pixels_a_cell - 0.5;
    Taps& taps = all[static_cast<std::size_t>(cell)];
    taps.first = std::max(0, static_cast<int>(std::ceil(centre - reach)));
    const int last = std::min(pixels - 1, static_cast<int>(std::floor(centre + reach)));
    double sum = 0;
    for (int pixel = taps.first; pixel <= last; ++pixel) sum += 1 - std::abs(pixel - centre) / reach;
    for (int pixel = taps.first; pixel <= last; ++pixel) {
      taps.weights.push_back(static_cast<float>((1 - std::abs(pixel - centre) / reach) / sum));
    }
  }
  return all;
}

PictureResampler::PictureResampler(Extent picture, Extent grid, PictureFit fit)
    : shares_(static_cast<std::size_t>(picture.ny)), sum_(grid), row_(static_cast<std::size_t>(grid.nx)) {
  const Part part = part_of(picture, grid, fit);
  across_ = taps(grid.nx, picture.nx, part.x, part.width);
  const std::vector<Taps> up = taps(grid.ny, picture.ny, part.y, part.height);
  for (int cell = 0; cell < grid.ny; ++cell) {
    const Taps& pixels = up[static_cast<std::size_t>(cell)];
    auto pixel = static_cast<std::size_t>(pixels.first);
    for (const float weight : pixels.weights) shares_[pixel++].push_back({cell, weight});
  }
}

// The row brought to the grid's columns. A pixel without data counts as 0 in it and as its weight in what is missing.
void PictureResampler::narrow(std::span<const float> values, std::span<const std::uint8_t> missing) {
  row_missing_.assign(missing.empty() ? 0 : row_.size(), 0.0f);
  for (std::size_t x = 0; x < row_.size(); ++x) {
    auto pixel = static_cast<std::size_t>(across_[x].first);
    float sum = 0;
    for (const float weight : across_[x].weights) {
      if (!missing.empty() && missing[pixel] != 0) {
        row_missing_[x] += weight;
      } else {
        sum += weight * values[pixel];
      }
      ++pixel;
    }
    row_[x] = sum;
  }
}

void PictureResampler::add_row(int y, std::span<const float> values, std::span<const std::uint8_t> missing) {
  const std::vector<Share>& shares = shares_[static_cast<std::size_t>(y)];
  if (shares.empty()) return;
  narrow(values, missing);
  if (!missing.empty() && missing_.empty()) missing_ = Grid<float>(sum_.extent());
  for (const Share& share : shares) {
    const std::span<float> sums = sum_.row(share.cell);
    for (std::size_t x = 0; x < row_.size(); ++x) sums[x] += share.weight * row_[x];
    if (missing.empty()) continue;
    const std::span<float> without = missing_.row(share.cell);
    for (std::size_t x = 0; x < row_.size(); ++x) without[x] += share.weight * row_missing_[x];
  }
}

double PictureResampler::share_missing() const {
  const auto count = std::ranges::count_if(missing_.cells(), [](float weight) { return weight > most_missing; });
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, sum_.size()));
}

Grid<float> PictureResampler::take(NoDataRule rule) {
  std::vector<Known> states(missing_.size(), known);
  float lowest = 2;
  for (std::size_t cell = 0; cell < sum_.size(); ++cell) {
    const float without = missing_.empty() ? 0.0f : missing_[cell];
    if (without > most_missing) {
      states[cell] = unknown;
    } else {
      sum_[cell] = std::clamp(sum_[cell] / (1 - without), 0.0f, 1.0f);
      lowest = std::min(lowest, sum_[cell]);
    }
  }
  missing_ = {};
  if (lowest > 1) {
    sum_.fill(0);
  } else if (rule == NoDataRule::around) {
    carry_on(sum_, std::move(states));
  } else {
    for (std::size_t cell = 0; cell < states.size(); ++cell) {
      if (states[cell] == unknown) sum_[cell] = lowest;
    }
  }
  return std::move(sum_);
}

Grid<float> resample(const HeightPicture& picture, Extent extent) {
  if (picture.extent() == extent) return picture;
  PictureResampler resampler(picture.extent(), extent);
  for (int y = 0; y < picture.ny(); ++y) resampler.add_row(y, picture.row(y));
  return resampler.take();
}

const Grid<float>& on_grid(const HeightPicture& picture, Extent extent, Grid<float>& resampled) {
  // Written so that NaN is refused.
  const auto fits = [](float value) { return value >= 0 && value <= 1; };
  if (picture.empty() || !std::ranges::all_of(picture.cells(), fits)) {
    throw InputError("picture", "it is empty, or has a value that is not from 0 to 1", "give a surface from 0 to 1");
  }
  if (picture.extent() == extent) return picture;
  resampled = resample(picture, extent);
  return resampled;
}

}  // namespace erg::sim
