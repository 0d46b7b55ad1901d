// The rules of cells in 32 bits, as kernels read them, against the same in 64 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "core/random.h"
#include "core/terrain.h"
#include "kernels/line_walk.h"
#include "models/slab/given.h"
#include "models/slab/slab_cell.h"

namespace erg::models {
namespace {

/// high_product as shaders have it.
struct OfHalves {
#include "core/high_product.k"
};

std::uint64_t whole(Wide word) { return word.lo | std::uint64_t{word.hi} << 32; }
Wide halves(std::uint64_t word) { return wide(static_cast<u32>(word), static_cast<u32>(word >> 32)); }

/// Words at random, and those whose sums and products carry.
const std::vector<std::uint64_t>& words() {
  static const std::vector<std::uint64_t> all = [] {
    std::vector<std::uint64_t> made;
    for (const std::uint64_t edge : {0ULL, 1ULL, 0xffffULL, 0x10000ULL, 0x7fffffffULL, 0x80000000ULL, 0xffffffffULL}) {
      for (const std::uint64_t upper : {0ULL, 1ULL, 0x7fffffffULL, 0xffffffffULL}) made.push_back(upper << 32 | edge);
    }
    for (std::uint64_t k = 0; k < 1000; ++k) made.push_back(mix64(k));
    return made;
  }();
  return all;
}

TEST(SubsetRules, CountInTwoWordsAsInOneOf64Bits) {
  OfHalves of_halves;
  for (const std::uint64_t a : words()) {
    EXPECT_EQ(whole(wide_mix(halves(a))), mix64(a)) << a;
    for (u32 by = 1; by < 32; ++by) EXPECT_EQ(whole(wide_fold(halves(a), by)), a ^ (a >> by)) << a;
    for (const std::uint64_t b : words()) {
      const auto low_a = static_cast<u32>(a);
      const auto low_b = static_cast<u32>(b);
      ASSERT_EQ(whole(wide_sum(halves(a), halves(b))), a + b) << a << ", " << b;
      ASSERT_EQ(whole(wide_difference(halves(a), halves(b))), a - b) << a << ", " << b;
      ASSERT_EQ(whole(wide_times(halves(a), halves(b))), a * b) << a << ", " << b;
      ASSERT_EQ(whole(wide_product(low_a, low_b)), std::uint64_t{low_a} * low_b) << a << ", " << b;
      ASSERT_EQ(of_halves.high_product(low_a, low_b), high_product(low_a, low_b)) << a << ", " << b;
    }
  }
}

TEST(SubsetRules, DrawTheSameForRowsAndLines) {
  for (const std::uint64_t word : words()) {
    for (const u32 row : {0U, 1U, 17U, 16383U, 600000U}) {
      const std::uint64_t of_row = row_word(word, row);
      const Wide in_halves = row_word(halves(word), row);
      EXPECT_EQ(whole(in_halves), of_row) << word << ", " << row;
      for (u32 draw = 0; draw < 20; ++draw) EXPECT_EQ(draw_key(in_halves, draw), draw_key(of_row, draw));
      for (const u32 rows_256 : {1U, 256U, 1300U, 1U << 20}) {
        EXPECT_EQ(hop_key(halves(word), row, rows_256), hop_key(word, row, rows_256));
      }
      for (const u32 chance : {0U, 1U, 26214U, 65535U, 65536U}) {
        EXPECT_EQ(byte_chance(chance, in_halves), byte_chance(chance, of_row));
      }
    }
  }
}

/// As far beyond the largest grid as slabs fly.
TEST(SubsetRules, FindLinesOfTheLargestGridIn32Bits) {
  for (const i32 rows : {1, 2, 7, 101, 4096, largest_side}) {
    for (const i32 drift : {0, 1, rows / 3, rows}) {
      for (const i32 phase : {0, rows / 2, rows - 1}) {
        const i32 last = 2 * (longest_flight + 1) * rows;
        for (i32 row = 0; row <= last; row += 1 + last / 1000) {
          ASSERT_EQ(line_offset_from_0(row, drift, phase, rows), kernels::line_offset(row, drift, phase, rows))
              << row << " of " << rows << ", " << drift << ", " << phase;
        }
      }
    }
  }
}

TEST(SubsetRules, SkewBlocksOfTheLargestGridIn32Bits) {
  for (const std::int64_t skew : {0LL, 1LL, 1LL << 12, 12345678LL, (1LL << 24) - 1, 1LL << 24}) {
    PlaneLayout layout;
    layout.skew = skew;
    for (int row = 0; row < largest_side; ++row) {
      ASSERT_EQ(slab::skew_of(row, static_cast<u32>(skew)), layout.shift(row)) << row << ", " << skew;
    }
  }
}

TEST(SubsetRules, LetInAsManySlabsAsTheRealNumberSays) {
  for (const double inflow : {0.0, 1e-9, 1.0 / 65536, 0.3, 0.5, 1.0, 2.9999999999999996, 1e3 / 7, 1e5}) {
    const slab::Inflow found = slab::whole_inflow(inflow);
    for (u32 random = 0; random < 65536; ++random) {
      const auto slabs = static_cast<u32>(inflow + random * (1.0 / 65536));
      ASSERT_EQ(found.whole + (random >= found.from ? 1 : 0), slabs) << inflow << ", " << random;
    }
  }
}

TEST(SubsetRules, TabulateHopsFromGroundOfEveryHeight) {
  for (const double linear : {0.4, 1e-7, -0.01, 0.0}) {
    for (const double quadratic : {0.0, 0.002, -0.001}) {
      const HopCurve hop{5, linear, quadratic, 0.9, 0.3, most_hop_rows(5, 0.9, 256)};
      const slab::HopTable table(hop, 30.5);
      for (std::size_t height = 0; height < slab::hop_heights; ++height) {
        ASSERT_EQ(table.rows_256(height), hop_rows_256(hop, static_cast<double>(height) - 30.5))
            << height << ", " << linear << ", " << quadratic;
      }
    }
  }
}

/// A grid as kernels see it.
slab::Plan plan_of(i32 width, i32 rows, i32 drift, i32 phase) {
  slab::Plan plan;
  plan.given.width = width;
  plan.given.rows = rows;
  plan.given.oblique = 1;
  plan.given.drift = drift;
  plan.given.phase = phase;
  return plan;
}

/// Calls visit(plan, line, column) for every line that moves through such grids; column(row) is where it would be in a
/// row if they had no sides.
template <typename Visit>
void for_each_line(std::initializer_list<Extent> grids, const Visit& visit) {
  for (const Extent grid : grids) {
    for (i32 drift = 0; drift <= grid.ny; ++drift) {
      for (i32 phase = 0; phase < grid.ny; ++phase) {
        slab::Plan plan = plan_of(grid.nx, grid.ny, drift, phase);
        for (i32 line = 0; line < grid.nx; ++line) {
          SCOPED_TRACE(testing::Message() << grid.nx << " x " << grid.ny << ", drift " << drift << ", phase " << phase);
          visit(plan, line, [&](i32 row) { return line + kernels::line_offset(row, drift, phase, grid.ny); });
        }
      }
    }
  }
}

TEST(SubsetLines, WalkFromRowToRowWhereTheyAreFoundOneByOne) {
  for_each_line({{1, 1}, {5, 1}, {1, 6}, {7, 5}, {4, 13}}, [](slab::Plan& plan, i32 line, const auto& column) {
    const i32 rows = plan.given.rows;
    auto walk = plan.walk_at(line, 0);
    auto back = plan.walk_at(line, 3 * rows);
    for (i32 row = 0; row < 3 * rows; ++row) {
      const i32 cell = row % rows * plan.given.width + wrap(column(row), plan.given.width);
      ASSERT_EQ(plan.cell_at(walk), cell) << "on, " << row;
      ASSERT_EQ(plan.cell_of(line, row), cell) << row;
      ASSERT_EQ(plan.cell_at(plan.walk_at(line, row)), cell) << row;
      walk = plan.next_row(walk);
      back = plan.previous_row(back);
      const i32 from_behind = 3 * rows - 1 - row;
      ASSERT_EQ(plan.cell_at(back), plan.cell_of(line, from_behind)) << "back, " << from_behind;
    }
  });
}

TEST(SubsetLines, EnterAndLeaveAnOpenGridWhereTheyMoveOverItsSide) {
  for_each_line({{1, 4}, {3, 9}, {9, 4}}, [](slab::Plan& plan, i32 line, const auto& column) {
    const i32 rows = plan.given.rows;
    const auto round = [&](i32 row) { return column(row) / plan.given.width; };
    for (i32 row = 0; row < rows; ++row) {
      i32 first = row;
      while (first > 0 && round(first - 1) == round(row)) --first;
      i32 end = row;
      while (end < rows && round(end) == round(row)) ++end;
      ASSERT_EQ(plan.entering_row(line, row), first) << row;
      ASSERT_EQ(plan.leaving_row(line, row), end) << row;
    }
  });
}

/// A thread of the processor may fly more rows in a launch than 32 bits hold.
TEST(SubsetCounts, CarryIntoTheirUpperWord) {
  std::vector<u32> numbers(slab::highest_at + 2);
  slab::Plan plan;
  plan.numbers = numbers.data();
  std::uint64_t sum = 0;
  for (const std::uint64_t amount : words()) {
    plan.tally(6, halves(amount));
    sum += amount;
    EXPECT_EQ(whole(wide(numbers[6], numbers[7])), sum);
  }
  EXPECT_EQ(std::ranges::count(numbers, 0U), slab::highest_at);
}

}  // namespace
}  // namespace erg::models
