#include "render/block_window.h"

#include <algorithm>
#include <cmath>

namespace erg::render {
namespace {

int inside(int index, int count, bool periodic) {
  return periodic ? wrap(index, count) : std::clamp(index, 0, count - 1);
}

/// The rows of a grid as the window cuts them out, side by side whatever edge it reaches over.
template <typename Value>
class WindowRows {
 public:
  WindowRows(const Grid<Value>& grid, const BlockWindow& window, bool periodic)
      : grid_(grid),
        left_(window.left),
        low_(window.low),
        count_(window.blocks.nx * window.block),
        periodic_(periodic),
        within_(left_ >= 0 && left_ + count_ <= grid.nx()),
        row_(within_ ? 0 : static_cast<std::size_t>(count_)) {}

  /// As many cells as the window has columns; good until the next call.
  const Value* row(int index) {
    const auto cells = grid_.row(inside(low_ + index, grid_.ny(), periodic_));
    if (within_) return cells.data() + left_;
    for (int column = 0; column < count_; ++column) {
      row_[static_cast<std::size_t>(column)] =
          cells[static_cast<std::size_t>(inside(left_ + column, grid_.nx(), periodic_))];
    }
    return row_.data();
  }

 private:
  const Grid<Value>& grid_;
  int left_, low_, count_;
  bool periodic_;
  bool within_;
  std::vector<Value> row_;
};

// The cells of each block of a row of blocks, added up.
template <typename Sum, typename Value>
void sum_blocks(WindowRows<Value>& rows, int row, int block, std::vector<Sum>& sums) {
  std::fill(sums.begin(), sums.end(), Sum{});
  for (int step = 0; step < block; ++step) {
    const Value* from = rows.row(row * block + step);
    for (Sum& sum : sums) {
      for (int column = 0; column < block; ++column) sum += static_cast<Sum>(*from++);
    }
  }
}

// Counts of one cell, in doubles that hold them exactly, so that many are done side by side; the same bits as by sums.
void read_cells(const std::int32_t* bedrock, const std::int32_t* mobile, int count, double unit, float* to) {
  for (int column = 0; column < count; ++column) {
    const auto thickness = static_cast<double>(mobile[column]);
    to[2 * column] = static_cast<float>(unit * (static_cast<double>(bedrock[column]) + thickness));
    to[2 * column + 1] = static_cast<float>(unit * thickness);
  }
}

}  // namespace

BlockWindow whole_window(Extent extent, int largest) {
  const int block = (std::max(extent.nx, extent.ny) + largest - 1) / largest;
  return {0, 0, {(extent.nx + block - 1) / block, (extent.ny + block - 1) / block}, block};
}

void read_terrain(const Terrain& terrain, const BlockWindow& window, std::vector<float>& values) {
  const bool periodic = terrain.boundary() == Boundary::torus;
  WindowRows<std::int32_t> bedrock(terrain.bedrock(), window, periodic);
  WindowRows<std::int32_t> mobile(terrain.mobile(), window, periodic);
  const double unit = terrain.quantum() / (static_cast<double>(window.block) * window.block);
  values.resize(2 * window.blocks.cells());
  float* to = values.data();
  if (window.block == 1) {
    for (int row = 0; row < window.blocks.ny; ++row, to += 2 * window.blocks.nx) {
      read_cells(bedrock.row(row), mobile.row(row), window.blocks.nx, unit, to);
    }
    return;
  }
  std::vector<std::int64_t> rock(static_cast<std::size_t>(window.blocks.nx)), sand(rock.size());
  for (int row = 0; row < window.blocks.ny; ++row) {
    sum_blocks(bedrock, row, window.block, rock);
    sum_blocks(mobile, row, window.block, sand);
    for (std::size_t column = 0; column < rock.size(); ++column) {
      *to++ = static_cast<float>(unit * static_cast<double>(rock[column] + sand[column]));
      *to++ = static_cast<float>(unit * static_cast<double>(sand[column]));
    }
  }
}

std::int64_t read_values(const Grid<float>& field, bool periodic, const BlockWindow& window,
                         std::vector<float>& values) {
  WindowRows<float> rows(field, window, periodic);
  std::vector<double> sums(static_cast<std::size_t>(window.blocks.nx));
  values.resize(window.blocks.cells());
  const double share = 1.0 / (static_cast<double>(window.block) * window.block);
  std::int64_t broken = 0;
  float* to = values.data();
  for (int row = 0; row < window.blocks.ny; ++row) {
    sum_blocks(rows, row, window.block, sums);
    for (const double sum : sums) {
      const bool good = std::isfinite(sum);
      if (!good) ++broken;
      *to++ = good ? static_cast<float>(share * sum) : missing_value;
    }
  }
  return broken;
}

}  // namespace erg::render
