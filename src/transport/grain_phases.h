// The order of a time step of grains, whoever carries its phases out: threads (grain_bed.h) or a graphics card.
//
// A step is cut into sub-steps. Each freezes the ground, polls a random part of the cells and flies their grains, hands
// out what impacts knocked loose, books it, and lets slopes slide. All rules stand in grain_bed_cell.h.
#pragma once

#include <algorithm>

#include "core/terrain.h"
#include "forcing/wind_frame.h"
#include "transport/executor.h"
#include "transport/grain_bed_cell.h"
#include "transport/grain_step.h"

namespace erg {

/// A bed that holds a terrain in the wind's frame. Each phase is over for all cells before the next begins.
class GrainPhases {
 public:
  virtual ~GrainPhases() = default;

  virtual void freeze() = 0;
  virtual void fly(const GrainMoment& now) = 0;
  /// `inflow`: a step and cell of upwind edge.
  virtual void let_in(const GrainMoment& now, double inflow) = 0;
  /// Shows the frozen ground.
  virtual void show_ground(const GroundLook& look) = 0;
  virtual void hand_out(const GrainMoment& now) = 0;
  virtual void settle_accounts() = 0;
  /// One class of edges.
  virtual void slide(const BedEdges& edges, int standing) = 0;
  /// Whether anything slid since this was last asked.
  virtual bool has_slid() = 0;
  virtual void creep(const BedEdges& edges, const GrainMoment& now) = 0;
  virtual void bond(const GrainMoment& now) = 0;
};

/// The bed's numbers for a terrain in this frame, but for its arrays and the lowest bedrock.
BedPlanes bed_layout(const Terrain& terrain, const GrainStepLaw& law, const WindFrame& frame);

/// The bonded grains of a cell by the terrain's field; an edit may have taken some of them away.
inline std::int32_t bonded_grains(std::int32_t mobile, float field) {
  return std::min(mobile, static_cast<std::int32_t>(field));
}

/// One step. `look` may be empty.
void run_grain_step(GrainPhases& bed, const BedPlanes& layout, const GrainStepLaw& law, double inflow, StepKey key,
                    const GroundLook& look);

/// Books in- and outflow in the terrain's ledger and tells what a step did.
GrainReport book_grains(Terrain& terrain, const GrainTally& tally);

}  // namespace erg
