// The kernels of the parallel engine, compiled once for each instruction set into its own namespace (ERG_KERNELS). They
// are plain loops over the lanes of a row, which the compiler turns into vectors. To keep the copies apart nothing here
// calls an inline function of the library; the shared cell rules are forced inline.

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "kernels/each_lane.h"
#include "kernels/fixed_point.h"
#include "kernels/line_walk.h"
#include "models/slab/slab_cell.h"
#include "models/slab/sweep.h"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace erg::models {
namespace ERG_KERNELS {
namespace {

#include "models/slab/sweep_lines.inl"

#include "models/slab/sweep_row.inl"

#include "models/slab/sweep_shadow.inl"

#include "models/slab/sweep_flight.inl"

#include "models/slab/sweep_transport.inl"

#include "models/slab/sweep_slides.inl"

#include "models/slab/sweep_borders.inl"

template <typename Lane>
void transport_pass(const SweepPlan<Lane>& plan, Strip<Lane>& strip) {
  TransportPass<Lane>(plan, strip).transport_pass();
}

template <typename Lane>
void hand_over(const SweepPlan<Lane>& plan, Strip<Lane>& strip) {
  std::size_t start[most_offset];  // of the places after the strip's own
  for (int k = 0; k < most_offset; ++k) {
    start[k] = plan.layout.at_place(plan.layout.wrapped(strip.first + strip.lines + k), 0);
  }
  for (int y = 0; y < plan.layout.length; ++y) {
    const Halo<Lane>& halo = strip.halo[y];
    Lane* row = plan.after + static_cast<std::size_t>(y) * static_cast<std::size_t>(plan.layout.pitch);
    const int skipped = halo.offset > strip.lines ? halo.offset - strip.lines : 0;
    for (int k = skipped; k < halo.offset; ++k) row[start[k]] = halo.heights[k - skipped];
  }
}

template <typename Lane>
void wrap_pass(const SweepPlan<Lane>& plan, Strip<Lane>& strip) {
  TransportPass<Lane>(plan, strip).wrap_pass();
}

template <typename Lane>
void slide_tile(const SlidePlan<Lane>& plan, const SlideTile& tile) {
  Slider<Lane>(plan).tile(tile);
}

template <typename Lane>
void slide_row_border(const SlidePlan<Lane>& plan, const SlideTile& below) {
  Slider<Lane>(plan).row_border(below);
}

template <typename Lane>
void slide_column_border(const SlidePlan<Lane>& plan, int left, int right, bool left_mine, bool right_mine) {
  ColumnSeam<Lane>(plan, left, right).slide(left_mine, right_mine);
}

template <typename Lane>
void slide_corners(const SlidePlan<Lane>& plan) {
  Slider<Lane>(plan).corners();
}

#undef ERG_EACH

}  // namespace

extern const SweepKernels<std::uint8_t> narrow_kernels;
extern const SweepKernels<std::uint16_t> wide_kernels;
template <typename Lane>
constexpr SweepKernels<Lane> all_kernels{transport_pass<Lane>,      hand_over<Lane>,        wrap_pass<Lane>,
                                         slide_tile<Lane>,          slide_row_border<Lane>, keep_edges<Lane>,
                                         slide_column_border<Lane>, keep_ghosts<Lane>,      slide_corners<Lane>};
const SweepKernels<std::uint8_t> narrow_kernels = all_kernels<std::uint8_t>;
const SweepKernels<std::uint16_t> wide_kernels = all_kernels<std::uint16_t>;

}  // namespace ERG_KERNELS
}  // namespace erg::models
