// What is read of a terrain to be drawn: each block is the mean of its cells, whatever edge the window reaches over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/block_window.h"

namespace erg::test {

using render::BlockWindow;

namespace {

constexpr int nx = 13, ny = 9;

Terrain rough_terrain(Boundary boundary) {
  Terrain terrain(Extent{nx, ny}, 1.0, 0.25, boundary);
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      terrain.edit_bedrock()(x, y) = 2'000'000'000 - 1000 * x * y;
      terrain.edit_mobile()(x, y) = (x * 7 + y * 5) % 11;
    }
  }
  return terrain;
}

int place(int index, int count, Boundary boundary) {
  return boundary == Boundary::torus ? (index % count + count) % count : std::clamp(index, 0, count - 1);
}

/// Surface and thickness of a block, cell by cell.
std::pair<float, float> block_of(const Terrain& terrain, const BlockWindow& window, int column, int row) {
  std::int64_t surface = 0, mobile = 0;
  for (int y = 0; y < window.block; ++y) {
    for (int x = 0; x < window.block; ++x) {
      const int at_x = place(window.left + column * window.block + x, nx, terrain.boundary());
      const int at_y = place(window.low + row * window.block + y, ny, terrain.boundary());
      mobile += terrain.mobile()(at_x, at_y);
      surface += std::int64_t{terrain.bedrock()(at_x, at_y)} + terrain.mobile()(at_x, at_y);
    }
  }
  const double unit = terrain.quantum() / (window.block * window.block);
  return {static_cast<float>(unit * static_cast<double>(surface)),
          static_cast<float>(unit * static_cast<double>(mobile))};
}

TEST(BlockWindow, IsReadAsTheMeansOfItsCells) {
  std::vector<float> values;
  for (const Boundary boundary : {Boundary::torus, Boundary::open}) {
    const Terrain terrain = rough_terrain(boundary);
    for (const BlockWindow window :
         {BlockWindow{0, 0, {nx, ny}, 1}, BlockWindow{2, 1, {5, 4}, 1}, BlockWindow{-3, -2, {nx + 7, ny + 5}, 1},
          BlockWindow{0, 0, {5, 3}, 3}, BlockWindow{4, 3, {3, 2}, 2}, BlockWindow{-4, 5, {6, 4}, 4}}) {
      SCOPED_TRACE(testing::Message() << window.left << " " << window.low << ", " << window.block);
      read_terrain(terrain, window, values);
      ASSERT_EQ(values.size(), 2 * window.blocks.cells());
      for (int row = 0; row < window.blocks.ny; ++row) {
        for (int column = 0; column < window.blocks.nx; ++column) {
          const auto [surface, thickness] = block_of(terrain, window, column, row);
          const std::size_t at = 2 * static_cast<std::size_t>(row * window.blocks.nx + column);
          ASSERT_EQ(values[at], surface) << column << " " << row;
          ASSERT_EQ(values[at + 1], thickness) << column << " " << row;
        }
      }
    }
  }
}

TEST(BlockWindow, BlocksWithAValueThatIsNoNumberAreCounted) {
  Grid<float> field(Extent{nx, ny});
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) field(x, y) = static_cast<float>(x + 100 * y);
  }
  field(12, 0) = std::nanf("");
  std::vector<float> values;
  EXPECT_EQ(render::read_values(field, true, {-1, 0, {2, 2}, 1}, values), 1);
  EXPECT_EQ(values, (std::vector<float>{render::missing_value, 0, 112, 100}));
  EXPECT_EQ(render::read_values(field, false, {-1, 0, {2, 2}, 1}, values), 0) << "the outermost cells go on";
  EXPECT_EQ(values, (std::vector<float>{0, 0, 100, 100}));
}

}  // namespace
}  // namespace erg::test
