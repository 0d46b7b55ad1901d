#include "models/snow/box_mean.h"

#include <algorithm>
#include <vector>

#include "compute/aligned_vector.h"
#include "models/snow/snow_sweep.h"

namespace erg {
namespace {

template <typename Sum>
const BoxKernels<Sum>& kernels_of(const SnowKernels& kernels) {
  if constexpr (sizeof(Sum) == sizeof(std::uint32_t)) {
    return kernels.boxes;
  } else {
    return kernels.wide_boxes;
  }
}

/// Row or column number `at` of `count`, which may lie beyond the edges.
int folded(int at, int count, Boundary boundary) {
  return boundary == Boundary::torus ? wrap(at, count) : std::clamp(at, 0, count - 1);
}

/// Sums over squares: columns are summed up over the rows of a square, these along the row.
template <typename Sum>
class BoxSums {
 public:
  BoxSums(const BoxGrid& grid, int radius)
      : kernels_(kernels_of<Sum>(*grid.kernels)),
        boundary_(grid.boundary),
        width_(grid.extent.nx),
        radius_(radius),
        columns_(static_cast<std::size_t>(width_)),
        extended_(static_cast<std::size_t>(width_ + 2 * radius)) {}

  /// A row enters the squares and another leaves them; null: none leaves.
  void move(const std::uint16_t* entering, const std::uint16_t* leaving) {
    kernels_.add_numbers(entering, leaving, columns_.data(), width_);
  }
  void move(const Sum* entering, const Sum* leaving) { kernels_.add_sums(entering, leaving, columns_.data(), width_); }

  void take(Sum* sums) {
    std::copy(columns_.begin(), columns_.end(), extended_.begin() + radius_);
    for (int k = 1; k <= radius_; ++k) {
      extended_[static_cast<std::size_t>(radius_ - k)] = column(-k);
      extended_[static_cast<std::size_t>(radius_ + width_ - 1 + k)] = column(width_ - 1 + k);
    }
    kernels_.add_up(extended_.data(), sums, width_, 2 * radius_ + 1);
  }

 private:
  Sum column(int x) const { return columns_[static_cast<std::size_t>(folded(x, width_, boundary_))]; }

  const BoxKernels<Sum>& kernels_;
  const Boundary boundary_;
  const int width_;
  const int radius_;
  AlignedVector<Sum> columns_;
  AlignedVector<Sum> extended_;  // over the edges
};

/// The sums of one row after another.
template <typename Sum>
class RowSums {
 public:
  RowSums(const BoxGrid& grid, int radius, int first)
      : grid_(grid), radius_(radius), next_(first), sums_(grid, radius) {
    for (int y = first - radius; y < first + radius; ++y) sums_.move(row(y), nullptr);
  }

  void next(Sum* sums) {
    sums_.move(row(next_ + radius_), started_ ? row(next_ - radius_ - 1) : nullptr);
    started_ = true;
    ++next_;
    sums_.take(sums);
  }

 private:
  const std::uint16_t* row(int y) const {
    return grid_.numbers + static_cast<std::size_t>(folded(y, grid_.extent.ny, grid_.boundary)) *
                               static_cast<std::size_t>(grid_.extent.nx);
  }

  const BoxGrid grid_;
  const int radius_;
  int next_;
  bool started_ = false;
  BoxSums<Sum> sums_;
};

template <typename Sum>
class OnceMeans : public BoxMeans {
 public:
  OnceMeans(const BoxGrid& grid, int radius, int first, float share)
      : kernels_(kernels_of<Sum>(*grid.kernels)),
        width_(grid.extent.nx),
        share_(share),
        rows_(grid, radius, first),
        sums_(static_cast<std::size_t>(width_)) {}

  void next(float* means) override {
    rows_.next(sums_.data());
    kernels_.average(sums_.data(), share_, means, width_);
  }

 private:
  const BoxKernels<Sum>& kernels_;
  const int width_;
  const float share_;
  RowSums<Sum> rows_;
  AlignedVector<Sum> sums_;
};

/// Keeps the rows of first sums that second ones still need.
template <typename Sum>
class TwiceMeans : public BoxMeans {
 public:
  TwiceMeans(const BoxGrid& grid, int radius, int first, float share)
      : kernels_(kernels_of<Sum>(*grid.kernels)),
        grid_(grid),
        radius_(radius),
        share_(share),
        next_(first),
        first_kept_(inner(first - radius)),
        end_kept_(first_kept_),
        rows_(grid, radius, first_kept_),
        sums_(grid, radius),
        kept_(static_cast<std::size_t>(2 * radius + 2), AlignedVector<Sum>(static_cast<std::size_t>(grid.extent.nx))),
        result_(static_cast<std::size_t>(grid.extent.nx)) {
    for (int y = first - radius; y < first + radius; ++y) sums_.move(row(y), static_cast<const Sum*>(nullptr));
  }

  void next(float* means) override {
    const Sum* const entering = row(next_ + radius_);
    sums_.move(entering, started_ ? row(next_ - radius_ - 1) : nullptr);
    started_ = true;
    ++next_;
    sums_.take(result_.data());
    kernels_.average(result_.data(), share_, means, grid_.extent.nx);
  }

 private:
  /// Rows over an open edge repeat the outermost one; a torus goes on.
  int inner(int y) const { return grid_.boundary == Boundary::torus ? y : std::clamp(y, 0, grid_.extent.ny - 1); }

  const Sum* row(int y) {
    const int wanted = inner(y);
    for (; end_kept_ <= wanted; ++end_kept_) rows_.next(place(end_kept_).data());
    return place(wanted).data();
  }
  AlignedVector<Sum>& place(int y) { return kept_[static_cast<std::size_t>(y - first_kept_) % kept_.size()]; }

  const BoxKernels<Sum>& kernels_;
  const BoxGrid grid_;
  const int radius_;
  const float share_;
  int next_;
  bool started_ = false;
  const int first_kept_;
  int end_kept_;
  RowSums<Sum> rows_;
  BoxSums<Sum> sums_;
  std::vector<AlignedVector<Sum>> kept_;
  AlignedVector<Sum> result_;
};

template <typename Sum>
std::unique_ptr<BoxMeans> means_with(const BoxGrid& grid, int radius, bool twice, int first, float share) {
  if (twice) return std::make_unique<TwiceMeans<Sum>>(grid, radius, first, share);
  return std::make_unique<OnceMeans<Sum>>(grid, radius, first, share);
}

/// Cells whose numbers a sum adds up, some of them several times if `twice`.
std::uint64_t cells_of(int radius, bool twice) {
  const auto side = static_cast<std::uint64_t>(2 * radius + 1);
  return twice ? side * side * side * side : side * side;
}

}  // namespace

float box_share(int radius, bool twice) { return static_cast<float>(1 / static_cast<double>(cells_of(radius, twice))); }

std::unique_ptr<BoxMeans> box_means(const BoxGrid& grid, int radius, bool twice, int first) {
  const float share = box_share(radius, twice);
  if (static_cast<double>(cells_of(radius, twice)) * grid.most < 0x1p31) {
    return means_with<std::uint32_t>(grid, radius, twice, first, share);
  }
  return means_with<std::uint64_t>(grid, radius, twice, first, share);
}

}  // namespace erg
