// The bed that grains fly over, on the processor's threads: whole counts of parcels in the wind's frame. The same bits
// for any number of threads.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "transport/grain_phases.h"

namespace erg {

class GrainBed : private GrainPhases {
 public:
  /// One step on the threads of `executor`. The terrain must be settled; it is up to date afterwards.
  GrainReport step(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key, const GroundLook& look,
                   Executor& executor);

 private:
  using Counts = std::vector<std::int32_t>;

  void load(const Terrain& terrain, const WindFrame& frame);
  void store(Terrain& terrain, const WindFrame& frame) const;
  template <typename Act>
  void for_cells(const Act& act);
  template <typename Act>
  void for_edges(const BedEdges& edges, const Act& act);
  template <typename Act>
  void for_tallied(std::int64_t items, const Act& act);
  std::int64_t relief() const;

  void freeze() override;
  void fly(const GrainMoment& now) override;
  void let_in(const GrainMoment& now, double inflow) override;
  void show_ground(const GroundLook& look) override { look(planes_.ground()); }
  void hand_out(const GrainMoment& now) override;
  void settle_accounts() override;
  void slide(const BedEdges& edges, int standing) override;
  bool has_slid() override;
  void creep(const BedEdges& edges, const GrainMoment& now) override;
  void bond(const GrainMoment& now) override;

  // Of the step under way.
  const GrainStepLaw* law_ = nullptr;
  Executor* executor_ = nullptr;
  BedPlanes planes_;
  std::mutex mutex_;
  GrainTally tally_;
  bool slid_ = false;

  Counts bedrock_;
  Counts mobile_;
  Counts bonded_;
  Counts gone_;
  Counts come_;
  Counts stirred_;
  Counts lifted_;  // empty unless lifts are counted
  Counts asked_;
  Counts asked_speed_;
  std::vector<GroundPoint> points_;
};

}  // namespace erg
