#include "cuda/device_grains.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace erg {
namespace {

constexpr std::size_t tally_words = sizeof(GrainTallyWords) / sizeof(std::int64_t);

}  // namespace

// --- in and out ---

void DeviceGrains::allocate(std::size_t cells, const WindFrame& frame) {
  for (DeviceLayer* counts : {&bedrock_, &mobile_, &bonded_, &gone_, &come_, &stirred_, &asked_, &asked_speed_}) {
    device_.fit(*counts, cells);
  }
  layers_.fit(cells);
  device_.fit(shelter_, cells);
  device_.fit(points_, static_cast<std::size_t>(frame.width + 2) * static_cast<std::size_t>(frame.length + 2));
  device_.fit(law_, 1);
  device_.fit(bounds_, 3);
  device_.fit(tally_, tally_slots * tally_words);
  for (const DeviceLayer* counts : {&gone_, &come_, &asked_, &asked_speed_}) {
    device_.fill(counts->data(), 0, counts->bytes());  // so every step leaves them
  }
  device_.fill(bounds_.data(), 0, bounds_.bytes());
}

void DeviceGrains::load(const Terrain& terrain, const WindFrame& frame) {
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  const Field* bonded = find_field(terrain.fields(), bonded_field);
  law_on_device_.reset();
  shelter_on_device_.reset();
  frame_ = frame;
  lowest_ = *std::min_element(bedrock.begin(), bedrock.end());
  allocate(terrain.extent().cells(), frame);
  layers_.lay(bedrock_, frame, [&](std::size_t cell) { return bedrock[cell]; });
  layers_.lay(mobile_, frame, [&](std::size_t cell) { return mobile[cell]; });
  may_bond_ = false;
  layers_.lay(bonded_, frame, [&](std::size_t cell) {
    const std::int32_t grains = bonded == nullptr ? 0 : bonded_grains(mobile[cell], bonded->values[cell]);
    may_bond_ = may_bond_ || (bonded != nullptr && bonded->values[cell] != 0);
    return grains;
  });
}

void DeviceGrains::turn(const WindFrame& frame) { layers_.turn({&bedrock_, &mobile_, &bonded_}, frame_, frame); }

void DeviceGrains::settle(Terrain& terrain) {
  const std::vector<std::int32_t> mobile = layers_.bring_back(mobile_, frame_);
  const std::vector<std::int32_t> bonded =
      may_bond_ ? layers_.bring_back(bonded_, frame_) : std::vector<std::int32_t>{};
  // Only now that nothing can fail any more: the layers must not be half new.
  std::ranges::copy(mobile, terrain.edit_mobile().cells().begin());
  Field* field = may_bond_ ? find_field(terrain.edit_fields(), bonded_field) : nullptr;
  if (field != nullptr) std::ranges::copy(bonded, field->values.cells().begin());
}

// --- steps ---

void DeviceGrains::send_law(const GrainStepLaw& law) {
  // Where padding alone differs it is sent once too often. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  if (!law_on_device_ || std::memcmp(&*law_on_device_, &law.grain, sizeof law.grain) != 0) {
    law_on_device_ = law.grain;
    device_.send(law_.data(), &law.grain, 1);
  }
  if (shelter_on_device_ != law.shelter) {
    shelter_on_device_ = law.shelter;
    device_.send(shelter_.data(), law.shelter->data(), law.shelter->size());
  }
}

GrainTally DeviceGrains::step(const Terrain& terrain, const GrainStepLaw& law, const WindFrame& frame, StepKey key,
                              const GroundLook& look, Grid<std::int32_t>* lift_counts) {
  if (!frame_.same_axes(frame)) turn(frame);
  frame_ = frame;
  send_law(law);
  may_bond_ = may_bond_ || law.bonding > 0;
  plan_ = {};
  plan_.bed = bed_layout(terrain, law, frame);
  plan_.bed.lowest = lowest_;
  plan_.bed.shelter = shelter_.data();
  plan_.bed.bedrock = bedrock_.data();
  plan_.bed.mobile = mobile_.data();
  plan_.bed.bonded = bonded_.data();
  plan_.bed.gone = gone_.data();
  plan_.bed.come = come_.data();
  plan_.bed.stirred = stirred_.data();
  plan_.bed.asked = asked_.data();
  plan_.bed.asked_speed = asked_speed_.data();
  plan_.bed.points = points_.data();
  if (lift_counts != nullptr) {
    device_.fit(lifted_, lift_counts->size());
    device_.fill(lifted_.data(), 0, lifted_.bytes());
    plan_.bed.lifted = lifted_.data();
  }
  plan_.law = law_.data();
  plan_.abrasion = law.abrasion;
  plan_.settling = law.settling;
  plan_.bonding = law.bonding;
  plan_.bounds = bounds_.data();
  plan_.slid = bounds_.data() + 2;
  plan_.tally = tally_.data();
  device_.fill(stirred_.data(), 0, stirred_.bytes());
  device_.fill(tally_.data(), 0, tally_.bytes());
  run_grain_step(*this, plan_.bed, law, terrain.inflow(), key, look);
  GrainTallyWords sum{};
  const std::vector<TallyWord> words = device_.fetch(tally_.data(), tally_.size());
  for (std::size_t k = 0; k < words.size(); ++k) sum.of[k % tally_words] += static_cast<std::int64_t>(words[k]);
  if (lift_counts != nullptr) layers_.add_to(*lift_counts, lifted_, frame_);
  return std::bit_cast<GrainTally>(sum);
}

void DeviceGrains::freeze() {
  const std::int64_t pieces = (frame_.length + shadow_rows - 1) / shadow_rows;
  device_.fill(bounds_.data(), 0, bounds_.bytes());
  device_.launch(GrainKernel::freeze, cells(), plan_);
  device_.launch(GrainKernel::shadow, pieces * frame_.width, plan_);
  device_.launch(GrainKernel::rim, rim_points(plan_.bed), plan_);
}

void DeviceGrains::fly(const GrainMoment& now) {
  plan_.now = now;
  device_.launch(GrainKernel::fly, polls_of(now, cells()), plan_);
}

void DeviceGrains::let_in(const GrainMoment& now, double inflow) {
  plan_.now = now;
  plan_.inflow = inflow;
  device_.launch(GrainKernel::let_in, frame_.width + frame_.length, plan_);
}

/// Looking is for pictures, which the processor makes.
void DeviceGrains::show_ground(const GroundLook& look) {
  const std::vector<GroundPoint> points = device_.fetch(points_.data(), points_.size());
  FrozenGround ground = plan_.bed.ground();
  ground.points = points.data();
  look(ground);
}

void DeviceGrains::hand_out(const GrainMoment& now) {
  plan_.now = now;
  device_.launch(GrainKernel::hand_out, cells(), plan_);
}

void DeviceGrains::settle_accounts() { device_.launch(GrainKernel::settle_accounts, cells(), plan_); }

void DeviceGrains::slide(const BedEdges& edges, int standing) {
  plan_.edges = edges;
  plan_.standing = standing;
  device_.launch(GrainKernel::slide, static_cast<std::int64_t>(edges.outer) * edges.inner, plan_);
}

bool DeviceGrains::has_slid() {
  const bool slid = device_.fetch(plan_.slid, 1).front() != 0;
  if (slid) device_.fill(plan_.slid, 0, sizeof *plan_.slid);
  return slid;
}

void DeviceGrains::creep(const BedEdges& edges, const GrainMoment& now) {
  plan_.now = now;
  plan_.edges = edges;
  device_.launch(GrainKernel::creep, static_cast<std::int64_t>(edges.outer) * edges.inner, plan_);
}

void DeviceGrains::bond(const GrainMoment& now) {
  plan_.now = now;
  device_.launch(GrainKernel::bond, cells(), plan_);
}

}  // namespace erg
