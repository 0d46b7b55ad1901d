#include "models/slab/on_device.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "models/slab/given.h"
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
  backend_.fit(staged_, count);
  backend_.fit(shown_, count);
  backend_.fit(bands_changed_, (count + slab::band_cells - 1) / slab::band_cells);
  backend_.fit(aloft_, longest_side + 1 + (open_ ? 0 : most_aloft));
  backend_.fit(numbers_, slab::highest_at + 2);
  backend_.fit(hop_table_, slab::hop_heights);
  backend_.fit(height_counts_, slab::hop_heights);
  backend_.fill(aloft_, 0xff);
  lay_bare_bed(relief_ || bed_.size() > 0);
}

/// Level bed words without cover, or none.
void SlabOnDevice::lay_bare_bed(bool wanted) {
  backend_.fit(bed_, wanted ? before_.size() : 0);
  if (wanted) backend_.fill(bed_, 0);
  covered_ = false;
  cover_stamp_ = 0;
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
  backend_.send(numbers_.data() + slab::highest_at, bounds, 2);
  current_ = 0;
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
  slab::give_grid(frame_, open_, plan.given);
  plan.given.shadow_rows = std::min(backend_.rows_a_thread(), frame_.length);
  plan.given.bedded = bed_.size() > 0 ? 1 : 0;
  plan.given.count_lifts = lift_counts_.size() > 0 ? 1 : 0;
  plan.before = before_.data();
  plan.after = after_.data();
  plan.bed = bed_.data();
  plan.numbers = numbers_.data();
  plan.aloft = aloft_.data();
  plan.hop_table = hop_table_.data();
  plan.lift_counts = lift_counts_.data();
  plan.staged = staged_.data();
  plan.shown = shown_.data();
  plan.bands_changed = bands_changed_.data();
  plan.height_counts = height_counts_.data();
  return plan;
}

void SlabOnDevice::drop_cover() {
  if (covered_ && relief_) {
    backend_.fill(staged_, 0);
    backend_.launch(Kernels::scatter_cover, cells(), layout());
  } else if (covered_) {
    lay_bare_bed(false);
  }
  covered_ = false;
  cover_stamp_ = 0;
  kept_cover_.reset();
}

void SlabOnDevice::load_cover(const SlabLaw& law) {
  if (law.cover == nullptr) return drop_cover();
  if (cover_stamp_ == law.cover->stamp()) return;
  if (bed_.size() == 0) lay_bare_bed(true);
  kept_cover_ = std::make_shared<const Cover>(*law.cover);
  const auto cover = (*law.cover)->cells();
  backend_.copy_in(staged_.data(), cover.size(), [&](std::byte* target, std::size_t first, std::size_t bytes) {
    std::memcpy(target, cover.data() + first, bytes);
  });
  backend_.launch(Kernels::scatter_cover, cells(), layout());
  covered_ = true;
  cover_stamp_ = law.cover->stamp();
}

/// Mean of |h - mean| over the cells, from counts of heights: the same sum as on the processor.
double SlabOnDevice::mean_deviation(const slab::Plan& plan, double mean) {
  const std::uint32_t highest =
      backend_.fetch(numbers_.data() + slab::highest_at, 2)[static_cast<std::size_t>(current_)];
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
  const HopCurve hop{strength,      law.hop.linear,    law.hop.quadratic,
                     frame_.cosine, hop_rounding(key), most_hop_rows(strength, frame_.cosine, frame_.length)};
  plan.given.hop_by_height = law.hop.depends_on_height() ? 1 : 0;
  plan.given.rows_256 = hop_rows_256(hop, 0);
  if (!law.hop.depends_on_height()) return;
  const double mean = static_cast<double>(bedrock_total_ + mobile_total_) / static_cast<double>(cells()) - base_;
  const double deviation = law.hop.deviation_weight != 0 ? mean_deviation(plan, mean) : 0;
  const slab::HopTable table(hop, mean - law.hop.deviation_weight * deviation);
  backend_.send_each(hop_table_, [&](std::size_t height) { return table.rows_256(height); });
}

slab::Plan SlabOnDevice::step_plan(const SlabLaw& law, double strength, StepKey key) {
  load_cover(law);
  slab::Plan plan = layout();
  plan.given.walls = law.obstacles && relief_ ? 1 : 0;
  plan.given.covered_from = law.cover != nullptr ? law.covered_from : 256;
  prepare_hops(plan, law, strength, key);
  return plan;
}

/// What kernels have counted since the step began.
kernels::StepCounters SlabOnDevice::read_counters() {
  kernels::StepCounters sums;
  const std::vector<std::uint32_t> words = backend_.fetch(numbers_.data(), slab::highest_at);
  for (std::size_t k = 0; k < words.size(); k += 2) {
    const std::uint64_t number = words[k] | std::uint64_t{words[k + 1]} << 32;
    sums.of[k / 2 % step_counters] += static_cast<std::int64_t>(number);
  }
  return sums;
}

// --- steps ---

StepReport SlabOnDevice::step(Terrain&, const SlabLaw& law, const WindFrame& frame, double strength, StepKey key,
                              Grid<std::int32_t>* lift_counts) {
  count_lifts(lift_counts != nullptr);
  if (!frame_.same_axes(frame)) turn(frame);
  frame_ = frame;
  slab::Plan plan = step_plan(law, strength, key);
  backend_.fill(numbers_.data(), 0, slab::highest_at * sizeof(std::uint32_t));
  kernels::StepCounters counts;
  StepAccount account;
  while (goes_on(law, account, cells(), sweeps_)) {
    if (!law.repeated_polling && account.sweep % sweeps_ == 0) polled_rows_.draw(key, account.sweep, sweeps_);
    const SubSweep drawn = sub_sweep(law, frame_, open_, key, account, sweeps_, polled_rows_);
    slab::give_sub_sweep(drawn, plan.given);
    plan.given.current_bound = current_;
    sweep(plan);
    slide(plan, law, drawn);
    std::swap(before_, after_);
    std::swap(plan.before, plan.after);
    current_ = 1 - current_;
    if (law.forced_erosion) counts = read_counters();  // else nobody asks
    account.book(drawn, counts.of[counted_lifts] - account.lifts);
  }
  counts = read_counters();
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
void SlabOnDevice::sweep(const slab::Plan& plan) {
  const slab::Given& given = plan.given;
  const std::int64_t pieces = (given.rows + given.shadow_rows - 1) / given.shadow_rows;
  const std::int64_t blocks = (given.rows + given.poll_rows - 1) / given.poll_rows;
  backend_.launch(Kernels::cast_shadow, pieces * given.width, plan);
  if (given.inflow > 0 || given.inflow_from <= 0xffff) {
    backend_.launch(Kernels::let_in, given.width + given.rows - 1, plan);
  }
  backend_.launch(Kernels::lift, blocks * given.width, plan);
  if (!open_) backend_.launch(Kernels::wrap_pass, given.width, plan);
}

/// Slides inside tiles, class by class, then over the borders between tiles.
void SlabOnDevice::slide(slab::Plan plan, const SlabLaw& law, const SubSweep& drawn) {
  const slab::Given& given = plan.given;
  const auto choose = [&](EdgeClass edges) {
    const bool diagonal = is_diagonal(edges);
    const auto stands = [&](const ReposeSteps& steps) {
      return static_cast<std::uint32_t>(std::min(diagonal ? steps.diagonal : steps.straight, longest_step));
    };
    plan.given.edges = edges;
    plan.given.critical_step = stands(law.bare);
    plan.given.critical_step_covered = stands(law.covered);
  };
  for (int k = 0; k < drawn.edge_classes; ++k) {
    choose(static_cast<EdgeClass>(drawn.order[k]));
    backend_.launch(Kernels::slide_tiles, (cells() + given.width + given.rows) / 2, plan);
  }
  const bool diagonals = drawn.edge_classes == 8;
  for (const EdgeClass edges : {along_even, rising_even, falling_even}) {
    if (is_diagonal(edges) && !diagonals) continue;
    choose(edges);
    backend_.launch(Kernels::slide_row_borders, std::int64_t{given.width} * (given.rows / tile_rows + 1), plan);
  }
  for (const EdgeClass edges : {across_even, along_even, rising_even, falling_even}) {
    if (is_diagonal(edges) ? !diagonals : edges == along_even && given.skew == 0) continue;
    choose(edges);
    backend_.launch(Kernels::slide_column_borders, std::int64_t{given.rows} * given.blocks, plan);
  }
  for (const EdgeClass edges : {rising_even, falling_even}) {
    if (!diagonals || given.skew == 0 || given.rows < 2) continue;
    choose(edges);
    backend_.launch(Kernels::slide_corners, given.blocks, plan);
  }
}

}  // namespace erg::models
