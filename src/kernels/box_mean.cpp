#include "kernels/box_mean.h"

#include <algorithm>

namespace erg::kernels {

using compute::AlignedVector;

float box_share(int radius, bool twice) {
  const double cells = (2.0 * radius + 1) * (2.0 * radius + 1);
  return static_cast<float>(1 / (twice ? cells * cells : cells));
}

BoxMeans::BoxMeans(const BoxGrid& grid, int radius, bool twice, int first)
    : grid_(grid), radius_(radius), twice_(twice), share_(box_share(radius, twice)), next_(first) {
  const auto width = static_cast<std::size_t>(grid.extent.nx);
  extended_.resize(width + 2 * static_cast<std::size_t>(radius));
  sums_.resize(width);
  leading_ = columns_at(twice ? first - radius : first);
  if (!twice) return;
  trailing_ = leading_;
  second_.resize(width);
  const AlignedVector<double> none(width);
  for (int y = first - radius; y <= first + radius; ++y) {
    grid.kernels->add_sums(move(leading_, y), none.data(), second_.data(), grid.extent.nx);
  }
}

/// Row or column number `at` of `count`, which may lie beyond the edges.
int BoxMeans::folded(int at, int count) const {
  return grid_.boundary == Boundary::torus ? wrap(at, count) : std::clamp(at, 0, count - 1);
}

const std::uint16_t* BoxMeans::row(int y) const {
  return grid_.numbers +
         static_cast<std::size_t>(folded(y, grid_.extent.ny)) * static_cast<std::size_t>(grid_.extent.nx);
}

BoxMeans::Columns BoxMeans::columns_at(int y) const {
  const auto width = static_cast<std::size_t>(grid_.extent.nx);
  const std::vector<std::uint16_t> none(width);
  Columns columns{grid_.boundary == Boundary::torus ? y : std::clamp(y, 0, grid_.extent.ny - 1),
                  AlignedVector<double>(width)};
  for (int k = -radius_; k <= radius_; ++k) {
    grid_.kernels->add_row(row(columns.row + k), none.data(), columns.sums.data(), grid_.extent.nx);
  }
  return columns;
}

/// Moves on to a row; where it lies beyond an open edge, to the outermost one.
const double* BoxMeans::move(Columns& columns, int y) const {
  const int end = grid_.boundary == Boundary::torus ? y : std::min(y, grid_.extent.ny - 1);
  for (; columns.row < end; ++columns.row) {
    grid_.kernels->add_row(row(columns.row + radius_ + 1), row(columns.row - radius_), columns.sums.data(),
                           grid_.extent.nx);
  }
  return columns.sums.data();
}

/// Sums over the columns of the squares around each cell of a row.
void BoxMeans::sum_along(const double* columns, double* sums) {
  const int width = grid_.extent.nx;
  std::copy(columns, columns + width, extended_.begin() + radius_);
  for (int k = 1; k <= radius_; ++k) {
    extended_[static_cast<std::size_t>(radius_ - k)] = columns[folded(-k, width)];
    extended_[static_cast<std::size_t>(radius_ + width - 1 + k)] = columns[folded(width - 1 + k, width)];
  }
  grid_.kernels->add_up(extended_.data(), sums, width, 2 * radius_ + 1);
}

void BoxMeans::next(float* means) {
  if (started_) ++next_;
  const double* columns = twice_ ? second_.data() : move(leading_, next_);
  if (twice_ && started_) {
    const double* const entering = move(leading_, next_ + radius_);
    grid_.kernels->add_sums(entering, move(trailing_, next_ - radius_ - 1), second_.data(), grid_.extent.nx);
  }
  started_ = true;
  sum_along(columns, sums_.data());
  if (twice_) sum_along(sums_.data(), sums_.data());
  grid_.kernels->average(sums_.data(), share_, means, grid_.extent.nx);
}

}  // namespace erg::kernels
