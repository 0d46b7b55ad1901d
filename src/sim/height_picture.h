// Surfaces read from pictures, and how they are brought to a grid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/grid.h"

namespace erg::sim {

/// Heights of a picture's black and white points, m.
struct HeightRange {
  double low = 0;
  double high = 0;
};

/// A surface read from a picture, 0 (black) to 1 (white); row 0 south.
struct HeightPicture : Grid<float> {
  using Grid<float>::Grid;
  HeightPicture() = default;
  explicit HeightPicture(Grid<float> values) : Grid<float>(std::move(values)) {}

  std::optional<HeightRange> metres = {};  ///< what the file says of itself (Erg's own heightmaps do)
};

/// How a picture of another shape is brought to a grid.
enum class PictureFit {
  stretch,  ///< each side by itself
  crop      ///< its middle, cut to the grid's shape
};

/// What lies where a picture has no data.
enum class NoDataRule {
  refuse,  ///< nothing may
  lowest,  ///< its lowest height
  around   ///< heights carried on from the cells around
};

/// Brings a picture to a grid while its rows come in, each once, in any order: neither is held whole but the result.
/// Larger pictures are averaged, smaller ones interpolated.
class PictureResampler {
 public:
  PictureResampler(Extent picture, Extent grid, PictureFit fit = PictureFit::stretch);

  /// Row `y` (0 south) of the picture. `missing`: 1 where a pixel has no data; empty: all have.
  void add_row(int y, std::span<const float> values, std::span<const std::uint8_t> missing = {});
  /// Share of the grid's cells of which less than half was measured.
  double share_missing() const;
  /// The result, values within 0 to 1. Cells without data are filled by `rule`, which is not `refuse`; where no cell
  /// has any, all are 0.
  Grid<float> take(NoDataRule rule = NoDataRule::lowest);

 private:
  /// A part that a row of the picture has in a row of the grid.
  struct Share {
    int cell = 0;
    float weight = 0;
  };
  /// The pixels that a column of the grid takes in.
  struct Taps {
    int first = 0;
    std::vector<float> weights;
  };
  static std::vector<Taps> taps(int cells, int pixels, double begin, double length);
  void narrow(std::span<const float> values, std::span<const std::uint8_t> missing);

  std::vector<Taps> across_;
  std::vector<std::vector<Share>> shares_;  // of each row of the picture
  Grid<float> sum_;
  Grid<float> missing_;  // weight without data; empty while there is none
  std::vector<float> row_;
  std::vector<float> row_missing_;
};

/// The picture stretched to the extent of a grid.
Grid<float> resample(const HeightPicture& picture, Extent extent);
/// The same without a copy where it has that extent already; else `resampled` holds it. Throws InputError for a picture
/// that is empty or has values outside of 0 to 1.
const Grid<float>& on_grid(const HeightPicture& picture, Extent extent, Grid<float>& resampled);

}  // namespace erg::sim
