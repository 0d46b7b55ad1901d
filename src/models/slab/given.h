// What the kernels of slabs are given of a sub-sweep, a grid and a law: the host's numbers in 32 bits.
#pragma once

#include <cstddef>

#include "forcing/wind_frame.h"
#include "models/slab/plan.h"

namespace erg::models::slab {

/// Slabs that enter on a line: `whole`, and one more where a random number of 16 bits is `from` or more.
struct Inflow {
  u32 whole = 0;
  u32 from = 0x10000;
};

/// The same slabs as int(inflow + random / 65536), whatever the random number.
Inflow whole_inflow(double inflow);

/// Hops from ground of every height: most heights are so great that a hop is as long as it can be.
class HopTable {
 public:
  /// `reference`: over the lowest bedrock, as heights are.
  HopTable(const HopCurve& hop, double reference);
  /// hop_rows_256 from this height, in 0 to hop_heights - 1.
  u32 rows_256(std::size_t height) const { return height < longest_from_ ? computed(height) : longest_; }

 private:
  u32 computed(std::size_t height) const { return hop_rows_256(hop_, static_cast<double>(height) - reference_); }

  HopCurve hop_;
  double reference_;
  u32 longest_ = 0;
  std::size_t longest_from_ = hop_heights;
};

void give_grid(const forcing::WindFrame& frame, bool open, Given& given);
void give_sub_sweep(const SubSweep& sweep, Given& given);

}  // namespace erg::models::slab
