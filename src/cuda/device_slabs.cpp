#include "cuda/device_slabs.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace erg {
// --- in and out ---

void DeviceSlabs::allocate(const Terrain& terrain) {
  const auto count = terrain.extent().cells();
  const auto longest_side = static_cast<std::size_t>(std::max(terrain.nx(), terrain.ny()));
  const auto block = static_cast<std::size_t>(sweeps_ / 2);
  const std::size_t most_aloft = (count + block - 1) / block + longest_side;  // a slab for each poll of a sub-sweep
  device_.fit(before_, count);
  device_.fit(after_, count);
  device_.fit(bedrock_, relief_ ? count : 0);
  device_.fit(cover_, cover_.size() > 0 ? count : 0);
  device_.fit(dark_, count);
  device_.fit(staged_, count);
  device_.fit(shown_, count);
  device_.fit(bands_changed_, (count + band_cells - 1) / band_cells);
  device_.fit(aloft_, open_ ? 0 : most_aloft);
  device_.fit(first_aloft_, longest_side);
  device_.fit(aloft_count_, 1);
  device_.fit(highest_, 2);
  device_.fit(hop_table_, device_heights);
  device_.fit(height_counts_, device_heights);
  device_.fit(tally_, static_cast<std::size_t>(tally_slots) * tallies);
  device_.fill(first_aloft_.data(), 0xff, first_aloft_.bytes());
}

void DeviceSlabs::load(const Terrain& terrain, const WindFrame& frame) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  const TerrainHeights heights = check_height(terrain);
  frame_ = frame;
  open_ = terrain.boundary() == Boundary::open;
  base_ = heights.lowest;
  relief_ = heights.relief;
  bedrock_total_ = heights.bedrock_total;
  mobile_total_ = heights.mobile_total;
  allocate(terrain);
  DevicePlan plan = layout();
  device_.send_each(shown_, [&](std::size_t cell) { return bedrock[cell] + mobile[cell] - base_; });
  plan.staged = shown_.data();
  device_.launch(DeviceKernel::lay_surface, cells(), plan);
  if (relief_) {
    plan.staged = staged_.data();
    device_.send_each(staged_, [&](std::size_t cell) { return bedrock[cell] - base_; });
    device_.launch(DeviceKernel::lay_bedrock, cells(), plan);
  }
  const std::uint32_t bounds[2] = {static_cast<std::uint32_t>(heights.highest), 0};
  device_.send(highest_.data(), bounds, 2);
  current_ = 0;
  cover_stamp_ = 0;
}

void DeviceSlabs::turn(const WindFrame& frame) {
  const DevicePlan from = layout();
  frame_ = frame;
  const DevicePlan to = layout();
  device_.launch(DeviceKernel::stage_surface, cells(), from);
  device_.launch(DeviceKernel::lay_surface, cells(), to);
  if (relief_) {
    device_.launch(DeviceKernel::stage_bedrock, cells(), from);
    device_.launch(DeviceKernel::lay_bedrock, cells(), to);
  }
  cover_stamp_ = 0;
}

void DeviceSlabs::settle(Terrain& terrain) {
  device_.fill(bands_changed_.data(), 0, bands_changed_.bytes());
  device_.launch(DeviceKernel::show_surface, cells(), layout());
  const std::vector<std::uint32_t> changed = device_.fetch(bands_changed_.data(), bands_changed_.size());
  struct Run {
    std::size_t first_cell;
    std::vector<std::int32_t> surface;
  };
  std::vector<Run> runs;
  for (std::size_t band = 0; band < changed.size(); ++band) {
    if (changed[band] == 0) continue;
    const std::size_t first = band * band_cells;
    while (band + 1 < changed.size() && changed[band + 1] != 0) ++band;
    const std::size_t end = std::min(shown_.size(), (band + 1) * band_cells);
    runs.push_back({first, device_.fetch(shown_.data() + first, end - first)});
  }
  // Only now that nothing can fail any more: the layers must not be half new.
  const auto bedrock = terrain.bedrock().cells();
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (const Run& run : runs) {
    for (std::size_t k = 0; k < run.surface.size(); ++k) {
      mobile[run.first_cell + k] = run.surface[k] + base_ - bedrock[run.first_cell + k];
    }
  }
}

void DeviceSlabs::count_lifts(bool wanted) {
  const std::size_t count = wanted ? before_.size() : 0;
  if (lift_counts_.size() == count) return;
  device_.fit(lift_counts_, count);
  if (wanted) device_.fill(lift_counts_.data(), 0, lift_counts_.bytes());
}

void DeviceSlabs::take_lift_counts(Grid<std::int32_t>& counts) {
  const std::vector<std::int32_t> lifts = device_.fetch(lift_counts_.data(), lift_counts_.size());
  device_.fill(lift_counts_.data(), 0, lift_counts_.bytes());
  for (std::size_t cell = 0; cell < lifts.size(); ++cell) counts[cell] += lifts[cell];
}

// --- what the law means on this grid ---

DevicePlan DeviceSlabs::layout() const {
  DevicePlan plan;
  plan.width = frame_.width;
  plan.length = frame_.length;
  plan.open = open_;
  plan.before = before_.data();
  plan.after = after_.data();
  plan.bedrock = bedrock_.data();
  plan.cover = cover_.data();
  plan.dark = dark_.data();
  plan.hop_table = hop_table_.data();
  plan.height_counts = height_counts_.data();
  plan.first_aloft = first_aloft_.data();
  plan.aloft = aloft_.data();
  plan.aloft_count = aloft_count_.data();
  plan.tally = tally_.data();
  plan.order = terrain_order(frame_);
  plan.staged = staged_.data();
  plan.shown = shown_.data();
  plan.bands_changed = bands_changed_.data();
  plan.lift_counts = lift_counts_.data();
  return plan;
}

void DeviceSlabs::load_cover(const SlabLaw& law) {
  if (law.cover == nullptr) {
    cover_ = DeviceArray<std::uint8_t>();
    cover_stamp_ = 0;
    return;
  }
  if (cover_stamp_ == law.cover->stamp()) return;
  device_.fit(cover_, dark_.size());
  const auto cover = (*law.cover)->cells();
  device_.copy_in(staged_.data(), cover.size(), [&](std::byte* target, std::size_t first, std::size_t bytes) {
    std::memcpy(target, cover.data() + first, bytes);
  });
  device_.launch(DeviceKernel::lay_cover, cells(), layout());
  cover_stamp_ = law.cover->stamp();
}

/// Mean of |h - mean| over the cells, from counts of heights: the same sum as on the processor.
double DeviceSlabs::mean_deviation(const DevicePlan& plan, double mean) {
  const std::uint32_t highest = device_.fetch(highest_.data(), 2)[static_cast<std::size_t>(current_)];
  const std::size_t heights = std::min<std::size_t>(highest, device_heights - 1) + 1;
  device_.fill(height_counts_.data(), 0, heights * sizeof(std::uint32_t));
  device_.launch(DeviceKernel::count_heights, cells(), plan);
  const std::vector<std::uint32_t> counts = device_.fetch(height_counts_.data(), heights);
  double sum = 0;
  for (std::size_t height = 0; height < heights; ++height) {
    sum += static_cast<double>(counts[height]) * std::abs(static_cast<double>(height) - mean);
  }
  return sum / static_cast<double>(cells());
}

void DeviceSlabs::prepare_hops(DevicePlan& plan, const SlabLaw& law, double strength, StepKey key) {
  plan.hop_by_height = law.hop.depends_on_height();
  plan.hop = {strength,      law.hop.linear,    law.hop.quadratic,
              frame_.cosine, hop_rounding(key), most_hop_rows(strength, frame_.cosine, frame_.length)};
  if (plan.hop_by_height) {
    const double mean = static_cast<double>(bedrock_total_ + mobile_total_) / static_cast<double>(cells()) - base_;
    const double deviation = law.hop.deviation_weight != 0 ? mean_deviation(plan, mean) : 0;
    plan.hop_reference = mean - law.hop.deviation_weight * deviation;
  }
  device_.launch(DeviceKernel::fill_hop_table, plan.hop_by_height ? device_heights : 1, plan);
}

DevicePlan DeviceSlabs::step_plan(const SlabLaw& law, double strength, StepKey key) {
  load_cover(law);
  DevicePlan plan = layout();
  plan.walls = law.obstacles && relief_;
  plan.covered_from = law.covered_from;
  plan.tiles = plane_layout(frame_, open_);
  prepare_hops(plan, law, strength, key);
  return plan;
}

// --- steps ---

StepReport DeviceSlabs::step(const SlabLaw& law, const WindFrame& frame, double strength, StepKey key) {
  if (!frame_.same_axes(frame)) turn(frame);
  frame_ = frame;
  DevicePlan plan = step_plan(law, strength, key);
  device_.fill(tally_.data(), 0, tally_.bytes());
  SlabCounts counts;
  StepAccount account;
  while (goes_on(law, account, cells(), sweeps_)) {
    if (!law.repeated_polling && account.sweep % sweeps_ == 0) polled_rows_.draw(key, account.sweep, sweeps_);
    plan.sweep = sub_sweep(law, frame_, open_, key, account, sweeps_, polled_rows_);
    sweep(plan);
    slide(plan, law);
    std::swap(before_, after_);
    std::swap(plan.before, plan.after);
    current_ = 1 - current_;
    if (law.forced_erosion) counts = read_counts(device_, tally_);  // else nobody asks
    account.book(plan.sweep, counts.of[tally_lifts] - account.lifts);
  }
  counts = read_counts(device_, tally_);
  mobile_total_ += counts.of[tally_in] - counts.of[tally_out];
  StepReport report;
  report.polls = counts.of[tally_polls];
  report.lifts = counts.of[tally_lifts];
  report.travel = static_cast<double>(counts.of[tally_rows]) / frame_.cosine;
  report.slabs_in = counts.of[tally_in];
  report.slabs_out = counts.of[tally_out];
  return report;
}

/// One sub-sweep without its slides.
void DeviceSlabs::sweep(DevicePlan plan) {
  plan.highest = highest_.data() + current_;
  plan.next_highest = highest_.data() + (1 - current_);
  const std::int64_t pieces = (plan.length + shadow_rows - 1) / shadow_rows;
  const std::int64_t blocks = (plan.length + poll_rows(plan.sweep) - 1) / poll_rows(plan.sweep);
  device_.launch(DeviceKernel::cast_shadow, pieces * plan.width, plan);
  if (plan.sweep.inflow > 0) device_.launch(DeviceKernel::let_in, plan.width + plan.length - 1, plan);
  device_.launch(DeviceKernel::lift, blocks * plan.width, plan);
  if (!plan.open) device_.launch(DeviceKernel::carry, plan.width, plan);
}

/// Slides inside tiles, class by class, then over the seams between tiles.
void DeviceSlabs::slide(DevicePlan plan, const SlabLaw& law) {
  const auto choose = [&](EdgeClass edges) {
    const bool diagonal = is_diagonal(edges);
    plan.edges = edges;
    plan.stands = std::min(diagonal ? law.bare.diagonal : law.bare.straight, longest_step);
    plan.stands_covered = std::min(diagonal ? law.covered.diagonal : law.covered.straight, longest_step);
  };
  for (int k = 0; k < plan.sweep.edge_classes; ++k) {
    choose(static_cast<EdgeClass>(plan.sweep.order[k]));
    device_.launch(DeviceKernel::slide_tiles, (cells() + plan.width + plan.length) / 2, plan);
  }
  const bool diagonals = plan.sweep.edge_classes == 8;
  for (const EdgeClass edges : {along_even, rising_even, falling_even}) {
    if (is_diagonal(edges) && !diagonals) continue;
    choose(edges);
    device_.launch(DeviceKernel::slide_row_seams, std::int64_t{plan.width} * (plan.length / tile_rows + 1), plan);
  }
  for (const EdgeClass edges : {across_even, along_even, rising_even, falling_even}) {
    if (is_diagonal(edges) ? !diagonals : edges == along_even && plan.tiles.lean == 0) continue;
    choose(edges);
    device_.launch(DeviceKernel::slide_column_seams, std::int64_t{plan.length} * plan.tiles.blocks, plan);
  }
  for (const EdgeClass edges : {rising_even, falling_even}) {
    if (!diagonals || plan.tiles.lean == 0 || plan.length < 2) continue;
    choose(edges);
    device_.launch(DeviceKernel::slide_corners, plan.tiles.blocks, plan);
  }
}

}  // namespace erg
