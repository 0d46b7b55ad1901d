#include "models/grains/grain_solver.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "kernels/shadow_reach.h"
#include "models/grains/grain_kernels.h"

namespace erg::models {

using compute::Executor;
using forcing::Forcing;
using forcing::WindFrame;
using kernels::FrameLayer;

namespace {

constexpr int slide_passes = 8;  // a sub-step; steeper ground goes on sliding in the next

/// The bed's numbers for a terrain in this frame, but for its arrays and the lowest bedrock.
BedPlanes bed_layout(const Terrain& terrain, const GrainStepLaw& law, const WindFrame& frame) {
  BedPlanes bed;
  bed.width = frame.width;
  bed.length = frame.length;
  bed.torus = terrain.boundary() == Boundary::torus;
  bed.tangent = frame.tangent;
  bed.cosine = frame.cosine;
  bed.quantum = terrain.quantum();
  bed.fall = law.shadow_fall;
  bed.rows_around = kernels::rows_around(frame.length, frame.tangent);
  bed.fall_near = static_cast<float>(law.shadow_fall * terrain.quantum());
  bed.fall_far = static_cast<float>(law.shadow_fall * terrain.quantum() / frame.cosine);
  return bed;
}

/// The bonded grains of a cell by the terrain's field; an edit may have taken some of them away.
std::int32_t bonded_grains(std::int32_t mobile, float field) {
  return std::min(mobile, static_cast<std::int32_t>(field));
}

GrainReport report_of(const Terrain& terrain, const GrainCounters& counted) {
  GrainReport report;
  report.step.polls = static_cast<std::int64_t>(terrain.extent().cells());
  report.step.lifts = counted.lifts;
  report.step.travel = static_cast<double>(counted.travel_micrometres) * 1e-6 / terrain.cell_size();
  report.step.slabs_in = counted.in;
  report.step.slabs_out = counted.out;
  report.flights = counted.flights;
  report.cut_off = counted.cut_off;
  return report;
}

/// A step of grains, as executors carry it out.
struct GrainStep {
  using Solver = GrainSolver;
  using Report = GrainReport;

  GrainStepLaw law;
  Forcing wind;
  StepKey key;
  GroundLook look;

  std::unique_ptr<GrainSolver> make_solver(Executor& executor) const {
    return std::make_unique<GrainSolver>(executor.backend());
  }
  WindFrame frame(const Terrain& terrain) const { return forcing::wind_frame(terrain.extent(), wind.bearing); }
  void load(GrainSolver& solver, const Terrain& terrain) const { solver.load(terrain, frame(terrain)); }
  GrainReport run(GrainSolver& solver, Terrain& terrain, Executor& executor) const {
    const GrainCounters counted = solver.step(terrain, law, frame(terrain), key, look, executor.lift_counts());
    terrain.ledger().in += counted.in;
    terrain.ledger().out += counted.out;
    return report_of(terrain, counted);
  }
  GrainStep kept(GrainSolver&) const { return {law, wind, key, {}}; }
};

}  // namespace

GrainReport fly_grains(Executor& executor, Terrain& terrain, const GrainStepLaw& law, const Forcing& wind, StepKey key,
                       const GroundLook& look) {
  return executor.carry_out(terrain, GrainStep{law, wind, key, look});
}

// --- in and out ---

void GrainSolver::allocate(std::size_t cells, const WindFrame& frame) {
  for (FrameLayer* counts :
       {&bedrock_, &mobile_, &bonded_, &departures_, &arrivals_, &disturbed_, &ejection_requests_, &ejection_speed_}) {
    backend_.fit(*counts, cells);
  }
  layers_.fit(cells);
  backend_.fit(shelter_, cells);
  backend_.fit(points_, static_cast<std::size_t>(frame.width + 2) * static_cast<std::size_t>(frame.length + 2));
  backend_.fit(law_, 1);
  backend_.fit(bounds_, 3);
  backend_.fit(counters_, std::size_t{compute::counter_slots} * grain_counters);
  for (const FrameLayer* counts : {&departures_, &arrivals_, &ejection_requests_, &ejection_speed_}) {
    backend_.fill(*counts, 0);  // so every step leaves them
  }
  backend_.fill(bounds_, 0);
}

void GrainSolver::load(const Terrain& terrain, const WindFrame& frame) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  const Field* bonded = find_field(terrain.fields(), bonded_field);
  sent_law_.reset();
  sent_shelter_.reset();
  frame_ = frame;
  lowest_ = *std::min_element(bedrock.begin(), bedrock.end());
  allocate(terrain.extent().cells(), frame);
  layers_.scatter(bedrock_, frame, [&](std::size_t cell) { return bedrock[cell]; });
  layers_.scatter(mobile_, frame, [&](std::size_t cell) { return mobile[cell]; });
  may_bond_ = false;
  layers_.scatter(bonded_, frame, [&](std::size_t cell) {
    const std::int32_t grains = bonded == nullptr ? 0 : bonded_grains(mobile[cell], bonded->values[cell]);
    may_bond_ = may_bond_ || (bonded != nullptr && bonded->values[cell] != 0);
    return grains;
  });
}

void GrainSolver::sync_to_host(Terrain& terrain) {
  const std::vector<std::int32_t> mobile = layers_.gather(mobile_, frame_);
  const std::vector<std::int32_t> bonded = may_bond_ ? layers_.gather(bonded_, frame_) : std::vector<std::int32_t>{};
  // Only now that nothing can fail any more: the layers must not be half new.
  std::ranges::copy(mobile, terrain.edit_mobile().cells().begin());
  Field* field = may_bond_ ? find_field(terrain.edit_fields(), bonded_field) : nullptr;
  if (field != nullptr) std::ranges::copy(bonded, field->values.cells().begin());
}

// --- steps ---

void GrainSolver::send_law(const GrainStepLaw& law) {
  // Where padding alone differs it is sent once too often. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  if (!sent_law_ || std::memcmp(&*sent_law_, &law.grain, sizeof law.grain) != 0) {
    sent_law_ = law.grain;
    backend_.send(law_.data(), &law.grain, 1);
  }
  if (sent_shelter_ != law.shelter) {
    sent_shelter_ = law.shelter;
    backend_.send(shelter_.data(), law.shelter->data(), law.shelter->size());
  }
}

void GrainSolver::prepare(const Terrain& terrain, const GrainStepLaw& law, bool counts_lifts) {
  plan_ = {};
  plan_.bed = bed_layout(terrain, law, frame_);
  plan_.bed.lowest = lowest_;
  plan_.bed.shelter = shelter_.data();
  plan_.bed.bedrock = bedrock_.data();
  plan_.bed.mobile = mobile_.data();
  plan_.bed.bonded = bonded_.data();
  plan_.bed.departures = departures_.data();
  plan_.bed.arrivals = arrivals_.data();
  plan_.bed.disturbed = disturbed_.data();
  plan_.bed.ejection_requests = ejection_requests_.data();
  plan_.bed.ejection_speed = ejection_speed_.data();
  plan_.bed.points = points_.data();
  plan_.law = law_.data();
  plan_.abrasion = law.abrasion;
  plan_.settling = law.settling;
  plan_.bonding = law.bonding;
  plan_.shadow_rows = std::min(backend_.rows_a_thread(), frame_.length);
  plan_.bounds = bounds_.data();
  plan_.slid = bounds_.data() + 2;
  plan_.counters = counters_.data();
  backend_.fill(disturbed_, 0);
  backend_.fill(counters_, 0);
  if (!counts_lifts) return;
  backend_.fit(lifted_, static_cast<std::size_t>(cells()));
  backend_.fill(lifted_, 0);
  plan_.bed.lifted = lifted_.data();
}

GrainCounters GrainSolver::step(const Terrain& terrain, const GrainStepLaw& law, const WindFrame& frame, StepKey key,
                                const GroundLook& look, Grid<std::int32_t>* lift_counts) {
  if (!frame_.same_axes(frame)) layers_.turn({&bedrock_, &mobile_, &bonded_}, frame_, frame);
  frame_ = frame;
  send_law(law);
  may_bond_ = may_bond_ || law.bonding > 0;
  prepare(terrain, law, lift_counts != nullptr);
  run(law, terrain.inflow(), key, look);
  const auto counted = backend_.read_counters<grain_counters>(counters_);
  if (lift_counts != nullptr) layers_.add_to(*lift_counts, lifted_, frame_);
  return std::bit_cast<GrainCounters>(counted);
}

void GrainSolver::run(const GrainStepLaw& law, double inflow, StepKey key, const GroundLook& look) {
  using grain::Kernels;
  for (int sub_step = 0; sub_step < law.sub_steps; ++sub_step) {
    plan_.now = {key, sub_step, law.sub_steps};
    plan_.inflow = inflow;
    snapshot();
    backend_.launch(Kernels::fly, polls_of(plan_.now, cells()), plan_);
    if (inflow > 0) backend_.launch(Kernels::inject, frame_.width + frame_.length, plan_);
    if (look && sub_step + 1 == law.sub_steps) show_ground(look);
    backend_.launch(Kernels::resolve_splash, cells(), plan_);
    backend_.launch(Kernels::apply_deltas, cells(), plan_);
    slide_slopes(law.repose);
  }
  plan_.now = {key, 0, law.sub_steps};
  for (int way = 0; way < 2 && law.settling > 0; ++way) launch_edges(Kernels::creep, way);
  if (law.bonding > 0) backend_.launch(Kernels::bond, cells(), plan_);
}

void GrainSolver::snapshot() {
  const std::int64_t pieces = (frame_.length + plan_.shadow_rows - 1) / plan_.shadow_rows;
  backend_.fill(bounds_, 0);
  backend_.launch(grain::Kernels::snapshot, cells(), plan_);
  backend_.launch(grain::Kernels::shadow, pieces * frame_.width, plan_);
  backend_.launch(grain::Kernels::rim, rim_points(plan_.bed), plan_);
}

/// Looking is for pictures, which the processor makes.
void GrainSolver::show_ground(const GroundLook& look) {
  const std::vector<GroundPoint> points = backend_.fetch(points_.data(), points_.size());
  SurfaceSnapshot ground = plan_.bed.ground();
  ground.points = points.data();
  look(ground);
}

/// All classes of edges of one way.
void GrainSolver::launch_edges(const compute::KernelOf<grain::Plan>& kernel, int way) {
  for (int number = 0; number < edge_classes(plan_.bed, way); ++number) {
    plan_.edges = edges_of(plan_.bed, way, number);
    backend_.launch(kernel, static_cast<std::int64_t>(plan_.edges.outer) * plan_.edges.inner, plan_);
  }
}

void GrainSolver::slide_slopes(ReposeSteps repose) {
  const GrainMoment& now = plan_.now;
  for (int pass = 0; pass < slide_passes; ++pass) {
    // The ways in an order drawn anew, so that none comes first always.
    int order[bed_ways] = {0, 1, 2, 3};
    for (std::uint32_t last = bed_ways - 1; last > 0; --last) {
      std::swap(
          order[last],
          order[random_below(now.key, now.sweep(GrainDraw::slide), static_cast<std::uint64_t>(pass), last, last + 1)]);
    }
    for (const int way : order) {
      plan_.critical_step = way_u(way) == 0 || way_v(way) == 0 ? repose.straight : repose.diagonal;
      launch_edges(grain::Kernels::slide, way);
    }
    if (!has_slid()) return;
  }
}

/// Whether anything slid since this was last asked.
bool GrainSolver::has_slid() {
  const bool slid = backend_.fetch(plan_.slid, 1).front() != 0;
  if (slid) backend_.fill(plan_.slid, 0, sizeof *plan_.slid);
  return slid;
}

}  // namespace erg::models
