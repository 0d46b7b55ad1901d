// Where a made-up heap stands, on the torus and in a veil of drift.
#include <gtest/gtest.h>

#include "analysis/heap_middle.h"

namespace erg {

using analysis::heap_middle;

namespace {

TEST(HeapMiddle, OfAHeapAcrossTheEdge) {
  Grid<std::int32_t> mobile(Extent{20, 3});
  for (int y = 0; y < 3; ++y) {
    mobile(18, y) = 2;
    mobile(19, y) = 5;
    mobile(0, y) = 3;
  }
  EXPECT_DOUBLE_EQ(heap_middle(mobile, 3), 19 + 0.1);
}

TEST(HeapMiddle, LeavesOutWhatLiesFarther) {
  Grid<std::int32_t> mobile(Extent{40, 1});
  mobile(10, 0) = 9;
  for (int x = 20; x < 30; ++x) mobile(x, 0) = 1;
  EXPECT_DOUBLE_EQ(heap_middle(mobile, 5), 10);
  EXPECT_GT(heap_middle(mobile, 15), 12) << "a longer reach takes in the veil";
}

TEST(HeapMiddle, OfNothing) { EXPECT_DOUBLE_EQ(heap_middle(Grid<std::int32_t>(Extent{8, 8}), 4), 0); }

}  // namespace
}  // namespace erg
