#include "transport/box_mean.h"

#include <algorithm>
#include <type_traits>

namespace erg {
namespace {

/// Row or column number `at` of `count`, which may lie beyond the edges.
int folded(int at, int count, Boundary boundary) {
  return boundary == Boundary::torus ? wrap(at, count) : std::clamp(at, 0, count - 1);
}

/// Sums over boxes of a grid, row by row: of columns first, from row to row, then along the row.
template <typename Number, typename Sum>
class BoxSums {
 public:
  BoxSums(Extent extent, Boundary boundary, int radius, const Number* numbers)
      : extent_(extent),
        boundary_(boundary),
        radius_(radius),
        numbers_(numbers),
        columns_(static_cast<std::size_t>(extent.nx + 2 * radius + 1)),
        sums_(static_cast<std::size_t>(extent.nx)) {}

  /// Calls store(cell, sums) for each row from `begin` to before `end`; `cell` is its first.
  template <typename Store>
  void rows(int begin, int end, const Store& store) {
    for (int y = begin - radius_; y <= begin + radius_; ++y) add<1>(y);
    for (int y = begin; y < end; ++y) {
      add_up_row();
      store(cell(y), sums_.data());
      add<1>(y + radius_ + 1);
      add<-1>(y - radius_);
    }
  }

 private:
  std::size_t cell(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(extent_.nx); }

  template <int sign>
  void add(int y) {
    const Number* from = numbers_ + cell(folded(y, extent_.ny, boundary_));
    Sum* columns = columns_.data() + radius_;
    for (int x = 0; x < extent_.nx; ++x) columns[x] = static_cast<Sum>(columns[x] + static_cast<Sum>(sign) * from[x]);
  }

  void add_up_row() {
    Sum* columns = columns_.data() + radius_;
    for (int k = 1; k <= radius_; ++k) columns[-k] = columns[folded(-k, extent_.nx, boundary_)];
    for (int k = extent_.nx; k <= extent_.nx + radius_; ++k) columns[k] = columns[folded(k, extent_.nx, boundary_)];
    Sum sum = 0;
    for (int x = -radius_; x <= radius_; ++x) sum += columns[x];
    for (int x = 0; x < extent_.nx; ++x) {
      sums_[static_cast<std::size_t>(x)] = sum;
      sum += columns[x + radius_ + 1] - columns[x - radius_];
    }
  }

  const Extent extent_;
  const Boundary boundary_;
  const int radius_;
  const Number* numbers_;
  std::vector<Sum> columns_;  // with radius_ more before and radius_ + 1 behind
  std::vector<Sum> sums_;
};

template <typename Sum, typename Number, typename Store>
void sum_boxes(Extent extent, Boundary boundary, int radius, const std::vector<Number>& numbers, Executor& executor,
               const Store& store) {
  executor.for_pieces(extent.ny, [&](std::int64_t begin, std::int64_t end) {
    BoxSums<Number, Sum>(extent, boundary, radius, numbers.data())
        .rows(static_cast<int>(begin), static_cast<int>(end), store);
  });
}

/// Cells whose numbers a sum adds up, some of them several times if `twice`.
std::uint64_t cells_of(int radius, bool twice) {
  const auto side = static_cast<std::uint64_t>(2 * radius + 1);
  return twice ? side * side * side * side : side * side;
}

}  // namespace

float box_share(int radius, bool twice) { return static_cast<float>(1 / static_cast<double>(cells_of(radius, twice))); }

void BoxMean::measure(Extent extent, Boundary boundary, int radius, bool twice,
                      const std::vector<std::uint32_t>& numbers, std::uint32_t most, std::vector<float>& means,
                      Executor& executor) {
  const auto width = static_cast<std::size_t>(extent.nx);
  const float share = box_share(radius, twice);
  means.resize(extent.cells());
  const auto with = [&](auto& sums) {
    using Sum = typename std::remove_reference_t<decltype(sums)>::value_type;
    const auto store_means = [&](std::size_t first, const Sum* row) {
      // Sums stay below 2^63, so they may be converted as signed numbers, which is quicker.
      for (std::size_t x = 0; x < width; ++x) {
        means[first + x] = static_cast<float>(static_cast<std::make_signed_t<Sum>>(row[x])) * share;
      }
    };
    if (!twice) {
      sum_boxes<Sum>(extent, boundary, radius, numbers, executor, store_means);
      return;
    }
    sums.resize(extent.cells());
    sum_boxes<Sum>(extent, boundary, radius, numbers, executor,
                   [&](std::size_t first, const Sum* row) { std::copy(row, row + width, sums.data() + first); });
    sum_boxes<Sum>(extent, boundary, radius, sums, executor, store_means);
  };
  if (static_cast<double>(cells_of(radius, twice)) * most < 0x1p31) {
    with(sums_);
  } else {
    with(wide_sums_);
  }
}

}  // namespace erg
