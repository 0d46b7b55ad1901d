#include "render/block_window.h"

#include <algorithm>
#include <cmath>

namespace erg::render {
namespace {

int inside(int index, int count, bool periodic) {
  return periodic ? wrap(index, count) : std::clamp(index, 0, count - 1);
}

// The column of the grid for each column of cells of the window.
std::vector<int> columns_of(const BlockWindow& window, int count, bool periodic) {
  std::vector<int> columns(static_cast<std::size_t>(window.blocks.nx) * static_cast<std::size_t>(window.block));
  for (std::size_t column = 0; column < columns.size(); ++column) {
    columns[column] = inside(window.left + static_cast<int>(column), count, periodic);
  }
  return columns;
}

// Adds a row of cells to the sums of its blocks.
template <typename Value, typename Sum>
void add_row(const Value* row, const std::vector<int>& columns, int block, std::vector<Sum>& sums) {
  std::size_t column = 0;
  for (Sum& sum : sums) {
    for (int step = 0; step < block; ++step, ++column) sum += static_cast<Sum>(row[columns[column]]);
  }
}

// The rows of a block, added up.
template <typename Sum, typename Value>
void sum_rows(const Grid<Value>& grid, const BlockWindow& window, int row, bool periodic,
              const std::vector<int>& columns, std::vector<Sum>& sums) {
  std::fill(sums.begin(), sums.end(), Sum{});
  for (int step = 0; step < window.block; ++step) {
    const int y = inside(window.low + row * window.block + step, grid.ny(), periodic);
    add_row(grid.row(y).data(), columns, window.block, sums);
  }
}

}  // namespace

BlockWindow whole_window(Extent extent, int largest) {
  const int block = (std::max(extent.nx, extent.ny) + largest - 1) / largest;
  return {0, 0, {(extent.nx + block - 1) / block, (extent.ny + block - 1) / block}, block};
}

void read_terrain(const Terrain& terrain, const BlockWindow& window, std::vector<float>& values) {
  const bool periodic = terrain.boundary() == Boundary::torus;
  const std::vector<int> columns = columns_of(window, terrain.nx(), periodic);
  const double unit = terrain.quantum() / (static_cast<double>(window.block) * window.block);
  std::vector<std::int64_t> bedrock(static_cast<std::size_t>(window.blocks.nx)), mobile(bedrock.size());
  values.resize(2 * window.blocks.cells());
  float* to = values.data();
  for (int row = 0; row < window.blocks.ny; ++row) {
    sum_rows(terrain.bedrock(), window, row, periodic, columns, bedrock);
    sum_rows(terrain.mobile(), window, row, periodic, columns, mobile);
    for (std::size_t column = 0; column < bedrock.size(); ++column) {
      *to++ = static_cast<float>(unit * static_cast<double>(bedrock[column] + mobile[column]));
      *to++ = static_cast<float>(unit * static_cast<double>(mobile[column]));
    }
  }
}

std::int64_t read_values(const Grid<float>& field, bool periodic, const BlockWindow& window,
                         std::vector<float>& values) {
  const std::vector<int> columns = columns_of(window, field.nx(), periodic);
  std::vector<double> sums(static_cast<std::size_t>(window.blocks.nx));
  values.resize(window.blocks.cells());
  const double share = 1.0 / (static_cast<double>(window.block) * window.block);
  std::int64_t broken = 0;
  float* to = values.data();
  for (int row = 0; row < window.blocks.ny; ++row) {
    sum_rows(field, window, row, periodic, columns, sums);
    for (const double sum : sums) {
      const bool good = std::isfinite(sum);
      if (!good) ++broken;
      *to++ = good ? static_cast<float>(share * sum) : missing_value;
    }
  }
  return broken;
}

}  // namespace erg::render
