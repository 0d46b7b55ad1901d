// The kernels of the parallel engine, compiled once for each instruction set into its own namespace (ERG_KERNELS). They
// are plain loops over the lanes of a row, which the compiler turns into vectors. To keep the copies apart nothing here
// calls an inline function of the library; the shared cell rules are forced inline.

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "kernels/each_lane.h"
#include "kernels/fixed_point.h"
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

#include "models/slab/sweep_conveyor.inl"

#include "models/slab/sweep_slides.inl"

#include "models/slab/sweep_seams.inl"

template <typename Lane>
void convey(const SweepPlan<Lane>& plan, Strip<Lane>& strip) {
  Conveyor<Lane>(plan, strip).convey();
}

template <typename Lane>
void hand_over(const SweepPlan<Lane>& plan, Strip<Lane>& strip) {
  std::size_t start[most_lead];  // of the places after the strip's own
  for (int k = 0; k < most_lead; ++k) {
    start[k] = plan.layout.at_place(plan.layout.wrapped(strip.first + strip.lines + k), 0);
  }
  for (int y = 0; y < plan.layout.length; ++y) {
    const Overhang<Lane>& overhang = strip.overhang[y];
    Lane* row = plan.after + static_cast<std::size_t>(y) * static_cast<std::size_t>(plan.layout.pitch);
    const int skipped = overhang.lead > strip.lines ? overhang.lead - strip.lines : 0;
    for (int k = skipped; k < overhang.lead; ++k) row[start[k]] = overhang.heights[k - skipped];
  }
}

template <typename Lane>
void carry(const SweepPlan<Lane>& plan, Strip<Lane>& strip) {
  Conveyor<Lane>(plan, strip).carry();
}

template <typename Lane>
void slide_tile(const SlidePlan<Lane>& plan, const SlideTile& tile) {
  Slider<Lane>(plan).tile(tile);
}

template <typename Lane>
void slide_row_seam(const SlidePlan<Lane>& plan, const SlideTile& below) {
  Slider<Lane>(plan).row_seam(below);
}

template <typename Lane>
void slide_column_seam(const SlidePlan<Lane>& plan, int left, int right, bool left_mine, bool right_mine) {
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
constexpr SweepKernels<Lane> all_kernels{
    convey<Lane>,     hand_over<Lane>,         carry<Lane>,       slide_tile<Lane>,   slide_row_seam<Lane>,
    keep_edges<Lane>, slide_column_seam<Lane>, keep_firsts<Lane>, slide_corners<Lane>};
const SweepKernels<std::uint8_t> narrow_kernels = all_kernels<std::uint8_t>;
const SweepKernels<std::uint16_t> wide_kernels = all_kernels<std::uint16_t>;

}  // namespace ERG_KERNELS
}  // namespace erg::models
