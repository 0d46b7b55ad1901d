#include "models/slab/on_device.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "models/slab/slab_kernels.h"
#include "models/slab/terrain_heights.h"

namespace erg::models {

using forcing::WindFrame;
using kernels::counted_in;
using kernels::counted_lifts;
using kernels::counted_out;
using kernels::step_counters;
using slab::Kernels;

// --- in and out ---

void SlabOnDevice::allocate(const Terrain& terrain) {
  const auto count = terrain.extent().cells();
  const auto longest_side = static_cast<std::size_t>(std::max(terrain.nx(), terrain.ny()));
  const auto block = static_cast<std::size_t>(sweeps_ / 2);
  const std::size_t most_aloft = (count + block - 1) / block + longest_side;  // a slab for each poll of a sub-sweep
  backend_.fit(before_, count);
  backend_.fit(after_, count);
  backend_.fit(bedrock_, relief_ ? count : 0);
  backend_.fit(cover_, cover_.size() > 0 ? count : 0);
  backend_.fit(dark_, count);
  backend_.fit(staged_, count);
  backend_.fit(shown_, count);
  backend_.fit(bands_changed_, (count + slab::band_cells - 1) / slab::band_cells);
  backend_.fit(aloft_, open_ ? 0 : most_aloft);
  backend_.fit(first_aloft_, longest_side);
  backend_.fit(aloft_count_, 1);
  backend_.fit(highest_, 2);
  backend_.fit(hop_table_, slab::hop_heights);
  backend_.fit(height_counts_, slab::hop_heights);
  backend_.fit(counters_, std::size_t{compute::counter_slots} * step_counters);
  backend_.fill(first_aloft_, 0xff);
}

void SlabOnDevice::load(const Terrain& terrain, const WindFrame& frame) {
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
  slab::Plan plan = layout();
  backend_.send_each(shown_, [&](std::size_t cell) { return bedrock[cell] + mobile[cell] - base_; });
  plan.staged = shown_.data();
  backend_.launch(Kernels::scatter_surface, cells(), plan);
  if (relief_) {
    plan.staged = staged_.data();
    backend_.send_each(staged_, [&](std::size_t cell) { return bedrock[cell] - base_; });
    backend_.launch(Kernels::scatter_bedrock, cells(), plan);
  }
  const std::uint32_t bounds[2] = {static_cast<std::uint32_t>(heights.highest), 0};
  backend_.send(highest_.data(), bounds, 2);
  current_ = 0;
  cover_stamp_ = 0;
}

void SlabOnDevice::turn(const WindFrame& frame) {
  const slab::Plan from = layout();
  frame_ = frame;
  const slab::Plan to = layout();
  backend_.launch(Kernels::gather_surface, cells(), from);
  backend_.launch(Kernels::scatter_surface, cells(), to);
  if (relief_) {
    backend_.launch(Kernels::gather_bedrock, cells(), from);
    backend_.launch(Kernels::scatter_bedrock, cells(), to);
  }
  cover_stamp_ = 0;
}

void SlabOnDevice::sync_to_host(Terrain& terrain) {
  backend_.fill(bands_changed_, 0);
  backend_.launch(Kernels::show_surface, cells(), layout());
  const std::vector<std::uint32_t> changed = backend_.fetch(bands_changed_.data(), bands_changed_.size());
  struct Run {
    std::size_t first_cell;
    std::vector<std::int32_t> surface;
  };
  std::vector<Run> runs;
  for (std::size_t band = 0; band < changed.size(); ++band) {
    if (changed[band] == 0) continue;
    const std::size_t first = band * slab::band_cells;
    while (band + 1 < changed.size() && changed[band + 1] != 0) ++band;
    const std::size_t end = std::min(shown_.size(), (band + 1) * slab::band_cells);
    runs.push_back({first, backend_.fetch(shown_.data() + first, end - first)});
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

void SlabOnDevice::count_lifts(bool wanted) {
  const std::size_t count = wanted ? before_.size() : 0;
  if (lift_counts_.size() == count) return;
  backend_.fit(lift_counts_, count);
  if (wanted) backend_.fill(lift_counts_, 0);
}

void SlabOnDevice::take_lift_counts(Grid<std::int32_t>& counts) {
  const std::vector<std::int32_t> lifts = backend_.fetch(lift_counts_.data(), lift_counts_.size());
  backend_.fill(lift_counts_, 0);
  for (std::size_t cell = 0; cell < lifts.size(); ++cell) counts[cell] += lifts[cell];
}

// --- what the law means on this grid ---

slab::Plan SlabOnDevice::layout() const {
  slab::Plan plan;
  plan.width = frame_.width;
  plan.length = frame_.length;
  plan.open = open_;
  plan.shadow_rows = std::min(backend_.rows_a_thread(), frame_.length);
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
  plan.counters = counters_.data();
  plan.order = kernels::terrain_order(frame_);
  plan.staged = staged_.data();
  plan.shown = shown_.data();
  plan.bands_changed = bands_changed_.data();
  plan.lift_counts = lift_counts_.data();
  return plan;
}

void SlabOnDevice::load_cover(const SlabLaw& law) {
  if (law.cover == nullptr) {
    cover_ = compute::Buffer<std::uint8_t>();
    cover_stamp_ = 0;
    kept_cover_.reset();
    return;
  }
  if (cover_stamp_ == law.cover->stamp()) return;
  backend_.fit(cover_, dark_.size());
  kept_cover_ = std::make_shared<const Cover>(*law.cover);
  const auto cover = (*law.cover)->cells();
  backend_.copy_in(staged_.data(), cover.size(), [&](std::byte* target, std::size_t first, std::size_t bytes) {
    std::memcpy(target, cover.data() + first, bytes);
  });
  backend_.launch(Kernels::scatter_cover, cells(), layout());
  cover_stamp_ = law.cover->stamp();
}

/// Mean of |h - mean| over the cells, from counts of heights: the same sum as on the processor.
double SlabOnDevice::mean_deviation(const slab::Plan& plan, double mean) {
  const std::uint32_t highest = backend_.fetch(highest_.data(), 2)[static_cast<std::size_t>(current_)];
  const std::size_t heights = std::min<std::size_t>(highest, slab::hop_heights - 1) + 1;
  backend_.fill(height_counts_.data(), 0, heights * sizeof(std::uint32_t));
  backend_.launch(Kernels::count_heights, cells(), plan);
  const std::vector<std::uint32_t> counts = backend_.fetch(height_counts_.data(), heights);
  double sum = 0;
  for (std::size_t height = 0; height < heights; ++height) {
    sum += static_cast<double>(counts[height]) * std::abs(static_cast<double>(height) - mean);
  }
  return sum / static_cast<double>(cells());
}

void SlabOnDevice::prepare_hops(slab::Plan& plan, const SlabLaw& law, double strength, StepKey key) {
  plan.hop_by_height = law.hop.depends_on_height();
  plan.hop = {strength,      law.hop.linear,    law.hop.quadratic,
              frame_.cosine, hop_rounding(key), most_hop_rows(strength, frame_.cosine, frame_.length)};
  if (plan.hop_by_height) {
    const double mean = static_cast<double>(bedrock_total_ + mobile_total_) / static_cast<double>(cells()) - base_;
    const double deviation = law.hop.deviation_weight != 0 ? mean_deviation(plan, mean) : 0;
    plan.hop_reference = mean - law.hop.deviation_weight * deviation;
  }
  backend_.launch(Kernels::fill_hop_table, plan.hop_by_height ? slab::hop_heights : 1, plan);
}

slab::Plan SlabOnDevice::step_plan(const SlabLaw& law, double strength, StepKey key) {
  load_cover(law);
  slab::Plan plan = layout();
  plan.walls = law.obstacles && relief_;
  plan.covered_from = law.covered_from;
  plan.tiles = plane_layout(frame_, open_);
  prepare_hops(plan, law, strength, key);
  return plan;
}

// --- steps ---

StepReport SlabOnDevice::step(Terrain&, const SlabLaw& law, const WindFrame& frame, double strength, StepKey key,
                              Grid<std::int32_t>* lift_counts) {
  count_lifts(lift_counts != nullptr);
  if (!frame_.same_axes(frame)) turn(frame);
  frame_ = frame;
  slab::Plan plan = step_plan(law, strength, key);
  backend_.fill(counters_, 0);
  kernels::StepCounters counts;
  StepAccount account;
  while (goes_on(law, account, cells(), sweeps_)) {
    if (!law.repeated_polling && account.sweep % sweeps_ == 0) polled_rows_.draw(key, account.sweep, sweeps_);
    plan.sweep = sub_sweep(law, frame_, open_, key, account, sweeps_, polled_rows_);
    sweep(plan);
    slide(plan, law);
    std::swap(before_, after_);
    std::swap(plan.before, plan.after);
    current_ = 1 - current_;
    if (law.forced_erosion) counts = backend_.read_counters<step_counters>(counters_);  // else nobody asks
    account.book(plan.sweep, counts.of[counted_lifts] - account.lifts);
  }
  counts = backend_.read_counters<step_counters>(counters_);
  if (lift_counts != nullptr) take_lift_counts(*lift_counts);
  mobile_total_ += counts.of[counted_in] - counts.of[counted_out];
  StepReport report;
  report.polls = counts.of[kernels::counted_polls];
  report.lifts = counts.of[counted_lifts];
  report.travel = static_cast<double>(counts.of[kernels::counted_rows]) / frame_.cosine;
  report.slabs_in = counts.of[counted_in];
  report.slabs_out = counts.of[counted_out];
  return report;
}

/// One sub-sweep without its slides.
void SlabOnDevice::sweep(slab::Plan plan) {
  plan.highest = highest_.data() + current_;
  plan.next_highest = highest_.data() + (1 - current_);
  const std::int64_t pieces = (plan.length + plan.shadow_rows - 1) / plan.shadow_rows;
  const std::int64_t blocks = (plan.length + poll_rows(plan.sweep) - 1) / poll_rows(plan.sweep);
  backend_.launch(Kernels::cast_shadow, pieces * plan.width, plan);
  if (plan.sweep.inflow > 0) backend_.launch(Kernels::let_in, plan.width + plan.length - 1, plan);
  backend_.launch(Kernels::lift, blocks * plan.width, plan);
  if (!plan.open) backend_.launch(Kernels::carry, plan.width, plan);
}

/// Slides inside tiles, class by class, then over the seams between tiles.
void SlabOnDevice::slide(slab::Plan plan, const SlabLaw& law) {
  const auto choose = [&](EdgeClass edges) {
    const bool diagonal = is_diagonal(edges);
    plan.edges = edges;
    plan.critical_step = std::min(diagonal ? law.bare.diagonal : law.bare.straight, longest_step);
    plan.critical_step_covered = std::min(diagonal ? law.covered.diagonal : law.covered.straight, longest_step);
  };
  for (int k = 0; k < plan.sweep.edge_classes; ++k) {
    choose(static_cast<EdgeClass>(plan.sweep.order[k]));
    backend_.launch(Kernels::slide_tiles, (cells() + plan.width + plan.length) / 2, plan);
  }
  const bool diagonals = plan.sweep.edge_classes == 8;
  for (const EdgeClass edges : {along_even, rising_even, falling_even}) {
    if (is_diagonal(edges) && !diagonals) continue;
    choose(edges);
    backend_.launch(Kernels::slide_row_seams, std::int64_t{plan.width} * (plan.length / tile_rows + 1), plan);
  }
  for (const EdgeClass edges : {across_even, along_even, rising_even, falling_even}) {
    if (is_diagonal(edges) ? !diagonals : edges == along_even && plan.tiles.lean == 0) continue;
    choose(edges);
    backend_.launch(Kernels::slide_column_seams, std::int64_t{plan.length} * plan.tiles.blocks, plan);
  }
  for (const EdgeClass edges : {rising_even, falling_even}) {
    if (!diagonals || plan.tiles.lean == 0 || plan.length < 2) continue;
    choose(edges);
    backend_.launch(Kernels::slide_corners, plan.tiles.blocks, plan);
  }
}

}  // namespace erg::models
