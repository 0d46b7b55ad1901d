#include "transport/parallel_executor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "core/errors.h"
#include "transport/fixed_point.h"
#include "transport/slab_cell.h"

namespace erg {
namespace {

/// Forced erosion gives up after this many rounds of K sub-sweeps without a lift.
constexpr int idle_rounds = 4;

/// What the random words of a step are for; each has a key space of its own.
enum SweepWord : std::uint64_t { decisions = 16, polls, lines, slide_order, permutations };

/// 256 permutations of K rows, one for each random byte, seen by one sub-sweep of the round: the row it polls.
void permuted_rows(StepKey key, int round, int sweep, int sweeps, std::vector<std::uint8_t>& rows) {
  rows.resize(256);
  std::array<std::uint8_t, 64> order{};
  for (std::uint32_t number = 0; number < 256; ++number) {
    for (int k = 0; k < sweeps; ++k) order[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(k);
    std::uint64_t word = random_word(key, static_cast<std::uint64_t>(round), number, permutations);
    for (int last = sweeps - 1; last > 0; --last) {
      word = mix64(word);
      const auto other = static_cast<std::size_t>(((word >> 32) * static_cast<std::uint64_t>(last + 1)) >> 32);
      std::swap(order[static_cast<std::size_t>(last)], order[other]);
    }
    rows[number] = order[static_cast<std::size_t>(sweep)];
  }
}

/// Cuts planes of this size into blocks of up to 512 columns, two at least from 256 columns on.
PlaneLayout plane_layout(int width, int length) {
  const auto whole_lines = [](int columns) { return (columns + 63) / 64 * 64; };
  PlaneLayout layout;
  layout.width = width;
  layout.length = length;
  const int wanted = width < 256 ? 1 : std::max(2, width / 512);
  layout.block_columns = whole_lines((width + wanted - 1) / wanted);
  layout.blocks = (width + layout.block_columns - 1) / layout.block_columns;
  // Never a power of two, or the rows of a block would crowd into a few sets of the processor's caches.
  layout.pitch = layout.block_columns + 64;
  layout.block_size = static_cast<std::size_t>(layout.pitch) * static_cast<std::size_t>(length);
  return layout;
}

/// Tiles are numbered up each block, then along the blocks.
int tile_rows_of(int length) { return std::max(1, length / tile_rows); }
SlideTile tile_number(int number, int length) {
  const int rows = tile_rows_of(length);
  const int row = number % rows;
  // The last tile takes the rows that are left over.
  return {number / rows, row * tile_rows, row + 1 == rows ? length : (row + 1) * tile_rows};
}

}  // namespace

ParallelExecutor::ParallelExecutor(const ExecutorOptions& options) : options_(options), team_(options.threads) {
  if (!std::has_single_bit(static_cast<unsigned>(options.sweeps)) || options.sweeps < 2 || options.sweeps > 64) {
    throw InputError("sweeps", std::to_string(options.sweeps) + " sub-sweeps a step", "use 2, 4, 8, 16, 32 or 64");
  }
}

StepReport ParallelExecutor::step(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) {
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  largest_step_ = std::max({law.bare.straight, law.covered.straight, law.bare.diagonal, law.covered.diagonal});
  if (loaded_ != &terrain || revision_ != terrain.revision()) {
    load(terrain, frame);
  } else if (!frame_.same_axes(frame)) {
    settle(terrain);
    load(terrain, frame);
  }
  frame_ = frame;
  if (narrow_ != narrow_fits(narrow_ ? highest_ : highest_ + highest_ / 8)) change_lanes(!narrow_);
  prepare_walls(law);

  Progress progress;
  progress.law = &law;
  progress.key = key;
  progress.highest = highest_;
  const auto sweep = [&]<typename Lane>(Lane) {
    load_cover<Lane>(law);
    prepare_hops<Lane>(law, wind.strength);
    return sweep_until_done<Lane>(progress);
  };
  while (!(narrow_ ? sweep(std::uint8_t{}) : sweep(std::uint16_t{}))) change_lanes(false);
  highest_ = progress.highest;

  const SweepCounts& counts = progress.counts;
  mobile_total_ += counts.slabs_in - counts.slabs_out;
  terrain.ledger().in += counts.slabs_in;
  terrain.ledger().out += counts.slabs_out;
  StepReport report;
  report.polls = counts.polls;
  report.lifts = counts.lifts;
  report.travel = static_cast<double>(counts.rows_flown) / frame_.cosine;
  report.slabs_in = counts.slabs_in;
  report.slabs_out = counts.slabs_out;
  return report;
}

// --- terrain in and out
// -------------------------------------------------------------------------------------------------

void ParallelExecutor::load(const Terrain& terrain, const WindFrame& frame) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  frame_ = frame;
  layout_ = plane_layout(frame.width, frame.length);
  open_ = terrain.boundary() == Boundary::open;
  base_ = check_height(terrain);
  relief_ = false;
  highest_ = 0;
  bedrock_total_ = 0;
  mobile_total_ = 0;
  for (std::size_t cell = 0; cell < mobile.size(); ++cell) {
    relief_ = relief_ || bedrock[cell] != base_;
    highest_ = std::max(highest_, bedrock[cell] - base_ + mobile[cell]);
    bedrock_total_ += bedrock[cell];
    mobile_total_ += mobile[cell];
  }
  narrow_ = narrow_fits(highest_);
  if (narrow_) {
    load_heights<std::uint8_t>(terrain);
  } else {
    load_heights<std::uint16_t>(terrain);
  }
  cover_loaded_ = false;
  loaded_ = &terrain;
  revision_ = terrain.revision();
}

/// Calls visit(cell of the frame's plane, cell of the terrain) for all cells, in blocks that suit both orders of
/// memory.
template <typename Visit>
void ParallelExecutor::visit_cells(const Visit& visit) {
  constexpr int block_rows = 16;
  const int blocks = (frame_.length + block_rows - 1) / block_rows;
  team_.run([&](int member) {
    for (int block = member; block < blocks; block += team_.size()) {
      const int first = block * block_rows;
      const int end = std::min(frame_.length, first + block_rows);
      for (int u = 0; u < frame_.width; ++u) {
        const std::size_t column = layout_.at(u / layout_.block_columns, u % layout_.block_columns, 0);
        for (int v = first; v < end; ++v) {
          const std::size_t row = static_cast<std::size_t>(v) * static_cast<std::size_t>(layout_.pitch);
          visit(column + row, frame_.cell(u, v));
        }
      }
    }
  });
}

template <typename Lane>
void ParallelExecutor::load_heights(const Terrain& terrain) {
  Planes<Lane>& mine = planes<Lane>();
  mine.before.resize(layout_.block_size * static_cast<std::size_t>(layout_.blocks));
  mine.after.resize(layout_.block_size * static_cast<std::size_t>(layout_.blocks));
  mine.bedrock.resize(relief_ ? layout_.block_size * static_cast<std::size_t>(layout_.blocks) : 0);
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  visit_cells([&](std::size_t here, std::size_t there) {
    mine.before[here] = static_cast<Lane>(bedrock[there] + mobile[there] - base_);
    if (relief_) mine.bedrock[here] = static_cast<Lane>(bedrock[there] - base_);
  });
}

void ParallelExecutor::settle(Terrain& terrain) {
  if (loaded_ != &terrain || revision_ != terrain.revision()) return;
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  const auto write = [&](const auto& mine) {
    visit_cells([&](std::size_t here, std::size_t there) {
      mobile[there] = mine.before[here] - (relief_ ? mine.bedrock[here] : 0);
    });
  };
  if (narrow_) {
    write(narrow_planes_);
  } else {
    write(wide_planes_);
  }
  revision_ = terrain.revision();
}

void ParallelExecutor::change_lanes(bool narrow) {
  const auto convert = [](const auto& from, auto& to) {
    to.before.assign(from.before.begin(), from.before.end());
    to.after.resize(from.after.size());
    to.bedrock.assign(from.bedrock.begin(), from.bedrock.end());
  };
  if (narrow) {
    convert(wide_planes_, narrow_planes_);
    wide_planes_ = {};
  } else {
    convert(narrow_planes_, wide_planes_);
    narrow_planes_ = {};
  }
  narrow_ = narrow;
  cover_loaded_ = false;
}

// --- what the law means on this grid
// ------------------------------------------------------------------------------------

template <typename Lane>
void ParallelExecutor::load_cover(const SlabLaw& law) {
  if (law.cover == nullptr) {
    cover_.clear();
    cover_loaded_ = false;
    planes<Lane>().steps.clear();
    planes<Lane>().diagonal_steps.clear();
    return;
  }
  if (cover_loaded_ && cover_revision_ == law.cover_revision) return;
  const auto cover = law.cover->cells();
  cover_.resize(layout_.block_size * static_cast<std::size_t>(layout_.blocks));
  visit_cells([&](std::size_t here, std::size_t there) { cover_[here] = cover[there]; });

  Planes<Lane>& mine = planes<Lane>();
  const auto lay_steps = [&](AlignedVector<Lane>& steps, int bare, int covered) {
    steps.resize(bare == covered ? 0 : cover_.size());
    for (std::size_t cell = 0; cell < steps.size(); ++cell) {
      steps[cell] = static_cast<Lane>(cover_[cell] >= law.covered_from ? covered : bare);
    }
  };
  lay_steps(mine.steps, law.bare.straight, law.covered.straight);
  lay_steps(mine.diagonal_steps, law.bare.diagonal, law.covered.diagonal);
  cover_revision_ = law.cover_revision;
  cover_loaded_ = true;
}

/// Marks the rows whose bedrock may stop a slab: only where it stands higher than a step over the lowest ground.
void ParallelExecutor::prepare_walls(const SlabLaw& law) {
  if (!law.obstacles || !relief_) {
    wall_rows_.clear();
    return;
  }
  wall_rows_.assign(static_cast<std::size_t>(frame_.length), 0);
  const auto mark = [&](const auto& bedrock) {
    for (int block = 0; block < layout_.blocks; ++block) {
      for (int v = 0; v < frame_.length; ++v) {
        const auto row = bedrock.begin() + static_cast<std::ptrdiff_t>(layout_.at(block, 0, v));
        if (*std::max_element(row, row + layout_.columns_of(block)) > law.bare.straight) {
          wall_rows_[static_cast<std::size_t>(v)] = 1;
        }
      }
    }
  };
  if (narrow_) {
    mark(narrow_planes_.bedrock);
  } else {
    mark(wide_planes_.bedrock);
  }
}

/// Fills the table of hops in rows * 256, one entry for each height over the base (or one for all).
template <typename Lane>
void ParallelExecutor::prepare_hops(const SlabLaw& law, double strength) {
  const auto rows_256 = [&](double above_reference) {
    const double rows = law.hop.cells(strength, above_reference) * frame_.cosine;
    return static_cast<std::uint32_t>(std::max<std::int64_t>(1 << fixed_point_bits, fixed_point(rows)));
  };
  if (!law.hop.depends_on_height()) {
    hop_table_.assign(1, rows_256(0));
    return;
  }
  const double mean = static_cast<double>(bedrock_total_ + mobile_total_) / static_cast<double>(cells()) - base_;
  const double deviation = law.hop.deviation_weight != 0 ? mean_deviation<Lane>(mean) : 0;
  const double reference = mean - law.hop.deviation_weight * deviation;
  hop_table_.resize(std::size_t{1} << (8 * sizeof(Lane)));
  for (std::size_t height = 0; height < hop_table_.size(); ++height) {
    hop_table_[height] = rows_256(static_cast<double>(height) - reference);
  }
}

/// Mean of |h - mean| over the cells, from counts of heights: the same sum on any number of threads.
template <typename Lane>
double ParallelExecutor::mean_deviation(double mean) {
  const AlignedVector<Lane>& heights = planes<Lane>().before;
  std::vector<std::vector<std::int64_t>> counts(static_cast<std::size_t>(team_.size()));
  team_.run([&](int member) {
    std::vector<std::int64_t>& mine = counts[static_cast<std::size_t>(member)];
    mine.assign(static_cast<std::size_t>(highest_) + 1, 0);
    const auto [first, end] = share(frame_.length, member);
    for (int block = 0; block < layout_.blocks; ++block) {
      for (int v = first; v < end; ++v) {
        const Lane* row = heights.data() + layout_.at(block, 0, v);
        for (int u = 0; u < layout_.columns_of(block); ++u) ++mine[row[u]];
      }
    }
  });
  double sum = 0;
  for (std::size_t height = 0; height <= static_cast<std::size_t>(highest_); ++height) {
    std::int64_t count = 0;
    for (const auto& mine : counts) count += mine[height];
    sum += static_cast<double>(count) * std::abs(static_cast<double>(height) - mean);
  }
  return sum / static_cast<double>(cells());
}

/// Cuts the lines into strips, one or more for each member, with rings of this many rows.
template <typename Lane>
void ParallelExecutor::prepare_strips(int ring_rows) {
  Planes<Lane>& mine = planes<Lane>();
  const int lines_each = (frame_.width + team_.size() - 1) / team_.size();
  const int lines = std::min(strip_lines, (lines_each + 63) / 64 * 64);
  const auto count = static_cast<std::size_t>((frame_.width + lines - 1) / lines);
  const std::size_t ring = static_cast<std::size_t>(ring_rows) * strip_lines;
  if (mine.strips.size() != count) mine.strips = std::vector<Strip<Lane>>(count);
  if (mine.rings.size() != ring * count) mine.rings.assign(ring * count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    Strip<Lane>& strip = mine.strips[k];
    strip.first = static_cast<int>(k) * lines;
    strip.lines = std::min(lines, frame_.width - strip.first);
    strip.ring = mine.rings.data() + ring * k;
  }
}

/// Rows of ring that hold the longest hop from ground up to `highest`: a power of two.
int ParallelExecutor::ring_rows(int highest) const {
  const std::size_t heights = std::min(hop_table_.size(), static_cast<std::size_t>(highest) + 1);
  const std::uint32_t longest =
      *std::max_element(hop_table_.begin(), hop_table_.begin() + static_cast<std::ptrdiff_t>(heights));
  return static_cast<int>(std::bit_ceil((longest >> fixed_point_bits) + 2));
}

// --- sub-sweeps
// ---------------------------------------------------------------------------------------------------------

bool ParallelExecutor::goes_on(const Progress& progress) const {
  if (!progress.law->forced_erosion) return progress.sweep < options_.sweeps;
  return progress.counts.lifts < cells() && progress.idle < idle_rounds * options_.sweeps;
}

/// Runs sub-sweeps until the step is done; false if 8-bit lanes cannot hold the next one, which then has left no trace.
template <typename Lane>
bool ParallelExecutor::sweep_until_done(Progress& progress) {
  Planes<Lane>& mine = planes<Lane>();
  while (goes_on(progress)) {
    const int rows = ring_rows(progress.highest);
    prepare_strips<Lane>(rows);
    const Progress start = progress;
    bool crowded = false;
    team_.run([&](int member) {
      const Progress end = sweep_as_member<Lane>(member, start, rows);
      if (member != 0) return;
      progress = end;
      crowded = end.crowded;
    });
    if ((progress.sweep - start.sweep) % 2 != 0) std::swap(mine.before, mine.after);
    if (crowded) {
      progress.crowded = false;
      std::fill(mine.rings.begin(), mine.rings.end(), Lane{0});
      return false;
    }
  }
  return true;
}

/// One member's part of the sub-sweeps to come, until the step is done, the rings are too short or a place is too
/// crowded. Every member keeps the same account, so that all leave the loop together.
template <typename Lane>
ParallelExecutor::Progress ParallelExecutor::sweep_as_member(int member, Progress progress, int rows) {
  Planes<Lane>& mine = planes<Lane>();
  const SweepKernels<Lane>& kernels = sweep_kernels<Lane>(options_.instructions);
  const auto [first_strip, end_strip] = share(static_cast<int>(mine.strips.size()), member);
  Lane* before = mine.before.data();
  Lane* after = mine.after.data();
  std::vector<std::uint8_t> polled_rows;
  while (goes_on(progress) && ring_rows(progress.highest) <= rows) {
    SweepPlan<Lane> plan = sweep_plan<Lane>(progress, polled_rows);
    plan.before = before;
    plan.after = after;
    plan.ring_rows = rows;
    for (int k = first_strip; k < end_strip; ++k) kernels.convey(plan, mine.strips[static_cast<std::size_t>(k)]);
    team_.meet();
    for (int k = first_strip; k < end_strip; ++k) {
      Strip<Lane>& strip = mine.strips[static_cast<std::size_t>(k)];
      if (!plan.open && !strip.counts.crowded) kernels.carry(plan, strip);
    }
    team_.meet();
    const SweepCounts counts = summed(mine.strips);
    const int bound = progress.highest + static_cast<int>(counts.most_landed + counts.most_carried);
    if (counts.crowded || (sizeof(Lane) == 1 && !narrow_fits(bound))) {
      progress.crowded = true;
      break;
    }
    slide<Lane>(kernels, slide_plan<Lane>(progress, after), member);
    take_account(progress, counts, bound);
    std::swap(before, after);
  }
  return progress;
}

void ParallelExecutor::take_account(Progress& progress, const SweepCounts& counts, int bound) {
  progress.counts.polls += counts.polls;
  progress.counts.lifts += counts.lifts;
  progress.counts.rows_flown += counts.rows_flown;
  progress.counts.slabs_in += counts.slabs_in;
  progress.counts.slabs_out += counts.slabs_out;
  progress.highest = std::min(bound, static_cast<int>(counts.highest + counts.most_carried));
  progress.idle = counts.lifts > 0 ? 0 : progress.idle + 1;
  ++progress.sweep;
}

template <typename Lane>
SweepCounts ParallelExecutor::summed(const std::vector<Strip<Lane>>& strips) {
  SweepCounts sum;
  for (const Strip<Lane>& strip : strips) {
    const SweepCounts& counts = strip.counts;
    sum.polls += counts.polls;
    sum.lifts += counts.lifts;
    sum.rows_flown += counts.rows_flown;
    sum.slabs_in += counts.slabs_in;
    sum.slabs_out += counts.slabs_out;
    sum.highest = std::max(sum.highest, counts.highest);
    sum.most_landed = std::max(sum.most_landed, counts.most_landed);
    sum.most_carried = std::max(sum.most_carried, counts.most_carried);
    sum.crowded = sum.crowded || counts.crowded;
  }
  return sum;
}

/// Slides inside tiles, then over the seams between the rows of tiles, then over those between columns of tiles. A
/// member's tiles stand in the columns of its strips, so that (on a straight wind) what it conveyed is still near.
template <typename Lane>
void ParallelExecutor::slide(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member) {
  const int length = plan.layout.length;
  const int blocks = plan.layout.blocks;
  const auto [first, end] = share(blocks * tile_rows_of(length), member);
  for (int k = first; k < end; ++k) kernels.slide_tile(plan, tile_number(k, length));
  // Where members hold whole blocks, the seams inside them wait for nobody.
  if (blocks % team_.size() != 0) team_.meet();
  for (int k = first; k < end; ++k) {
    const SlideTile tile = tile_number(k, length);
    if (tile.end_row < length || (!plan.open && length > 2)) kernels.slide_row_seam(plan, tile);
  }
  team_.meet();
  const auto [first_block, end_block] = share(blocks, member);
  for (int block = first_block; block < end_block; ++block) {
    const bool closes = block + 1 == blocks;
    if (!closes || (!plan.open && plan.layout.width > 2))
      kernels.slide_column_seam(plan, block, closes ? 0 : block + 1);
  }
  team_.meet();
}

/// The part [first, end) of `count` things that falls to a member.
std::pair<int, int> ParallelExecutor::share(int count, int member) const {
  const auto part = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(count) * k / team_.size()); };
  return {part(member), part(member + 1)};
}

template <typename Lane>
SweepPlan<Lane> ParallelExecutor::sweep_plan(const Progress& progress, std::vector<std::uint8_t>& polled_rows) const {
  const SlabLaw& law = *progress.law;
  const Planes<Lane>& mine = planes<Lane>();
  const int round = progress.sweep / options_.sweeps;
  const auto sweep = static_cast<std::uint64_t>(progress.sweep);
  SweepPlan<Lane> plan;
  plan.layout = layout_;
  plan.bedrock = mine.bedrock.empty() ? nullptr : mine.bedrock.data();
  plan.cover = cover_.empty() ? nullptr : cover_.data();
  plan.wall_rows = wall_rows_.empty() ? nullptr : wall_rows_.data();
  plan.open = open_;
  plan.sweep_word = random_word(progress.key, sweep, 0, decisions);
  plan.sweeps = options_.sweeps;
  // Non-repeated polling cuts the lines into blocks for a whole round of K sub-sweeps, so it keeps its lines that long.
  const std::uint64_t line_age = law.repeated_polling ? sweep : static_cast<std::uint64_t>(round) << 32;
  plan.poll_word = random_word(progress.key, line_age, 0, polls);
  if (!law.repeated_polling) {
    permuted_rows(progress.key, round, progress.sweep % options_.sweeps, options_.sweeps, polled_rows);
    plan.polled_row = polled_rows.data();
  }
  if (frame_.tangent > 0) {
    plan.oblique = true;
    const auto tangent_24 = static_cast<std::int64_t>(frame_.tangent * 0x1p24);
    plan.drift = (frame_.length * tangent_24 + random_below(progress.key, line_age, 0, lines, 1u << 24)) >> 24;
    plan.phase = random_below(progress.key, line_age, 1, lines, static_cast<std::uint32_t>(frame_.length));
  }
  plan.p_sand_16 = static_cast<std::uint32_t>(std::llround(law.p_sand * 65536));
  plan.p_bare_16 = static_cast<std::uint32_t>(std::llround(law.p_bare * 65536));
  plan.lift_in_shadow = law.erode_in_shadow;
  const std::int64_t steepest = sizeof(Lane) == 1 ? 0xffff : 0xffffffff;
  plan.row_fall =
      static_cast<std::uint32_t>(std::clamp<std::int64_t>(fixed_point(law.shadow_fall / frame_.cosine), 1, steepest));
  plan.adjacent_fall = static_cast<std::uint32_t>(std::clamp<std::int64_t>(fixed_point(law.shadow_fall), 1, steepest));
  plan.warm_up = (progress.highest << fixed_point_bits) / static_cast<int>(plan.row_fall) + 2;
  plan.wall_step = law.bare.straight;
  plan.hop_by_height = hop_table_.size() > 1;
  plan.hop_table = hop_table_.data();
  if (open_ && progress.sweep < options_.sweeps) plan.inflow = law.inflow / options_.sweeps;
  return plan;
}

template <typename Lane>
SlidePlan<Lane> ParallelExecutor::slide_plan(const Progress& progress, Lane* heights) const {
  const SlabLaw& law = *progress.law;
  const Planes<Lane>& mine = planes<Lane>();
  SlidePlan<Lane> plan;
  plan.layout = layout_;
  plan.heights = heights;
  plan.bedrock = mine.bedrock.empty() ? nullptr : mine.bedrock.data();
  plan.steps = mine.steps.empty() ? nullptr : mine.steps.data();
  plan.diagonal_steps = mine.diagonal_steps.empty() ? nullptr : mine.diagonal_steps.data();
  plan.step = law.bare.straight;
  plan.diagonal_step = law.bare.diagonal;
  plan.diagonals = law.neighbours == 8;
  plan.open = open_;
  const std::uint32_t classes = plan.diagonals ? 8 : 4;
  for (std::uint32_t k = 0; k < classes; ++k) plan.order[k] = static_cast<std::uint8_t>(k);
  for (std::uint32_t last = classes - 1; last > 0; --last) {
    const auto sweep = static_cast<std::uint64_t>(progress.sweep);
    std::swap(plan.order[last], plan.order[random_below(progress.key, sweep, last, slide_order, last + 1)]);
  }
  return plan;
}

}  // namespace erg
