// A rectangular field of values, one per cell.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "core/cell_rule.h"

namespace erg {

/// The extent of a field in cells. x runs east, y runs north; row 0 is the southernmost.
struct Extent {
  int nx = 0;
  int ny = 0;

  /// How many cells it has.
  std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  bool operator==(const Extent&) const = default;
};

/// `value` folded into [0, period): the torus.
ERG_CELL_RULE int wrap(int value, int period) {
  const int rest = value % period;
  return rest < 0 ? rest + period : rest;
}

/// A field of nx x ny values in row-major order (x fastest), owned.
template <typename T>
class Grid {
 public:
  Grid() = default;
  explicit Grid(Extent extent, T value = T{}) : extent_(extent), cells_(extent.cells(), value) {}

  Extent extent() const { return extent_; }
  int nx() const { return extent_.nx; }
  int ny() const { return extent_.ny; }
  std::size_t size() const { return cells_.size(); }
  bool empty() const { return cells_.empty(); }

  /// Where a cell stands in cells(). It must be inside.
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < extent_.nx && y >= 0 && y < extent_.ny);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(extent_.nx) + static_cast<std::size_t>(x);
  }
  T& operator()(int x, int y) { return cells_[index(x, y)]; }
  const T& operator()(int x, int y) const { return cells_[index(x, y)]; }
  T& operator[](std::size_t cell) { return cells_[cell]; }
  const T& operator[](std::size_t cell) const { return cells_[cell]; }

  /// The value at a cell of the endless plane that the torus tiles.
  const T& wrapped(int x, int y) const { return (*this)(wrap(x, extent_.nx), wrap(y, extent_.ny)); }

  /// The nx values of a row, from west to east.
  std::span<T> row(int y) { return {cells_.data() + index(0, y), static_cast<std::size_t>(extent_.nx)}; }
  std::span<const T> row(int y) const { return {cells_.data() + index(0, y), static_cast<std::size_t>(extent_.nx)}; }
  /// All values, row by row from the south.
  std::span<T> cells() { return cells_; }
  std::span<const T> cells() const { return cells_; }

  /// Gives every cell this value.
  void fill(T value) { std::fill(cells_.begin(), cells_.end(), value); }
  bool operator==(const Grid&) const = default;

 private:
  Extent extent_;
  std::vector<T> cells_;
};

}  // namespace erg
