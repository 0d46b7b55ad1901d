#include "models/slab/sub_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/grid.h"
#include "forcing/wind_frame.h"
#include "kernels/line_walk.h"
#include "kernels/shadow_reach.h"
#include "models/slab/slab_cell.h"
#include "models/slab/slab_law.h"

namespace erg {

using forcing::WindFrame;
using models::SubSweep;

namespace {

/// The column that a line meets in a row, which may lie upwind of the grid.
std::int64_t column(const SubSweep& sweep, const WindFrame& frame, std::int64_t row) {
  const std::int64_t moved = kernels::line_offset(row, sweep.drift, sweep.phase, frame.length) % frame.width;
  return (moved + frame.width) % frame.width;
}

TEST(SubSweep, ALineOfATorusIsBackAfterRowsAround) {
  for (const Extent extent : {Extent{20, 20}, Extent{64, 48}, Extent{21, 50}, Extent{1, 7}, Extent{9, 14}}) {
    for (const double bearing : {270.0, 275.0, 290.0, 315.0, 10.0, 200.5}) {
      const WindFrame frame = forcing::wind_frame(extent, bearing);
      for (int number = 0; number < 8; ++number) {
        const SubSweep sweep = models::sub_sweep(models::SlabLaw{}, frame, false, {5, 3}, {.sweep = number}, 16, {});
        EXPECT_EQ(sweep.rows_around % frame.length, 0);
        EXPECT_LE(sweep.rows_around, std::int64_t{frame.length} * std::min(frame.width, kernels::longest_shadow));
        if (sweep.rows_around == std::int64_t{frame.length} * kernels::longest_shadow) continue;  // cut off
        for (std::int64_t away = 1; away <= 3 * frame.length; ++away) {
          ASSERT_EQ(column(sweep, frame, -away), column(sweep, frame, -away - sweep.rows_around))
              << bearing << " deg, row " << away;
        }
        // Not before: somewhere within the turns it is elsewhere.
        for (std::int64_t rows = frame.length; rows < sweep.rows_around; rows += frame.length) {
          EXPECT_NE(column(sweep, frame, -1), column(sweep, frame, -1 - rows));
        }
      }
    }
  }
}

}  // namespace
}  // namespace erg
