#include "models/snow/on_device.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "kernels/box_mean.h"
#include "models/snow/snow_kernels.h"

namespace erg::models {

using forcing::WindFrame;
using kernels::FrameLayer;
using kernels::step_counters;

namespace {

float* floats(const FrameLayer& layer) { return reinterpret_cast<float*>(layer.data()); }

/// Makes room for `count` values at least: what depends on the wind shall not be allocated anew with every gust.
template <typename T>
void reserve(compute::Backend& backend, compute::Buffer<T>& array, std::size_t count) {
  if (array.size() < count) backend.fit(array, count);
}

void write(const std::vector<std::int32_t>& bits, Grid<float>& layer) {
  std::ranges::transform(bits, layer.cells().begin(), [](std::int32_t word) { return std::bit_cast<float>(word); });
}

}  // namespace

// --- in and out ---

void SnowOnDevice::allocate(std::size_t cells) {
  layers_.fit(cells);
  for (FrameLayer* layer : {&bedrock_, &mobile_, &loose_, &age_, &landed_, &strength_}) backend_.fit(*layer, cells);
  backend_.fit(lifted_, 0);
  backend_.fit(law_, 1);
  backend_.fit(bounds_, snow_bounds);
  backend_.fit(heights_, cells);
  backend_.fit(columns_, cells);
  backend_.fit(sums_, cells);
  backend_.fit(level_, cells);
  backend_.fit(around_, cells);
  backend_.fit(dark_, cells);
  backend_.fit(cells_, cells);
  backend_.fit(over_, cells);
  backend_.fit(left_, 1);
  backend_.fit(counters_, std::size_t{compute::counter_slots} * step_counters);
}

void SnowOnDevice::load(const Terrain& terrain, const WindFrame& frame) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  const auto layer = [&](SnowLayer which) { return snow_layer(terrain.fields(), which).cells(); };
  const auto [lowest, highest] = std::ranges::minmax_element(bedrock);
  frame_ = frame;
  base_ = *lowest;
  relief_ = *lowest != *highest;
  strength_shown_ = false;
  allocate(terrain.extent().cells());
  layers_.scatter(bedrock_, frame, [&](std::size_t cell) { return bedrock[cell]; });
  layers_.scatter(mobile_, frame, [&](std::size_t cell) { return mobile[cell]; });
  layers_.scatter(loose_, frame, [&, bonded = layer(SnowLayer::bonded)](std::size_t cell) {
    return loose_slabs(mobile[cell], bonded[cell]);
  });
  layers_.scatter(age_, frame,
                  [age = layer(SnowLayer::age)](std::size_t cell) { return std::bit_cast<std::int32_t>(age[cell]); });
  layers_.scatter(landed_, frame, [landed = layer(SnowLayer::landed)](std::size_t cell) {
    return std::bit_cast<std::int32_t>(landed[cell]);
  });
}

void SnowOnDevice::turn(const WindFrame& frame) {
  layers_.turn({&bedrock_, &mobile_, &loose_, &age_, &landed_, &strength_}, frame_, frame);
}

void SnowOnDevice::sync_to_host(Terrain& terrain) {
  const std::vector<std::int32_t> mobile = layers_.gather(mobile_, frame_);
  const std::vector<std::int32_t> loose = layers_.gather(loose_, frame_);
  const std::vector<std::int32_t> age = layers_.gather(age_, frame_);
  const std::vector<std::int32_t> landed = layers_.gather(landed_, frame_);
  std::vector<std::int32_t> strength;
  if (strength_shown_) strength = layers_.gather(strength_, frame_);
  // Only now that nothing can fail any more: the layers must not be half new.
  std::ranges::copy(mobile, terrain.edit_mobile().cells().begin());
  std::vector<Field>& fields = terrain.edit_fields();
  Grid<float>& loose_layer = snow_layer(fields, SnowLayer::loose);
  Grid<float>& bonded_layer = snow_layer(fields, SnowLayer::bonded);
  for (std::size_t cell = 0; cell < loose.size(); ++cell) {
    loose_layer[cell] = static_cast<float>(loose[cell]);
    bonded_layer[cell] = static_cast<float>(mobile[cell] - loose[cell]);
  }
  write(age, snow_layer(fields, SnowLayer::age));
  write(landed, snow_layer(fields, SnowLayer::landed));
  if (strength_shown_) write(strength, snow_layer(fields, SnowLayer::strength));
}

// --- steps ---

StepReport SnowOnDevice::step(Terrain& terrain, const SnowStep& snow, const forcing::Forcing& wind, StepKey key,
                              compute::Executor& executor) {
  const WindFrame frame = forcing::wind_frame(terrain.extent(), wind.bearing);
  Grid<std::int32_t>* const lift_counts = executor.lift_counts();
  if (!frame_.same_axes(frame)) turn(frame);
  frame_ = frame;
  backend_.send(law_.data(), &snow.law, 1);
  backend_.fill(counters_, 0);
  SnowPlan plan = step_plan(terrain, snow, key);
  count_lifts(plan, lift_counts != nullptr);
  measure(plan, snow.radii);
  draws_.draw_sweeps(key, sweeps_);  // while the device is busy
  const std::vector<std::uint32_t> bounds = backend_.fetch(bounds_.data(), snow_bounds);
  check_snow_height(static_cast<std::int32_t>(bounds[bound_snow]),
                    static_cast<std::int32_t>(bounds[bound_highest] - ~bounds[bound_not_lowest]));
  send_draws(plan, bounds[bound_hop], key);
  fly(plan);
  slide(plan, key);
  rest(plan, snow);
  const kernels::StepCounters counts = backend_.read_counters<step_counters>(counters_);
  if (lift_counts != nullptr) layers_.add_to(*lift_counts, lifted_, frame_);
  StepReport report;
  report.polls = cells();
  report.lifts = counts.of[kernels::counted_lifts];
  report.travel = static_cast<double>(counts.of[kernels::counted_rows]) / frame_.cosine;
  report.slabs_in = counts.of[kernels::counted_in];
  report.slabs_out = counts.of[kernels::counted_out];
  terrain.ledger().in += report.slabs_in;
  terrain.ledger().out += report.slabs_out;
  return report;
}

SnowPlan SnowOnDevice::step_plan(const Terrain& terrain, const SnowStep& snow, StepKey key) {
  SnowPlan plan;
  plan.ground.width = frame_.width;
  plan.ground.length = frame_.length;
  plan.ground.torus = terrain.boundary() == Boundary::torus;
  plan.ground.step_v = frame_.width;
  plan.ground.bedrock = bedrock_.data();
  plan.ground.mobile = mobile_.data();
  plan.ground.loose = loose_.data();
  plan.ground.landed = floats(landed_);
  plan.base = base_;
  plan.age = floats(age_);
  plan.strength = floats(strength_);
  plan.law = law_.data();
  plan.counters = counters_.data();
  plan.bounds = bounds_.data();
  plan.heights = heights_.data();
  plan.columns = columns_.data();
  plan.sums = sums_.data();
  plan.level = level_.data();
  plan.around = around_.data();
  plan.dark = dark_.data();
  plan.shadow_rows = std::min(backend_.rows_a_thread(), frame_.length);
  plan.shadow_fall = snow.shadow_fall;
  plan.tangent = frame_.tangent;
  plan.cosine = frame_.cosine;
  const SnowSlopes slopes = snow_slopes(snow.law, frame_.tangent, frame_.cosine);
  plan.along = static_cast<float>(slopes.along);
  plan.across = static_cast<float>(slopes.across);
  plan.cells = cells_.data();
  plan.over = over_.data();
  plan.left = left_.data();
  plan.inflow = plan.ground.torus ? 0 : terrain.inflow();
  plan.rests = snow_rests(snow.law);
  plan.order = kernels::terrain_order(frame_);
  plan.nx = terrain.nx();
  plan.fall_word = snowfall_word(key);
  plan.bonding_key = bonding_key(key);
  return plan;
}

void SnowOnDevice::count_lifts(SnowPlan& plan, bool wanted) {
  if (!wanted) return;
  backend_.fit(lifted_, mobile_.size());
  backend_.fill(lifted_, 0);
  plan.lift_counts = lifted_.data();
}

// --- weather ---

void SnowOnDevice::measure(SnowPlan& plan, const SnowRadii& radii) {
  backend_.fill(bounds_, 0);
  launch(snow::Kernels::measure, plan);
  take_means(plan, radii.around, false, around_.data());
  take_means(plan, radii.smooth, true, level_.data());
  const std::int64_t pieces = (frame_.length + plan.shadow_rows - 1) / plan.shadow_rows;
  backend_.launch(snow::Kernels::cast_shadow, pieces * frame_.width, plan);
  launch(snow::Kernels::make_weather, plan);
}

/// Means over boxes; `twice`: the means of these means.
void SnowOnDevice::take_means(SnowPlan plan, int radius, bool twice, float* means) {
  plan.radius = radius;
  plan.share = kernels::box_share(radius, twice);
  plan.means = means;
  launch(snow::Kernels::sum_heights, plan);
  if (twice) {
    launch(snow::Kernels::sum_rows, plan);
    launch(snow::Kernels::sum_columns, plan);
  }
  launch(snow::Kernels::average_rows, plan);
}

// --- flights ---

void SnowOnDevice::send_draws(SnowPlan& plan, std::uint32_t longest_mean_hop, StepKey key) {
  draws_.draw_lines(frame_, key, longest_mean_hop);
  reserve(backend_, offsets_, draws_.offsets.size());
  backend_.send(offsets_.data(), draws_.offsets.data(), draws_.offsets.size());
  backend_.fit(drawn_, draws_.sweeps.size());
  backend_.send(drawn_.data(), draws_.sweeps.data(), draws_.sweeps.size());
  plan.offsets = offsets_.data();
  plan.sweeps = drawn_.data();
  plan.polling = sweeps_;
  plan.last_sweep = static_cast<int>(draws_.sweeps.size()) - 1;
  plan.reach = draws_.reach;
  plan.ring_mask = draws_.ring_rows - 1;
  plan.drift = draws_.drift;
  plan.closes = draws_.lines_close(frame_, plan.ground.torus ? Boundary::torus : Boundary::open);
  const std::size_t waiting = static_cast<std::size_t>(draws_.ring_rows) * static_cast<std::size_t>(frame_.width);
  reserve(backend_, ring_, waiting);
  backend_.fill(ring_.data(), 0, waiting * sizeof(std::uint64_t));
  plan.ring = ring_.data();
  if (plan.closes) return;
  reserve(backend_, aloft_, waiting);
  backend_.fill(aloft_.data(), 0, waiting * sizeof(std::uint64_t));
  backend_.fill(left_, 0);
  plan.aloft = aloft_.data();
}

/// All sub-sweeps; where lines go on as others, pass after pass until nothing is in the air.
void SnowOnDevice::fly(SnowPlan plan) {
  if (relief_) launch(snow::Kernels::find_walls, plan);
  launch(snow::Kernels::find_runs, plan);
  backend_.launch(snow::Kernels::fly, frame_.width, plan);
  for (auto number = static_cast<std::size_t>(sweeps_); !plan.closes; ++number) {
    if (backend_.fetch(left_.data(), 1).front() == 0) break;
    backend_.fill(left_, 0);
    std::swap(plan.ring, plan.aloft);  // the first is empty by now
    plan.sweep = static_cast<int>(draws_.sweep_number(number));
    backend_.launch(snow::Kernels::bring_down, frame_.width, plan);
  }
  launch(snow::Kernels::store, plan);
}

// --- slides and rest ---

void SnowOnDevice::slide(SnowPlan plan, StepKey key) {
  for (int round = 0; round < snow_slide_rounds; ++round) {
    SnowEdges order[4];
    draw_snow_slides(key, round, order);
    for (const SnowEdges& edges : order) slide_class(plan, edges);
  }
}

void SnowOnDevice::slide_class(SnowPlan& plan, const SnowEdges& edges) {
  const int count = edges.along ? frame_.length : frame_.width;
  const int places = edges.along ? frame_.width : frame_.length;
  plan.edges = {edges.along, edges.odd, (count - edges.odd) / 2, false};
  if (plan.edges.count > 0) backend_.launch(snow::Kernels::slide, std::int64_t{plan.edges.count} * places, plan);
  if (edges.odd == 0 || !plan.ground.torus || count <= 2) return;
  plan.edges = {edges.along, edges.odd, 1, true};
  backend_.launch(snow::Kernels::slide, places, plan);
}

void SnowOnDevice::rest(SnowPlan& plan, const SnowStep& snow) {
  if (snow.law.snowfall > 0) {
    plan.fallen = layers_.staged().data();
    backend_.fill(plan.fallen, 0, layers_.staged().bytes());
    launch(snow::Kernels::fall, plan);
  }
  launch(snow::Kernels::rest, plan);
  if (!snow.shows_strength) return;
  launch(snow::Kernels::show_strength, plan);
  strength_shown_ = true;
}

}  // namespace erg::models
