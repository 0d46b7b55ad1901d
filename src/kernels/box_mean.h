// Means over squares of cells from exact whole sums: the same for any number of threads and however the grid is turned.
#pragma once

#include <cstdint>

#include "compute/aligned_vector.h"
#include "core/grid.h"
#include "core/terrain.h"

namespace erg::kernels {

/// Loops over neighbouring cells, compiled for an instruction set by whoever takes means. Sums are whole numbers below
/// 2^53.
struct BoxKernels {
  /// columns += entering - leaving
  void (*add_row)(const std::uint16_t* entering, const std::uint16_t* leaving, double* columns, int count);
  void (*add_sums)(const double* entering, const double* leaving, double* columns, int count);
  /// sums = those of `window` neighbours from each of `count` columns on. Destroys `columns`.
  void (*add_up)(double* columns, double* sums, int count, int window);
  void (*average)(const double* sums, float share, float* means, int count);
};

/// What a sum over a box is multiplied with to be the mean of its cells; `twice`: a sum of sums.
float box_share(int radius, bool twice);

/// Numbers of which means are taken. Over the edges the grid goes on (torus) or repeats its outermost cells (open).
struct BoxGrid {
  Extent extent;
  Boundary boundary = Boundary::torus;
  const std::uint16_t* numbers = nullptr;
  const BoxKernels* kernels = nullptr;
};

/// Means over the squares of 2 radius + 1 cells around each cell, row after row; with `twice` the means of these means.
/// Sums are whole numbers below 2^53 (radius 200, twice: 2^51), so doubles hold them exactly and it does not matter
/// that first all rows are summed up and then all columns.
class BoxMeans {
 public:
  /// From row `first` on, which on a torus may lie beyond its edge.
  BoxMeans(const BoxGrid& grid, int radius, bool twice, int first);
  /// Those of the next row's cells.
  void next(float* means);

 private:
  /// Sums over the rows of the squares around a row.
  struct Columns {
    int row = 0;
    compute::AlignedVector<double> sums;
  };

  int folded(int at, int count) const;
  const std::uint16_t* row(int y) const;
  Columns columns_at(int y) const;
  const double* move(Columns& columns, int y) const;
  void sum_along(const double* columns, double* sums);

  BoxGrid grid_;
  int radius_;
  bool twice_;
  float share_;
  int next_;
  bool started_ = false;  // the first row has been given
  Columns leading_;
  // Sums of such sums, and the row that leaves them.
  compute::AlignedVector<double> second_;
  Columns trailing_;
  compute::AlignedVector<double> extended_;  // over the edges
  compute::AlignedVector<double> sums_;
};

}  // namespace erg::kernels
