#include "transport/grain_bed.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "transport/shared_work.h"

namespace erg {
namespace {

void add(GrainTally& sum, const GrainTally& share) {
  auto words = std::bit_cast<GrainTallyWords>(sum);
  const auto more = std::bit_cast<GrainTallyWords>(share);
  for (std::size_t k = 0; k < std::size(words.of); ++k) words.of[k] += more.of[k];
  sum = std::bit_cast<GrainTally>(words);
}

}  // namespace

GrainReport GrainBed::step(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key,
                           const GroundLook& look, Executor& executor) {
  const WindFrame frame = wind_frame(terrain.extent(), wind.bearing);
  law_ = &law;
  executor_ = &executor;
  planes_ = bed_layout(terrain, law, frame);
  tally_ = {};
  load(terrain, frame);
  run_grain_step(*this, planes_, law, terrain.inflow(), key, look);
  store(terrain, frame);
  return book_grains(terrain, tally_);
}

// --- in and out ---

void GrainBed::load(const Terrain& terrain, const WindFrame& frame) {
  const std::size_t cells = terrain.extent().cells();
  for (Counts* counts : {&bedrock_, &mobile_, &bonded_, &gone_, &come_, &stirred_, &asked_, &asked_speed_}) {
    counts->assign(cells, 0);
  }
  points_.assign(static_cast<std::size_t>(frame.width + 2) * static_cast<std::size_t>(frame.length + 2), {});
  const auto bedrock = terrain.bedrock().cells();
  planes_.lowest = *std::min_element(bedrock.begin(), bedrock.end());
  const Field* bonded = find_field(terrain.fields(), bonded_field);
  std::size_t to = 0;
  for (int v = 0; v < frame.length; ++v) {
    for (int u = 0; u < frame.width; ++u, ++to) {
      const std::size_t from = frame.cell(u, v);
      bedrock_[to] = bedrock[from];
      mobile_[to] = terrain.mobile()[from];
      if (bonded != nullptr) bonded_[to] = bonded_grains(mobile_[to], bonded->values[from]);
    }
  }
  lifted_.assign(executor_->lift_counts() == nullptr ? 0 : cells, 0);
  planes_.lifted = lifted_.empty() ? nullptr : lifted_.data();
  planes_.shelter = law_->shelter->data();
  planes_.bedrock = bedrock_.data();
  planes_.mobile = mobile_.data();
  planes_.bonded = bonded_.data();
  planes_.gone = gone_.data();
  planes_.come = come_.data();
  planes_.stirred = stirred_.data();
  planes_.asked = asked_.data();
  planes_.asked_speed = asked_speed_.data();
  planes_.points = points_.data();
}

void GrainBed::store(Terrain& terrain, const WindFrame& frame) const {
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  Field* bonded = find_field(terrain.edit_fields(), bonded_field);
  std::size_t from = 0;
  for (int v = 0; v < frame.length; ++v) {
    for (int u = 0; u < frame.width; ++u, ++from) {
      const std::size_t to = frame.cell(u, v);
      mobile[to] = mobile_[from];
      if (bonded != nullptr) bonded->values[to] = static_cast<float>(bonded_[from]);
      if (!lifted_.empty()) (*executor_->lift_counts())[to] += lifted_[from];
    }
  }
}

// --- sharing the work out ---

/// act(cell) for each cell.
template <typename Act>
void GrainBed::for_cells(const Act& act) {
  executor_->for_pieces(planes_.cells(), [&act](std::int64_t first, std::int64_t last) {
    for (std::int64_t cell = first; cell < last; ++cell) act(cell);
  });
}

/// act(edge) for each edge of a class.
template <typename Act>
void GrainBed::for_edges(const BedEdges& edges, const Act& act) {
  executor_->for_pieces(edges.outer, [&, planes = planes_](std::int64_t first, std::int64_t last) {
    BedEdge edge;
    bool any = false;
    for (int outer = static_cast<int>(first); outer < last; ++outer) {
      for (int inner = 0; inner < edges.inner; ++inner) {
        if (find_edge(planes, edges, outer, inner, edge) && act(planes, edge)) any = true;
      }
    }
    if (!any) return;
    const std::lock_guard lock(mutex_);
    slid_ = true;
  });
}

/// act(item, tally) for each item; adds up what each thread counts. Flights differ in length by far, so threads that
/// are done with theirs help the others.
template <typename Act>
void GrainBed::for_tallied(std::int64_t items, const Act& act) {
  const int members = executor_->threads();
  SharedWork work(items, members);
  executor_->for_pieces(members, [&, planes = planes_](std::int64_t first, std::int64_t last) {
    GrainTally tally;
    for (auto member = static_cast<int>(first); member < last; ++member) {
      work.take_pieces(member, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t item = begin; item < end; ++item) act(planes, item, tally);
      });
    }
    const std::lock_guard lock(mutex_);
    add(tally_, tally);
  });
}

// --- phases ---

/// Quanta between the lowest and the highest cell.
std::int64_t GrainBed::relief() const {
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();
  for (std::size_t cell = 0; cell < mobile_.size(); ++cell) {
    low = std::min(low, bedrock_[cell] + mobile_[cell]);
    high = std::max(high, bedrock_[cell] + mobile_[cell]);
  }
  return static_cast<std::int64_t>(high) - low;
}

void GrainBed::freeze() {
  executor_->for_pieces(planes_.length, [planes = planes_](std::int64_t first, std::int64_t last) {
    for (int v = static_cast<int>(first); v < last; ++v) {
      for (int u = 0; u < planes.width; ++u) freeze_cell(planes, u, v);
    }
  });
  const int start = first_shadow_row(planes_, relief());
  executor_->for_pieces(planes_.width, [planes = planes_, start](std::int64_t first, std::int64_t last) {
    for (int line = static_cast<int>(first); line < last; ++line) {
      ShadowLine shadow;
      follow_shadow(planes, line, start, start, 0, false, shadow);
      follow_shadow(planes, line, start, 0, planes.length, true, shadow);
    }
  });
  for (int number = 0; number < rim_points(planes_); ++number) freeze_rim(planes_, number);
}

void GrainBed::fly(const GrainMoment& now) {
  for_tallied(polls_of(now, planes_.cells()), [&](const BedPlanes& planes, std::int64_t poll, GrainTally& tally) {
    poll_grain(law_->grain, planes, now, poll, tally);
  });
}

void GrainBed::let_in(const GrainMoment& now, double inflow) {
  for_tallied(upwind_cells(law_->grain, planes_), [&](const BedPlanes& planes, std::int64_t number, GrainTally& tally) {
    let_grains_in(law_->grain, planes, now, inflow, static_cast<int>(number), tally);
  });
}

void GrainBed::hand_out(const GrainMoment& now) {
  for_tallied(planes_.cells(), [&](const BedPlanes& planes, std::int64_t cell, GrainTally& tally) {
    erg::hand_out(law_->grain, planes, now, law_->abrasion, cell, tally);
  });
}

void GrainBed::settle_accounts() {
  for_cells([planes = planes_](std::int64_t cell) { settle_account(planes, cell); });
}

void GrainBed::slide(const BedEdges& edges, int standing) {
  for_edges(edges,
            [standing](const BedPlanes& planes, const BedEdge& edge) { return slide_grains(planes, edge, standing); });
}

bool GrainBed::has_slid() { return std::exchange(slid_, false); }

void GrainBed::creep(const BedEdges& edges, const GrainMoment& now) {
  for_edges(edges, [&](const BedPlanes& planes, const BedEdge& edge) {
    creep_grain(planes, edge, edges.way, law_->settling, now);
    return false;
  });
}

void GrainBed::bond(const GrainMoment& now) {
  for_cells([&, planes = planes_](std::int64_t cell) { bond_cell(planes, law_->bonding, now, cell); });
}

}  // namespace erg
