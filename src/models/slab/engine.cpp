#include "models/slab/engine.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "kernels/fixed_point.h"
#include "kernels/line_walk.h"
#include "kernels/shadow_reach.h"
#include "models/slab/slab_cell.h"
#include "models/slab/sub_sweep.h"

namespace erg::models {
namespace {

/// The steepest fall of a shadow line that 8-bit lanes can tell from a steeper one.
constexpr std::uint32_t narrow_shadow = 0xffff;

/// Rows upwind of row 0 from which a shadow line can reach into the grid: as far as it takes to fall from the highest
/// cell to the ground, and not beyond where the line has met every cell that it ever meets.
int warm_up_rows(const SubSweep& sweep, int highest) {
  const auto around = static_cast<int>(std::min<std::int64_t>(sweep.rows_around, std::numeric_limits<int>::max() / 2));
  return kernels::shadow_reach(static_cast<double>(std::int64_t{highest} << kernels::fixed_point_bits), sweep.row_fall,
                               1, around + 2);
}

/// Tiles are numbered up each block, then along the blocks.
int tile_rows_of(int length) { return std::max(1, length / tile_rows); }
SlideTile tile_number(int number, int length) {
  const int rows = tile_rows_of(length);
  const int row = number % rows;
  // The last tile takes the rows that are left over.
  return {number / rows, row * tile_rows, row + 1 == rows ? length : (row + 1) * tile_rows};
}

/// By how many strips of so many lines a line has drifted, to the nearest, where it comes over the torus edge.
template <typename Lane>
int strips_over_edge(const SweepPlan<Lane>& plan, int lines) {
  const int length = plan.layout.length;
  return (kernels::line_offset(length, plan.drift, plan.phase, length) + lines / 2) / lines;
}

}  // namespace

StepReport SlabEngine::step(Terrain& terrain, const SlabLaw& law, const forcing::WindFrame& frame, double strength,
                            StepKey key, Grid<std::int32_t>* lift_counts) {
  largest_step_ = std::max({law.bare.straight, law.covered.straight, law.bare.diagonal, law.covered.diagonal});
  if (!lies_ready_for(frame) && !turn_rows(frame)) {
    sync_to_host(terrain);
    load(terrain, frame);
  }
  frame_ = frame;
  if (narrow_ != narrow_fits(narrow_ ? highest_ : highest_ + highest_ / 8)) change_lanes(!narrow_);
  prepare_walls(law);
  prepare_lift_counts(lift_counts != nullptr);

  Progress progress;
  progress.law = &law;
  progress.key = key;
  progress.highest = highest_;
  const auto sweep = [&]<typename Lane>(Lane) {
    load_cover<Lane>(law);
    prepare_hops<Lane>(law, strength, key);
    return sweep_until_done<Lane>(progress);
  };
  while (!(narrow_ ? sweep(std::uint8_t{}) : sweep(std::uint16_t{}))) change_lanes(false);
  highest_ = progress.highest;
  add_lift_counts_to(lift_counts);

  const SweepCounters& counts = progress.counts;
  mobile_total_ += counts.slabs_in - counts.slabs_out;
  StepReport report;
  report.polls = counts.polls;
  report.lifts = counts.lifts;
  report.travel = static_cast<double>(counts.rows_flown) / frame_.cosine;
  report.slabs_in = counts.slabs_in;
  report.slabs_out = counts.slabs_out;
  return report;
}

// --- sub-sweeps ---

bool SlabEngine::goes_on(const Progress& progress) const {
  return erg::models::goes_on(*progress.law, progress.account, cells(), options_.sweeps);
}

/// Runs sub-sweeps until the step is done; false if 8-bit lanes cannot hold the next one, which then has left no trace.
template <typename Lane>
bool SlabEngine::sweep_until_done(Progress& progress) {
  Planes<Lane>& mine = planes<Lane>();
  while (goes_on(progress)) {
    const int rows = ring_rows(progress.highest);
    prepare_strips<Lane>(rows);
    const Progress start = progress;
    bool overflow = false;
    pool_.run(sweepers(), [&](int member) {
      const Progress end = sweep_as_member<Lane>(member, start, rows);
      if (member != 0) return;
      progress = end;
      overflow = end.overflow;
    });
    if ((progress.account.sweep - start.account.sweep) % 2 != 0) std::swap(mine.before, mine.after);
    if (overflow) {
      progress.overflow = false;
      std::fill(mine.rings.begin(), mine.rings.end(), Lane{0});
      return false;
    }
  }
  return true;
}

/// One member's part of the sub-sweeps to come, until the step is done, the rings are too short or a place is too
/// overflowing. Every member keeps the same account, so that all leave the loop together.
template <typename Lane>
SlabEngine::Progress SlabEngine::sweep_as_member(int member, Progress progress, int rows) {
  Planes<Lane>& mine = planes<Lane>();
  const SweepKernels<Lane>& kernels = sweep_kernels<Lane>(options_.instructions);
  const auto [first_strip, end_strip] = share(static_cast<int>(mine.strips.size()), member, sweepers());
  const bool apart = lines_stay_apart<Lane>();
  Lane* before = mine.before.data();
  Lane* after = mine.after.data();
  if (layout_.skew != 0) {
    SweepPlan<Lane> plan = sweep_plan<Lane>(progress);
    plan.after = before;
    keep_ghosts<Lane>(kernels, slide_plan<Lane>(plan, *progress.law, member, 0), member);
    pool_.barrier();
  }
  if (!progress.law->repeated_polling && progress.account.sweep % options_.sweeps != 0) draw_round(progress, member);
  // What members show each other lies in two places in turn: no member is more than one meeting ahead of another.
  for (int turn = 0; goes_on(progress) && ring_rows(progress.highest) <= rows; turn = 1 - turn) {
    if (!progress.law->repeated_polling && progress.account.sweep % options_.sweeps == 0) draw_round(progress, member);
    SweepPlan<Lane> plan = sweep_plan<Lane>(progress);
    plan.before = before;
    plan.after = after;
    plan.ring_rows = rows;
    plan.lifted = lifted_.empty() ? nullptr : lifted_.data();
    for (int k = first_strip; k < end_strip; ++k)
      kernels.transport_pass(plan, mine.strips[static_cast<std::size_t>(k)]);
    barrier_unless(apart);
    const auto strips = static_cast<int>(mine.strips.size());
    if (layout_.skew != 0) {
      // What hangs over into a member's strip it takes itself: those places are in its own processor's cache.
      for (int k = first_strip; k < end_strip; ++k) {
        kernels.hand_over(plan, mine.strips[static_cast<std::size_t>((k + strips - 1) % strips)]);
      }
      barrier_unless(apart);
    }
    // For the same reason it carries those strips that come over the torus edge into its own, or nearly so.
    const int over = strips_over_edge(plan, mine.strips.front().lines) % strips;
    for (int k = first_strip; k < end_strip; ++k) {
      Strip<Lane>& strip = mine.strips[static_cast<std::size_t>((k + strips - over) % strips)];
      if (!plan.open && !strip.counts.overflow) kernels.wrap_pass(plan, strip);
      strip.shown[turn] = strip.counts;
    }
    barrier_unless(apart);
    const SlidePlan<Lane> slides = slide_plan<Lane>(plan, *progress.law, member, turn);
    slide_blocks<Lane>(kernels, slides, member, apart);
    pool_.barrier();
    const SweepCounters counts = summed(mine.strips, turn);
    const int bound = progress.highest + static_cast<int>(counts.most_landed + counts.most_carried);
    if (counts.overflow || (sizeof(Lane) == 1 && !narrow_fits(bound))) {
      progress.overflow = true;
      break;
    }
    if (plan.lifted != nullptr) add_lifted(member);
    slide_borders<Lane>(kernels, slides, member);
    barrier_unless(apart);
    take_account(progress, plan, counts, bound);
    std::swap(before, after);
  }
  return progress;
}

/// What a round of non-repeated polling draws; each member takes a part of it.
void SlabEngine::draw_round(const Progress& progress, int member) {
  const auto [first, end] = share(PolledRows::permutations, member, sweepers());
  polled_rows_[rows_of_round(progress)].draw(progress.key, progress.account.sweep, options_.sweeps, first, end);
  pool_.barrier();
}

void SlabEngine::barrier_unless(bool apart) {
  if (!apart) pool_.barrier();
}

void SlabEngine::take_account(Progress& progress, const SubSweep& done, const SweepCounters& counts, int bound) {
  progress.counts.polls += counts.polls;
  progress.counts.lifts += counts.lifts;
  progress.counts.rows_flown += counts.rows_flown;
  progress.counts.slabs_in += counts.slabs_in;
  progress.counts.slabs_out += counts.slabs_out;
  progress.highest = std::min(bound, static_cast<int>(counts.highest + counts.most_carried));
  progress.account.book(done, counts.lifts);
}

template <typename Lane>
SweepCounters SlabEngine::summed(const std::vector<Strip<Lane>>& strips, int turn) {
  SweepCounters sum;
  for (const Strip<Lane>& strip : strips) {
    const SweepCounters& counts = strip.shown[turn];
    sum.polls += counts.polls;
    sum.lifts += counts.lifts;
    sum.rows_flown += counts.rows_flown;
    sum.slabs_in += counts.slabs_in;
    sum.slabs_out += counts.slabs_out;
    sum.highest = std::max(sum.highest, counts.highest);
    sum.most_landed = std::max(sum.most_landed, counts.most_landed);
    sum.most_carried = std::max(sum.most_carried, counts.most_carried);
    sum.overflow = sum.overflow || counts.overflow;
  }
  return sum;
}

/// Slides inside tiles, then over the borders between the rows of tiles, and keeps what the borders between blocks
/// need. A member's tiles stand in the columns of its strips, so that (on a straight wind) what it conveyed is still
/// near.
template <typename Lane>
void SlabEngine::slide_blocks(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member, bool apart) {
  const int length = plan.layout.length;
  const int blocks = plan.layout.blocks;
  const auto [first, end] = share(blocks * tile_rows_of(length), member, sweepers());
  for (int k = first; k < end; ++k) kernels.slide_tile(plan, tile_number(k, length));
  // Two members may hold parts of one block; and over the edge of a skewed torus tiles meet other blocks.
  barrier_unless(apart);
  for (int k = first; k < end; ++k) {
    const SlideTile tile = tile_number(k, length);
    if (tile.end_row < length || (!plan.open && length > 2)) kernels.slide_row_border(plan, tile);
  }
  barrier_unless(apart);
  const auto [first_block, end_block] = share(blocks, member, sweepers());
  for (int block = first_block; block < end_block; ++block) kernels.keep_edges(plan, block);
}

/// Slides over the borders between blocks. Members whose blocks meet there both do so, each for its own side.
template <typename Lane>
void SlabEngine::slide_borders(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member) {
  const int blocks = plan.layout.blocks;
  const auto [first, end] = share(blocks, member, sweepers());
  const auto is_mine = [first = first, end = end](int block) { return first <= block && block < end; };
  for (int left = 0; left < blocks; ++left) {
    const bool closes = left + 1 == blocks;
    if (closes && (plan.open || plan.layout.width <= 2)) continue;
    const int right = closes ? 0 : left + 1;
    if (is_mine(left) || is_mine(right)) {
      kernels.slide_column_border(plan, left, right, is_mine(left), is_mine(right));
    }
  }
  if (plan.layout.skew == 0) return;
  keep_ghosts<Lane>(kernels, plan, member);
  if (!plan.diagonals || plan.layout.length == 1) return;
  pool_.barrier();
  if (member != 0) return;
  kernels.slide_corners(plan);
  for (int block = 0; block < blocks; ++block) {
    kernels.keep_ghosts(plan, block, 0, 1);
    kernels.keep_ghosts(plan, block, plan.layout.length - 1, plan.layout.length);
  }
}

/// Skewed planes: keeps the first places of the member's blocks.
template <typename Lane>
void SlabEngine::keep_ghosts(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member) {
  const auto [first, end] = share(plan.layout.blocks, member, sweepers());
  for (int block = first; block < end; ++block) kernels.keep_ghosts(plan, block, 0, plan.layout.length);
}

/// Members that carry out sub-sweeps: no more than processors, for others would only keep these waiting at each
/// meeting. Who asks for a thread a line, as tests do, has them all.
int SlabEngine::sweepers() const {
  const bool all = options_.lines_a_thread == 1;
  const int members = all ? pool_.size() : std::min(pool_.size(), processors_);
  return std::clamp(frame_.width / options_.lines_a_thread, 1, members);
}

/// The part [first, end) of `count` things that falls to one of `members`.
std::pair<int, int> SlabEngine::share(int count, int member, int members) {
  const auto part = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(count) * k / members); };
  return {part(member), part(member + 1)};
}

template <typename Lane>
SweepPlan<Lane> SlabEngine::sweep_plan(const Progress& progress) const {
  const Planes<Lane>& mine = planes<Lane>();
  SweepPlan<Lane> plan;
  static_cast<SubSweep&>(plan) = sub_sweep(*progress.law, frame_, open_, progress.key, progress.account,
                                           options_.sweeps, polled_rows_[rows_of_round(progress)]);
  plan.layout = layout_;
  plan.before_ghosts = mine.ghosts.data();
  plan.bedrock = mine.bedrock.empty() ? nullptr : mine.bedrock.data();
  plan.cover = cover_.empty() ? nullptr : cover_.data();
  plan.wall_rows = wall_rows_.empty() ? nullptr : wall_rows_.data();
  plan.open = open_;
  if (sizeof(Lane) == 1) {
    plan.row_fall = std::min(plan.row_fall, narrow_shadow);
  }
  plan.warm_up = warm_up_rows(plan, progress.highest);
  plan.hop_by_height = hop_table_.size() > 1;
  plan.hop_table = hop_table_.data();
  return plan;
}

template <typename Lane>
SlidePlan<Lane> SlabEngine::slide_plan(const SweepPlan<Lane>& sweep, const SlabLaw& law, int member, int turn) {
  Planes<Lane>& mine = planes<Lane>();
  SlidePlan<Lane> plan;
  plan.layout = layout_;
  plan.heights = sweep.after;
  plan.bedrock = mine.bedrock.empty() ? nullptr : mine.bedrock.data();
  plan.steps = mine.steps.empty() ? nullptr : mine.steps.data();
  plan.diagonal_steps = mine.diagonal_steps.empty() ? nullptr : mine.diagonal_steps.data();
  plan.step = std::min(law.bare.straight, longest_step);
  plan.diagonal_step = std::min(law.bare.diagonal, longest_step);
  plan.diagonals = sweep.edge_classes == 8;
  plan.open = open_;
  plan.order = sweep.order;
  plan.ghosts = mine.ghosts.data();
  plan.edges = mine.edges.data() + mine.edges.size() / 2 * static_cast<std::size_t>(turn);
  plan.border = mine.borders.data() +
                mine.borders.size() / static_cast<std::size_t>(sweepers()) * static_cast<std::size_t>(member);
  return plan;
}

}  // namespace erg::models
