#include "transport/grain_phases.h"

#include <utility>

namespace erg {
namespace {

constexpr int slide_passes = 8;  // a sub-step; steeper ground goes on sliding in the next

template <typename Visit>
void for_edge_classes(const BedPlanes& layout, int way, const Visit& visit) {
  for (int number = 0; number < edge_classes(layout, way); ++number) visit(edges_of(layout, way, number));
}

void slide_slopes(GrainPhases& bed, const BedPlanes& layout, StandingSteps standing, const GrainMoment& now) {
  for (int pass = 0; pass < slide_passes; ++pass) {
    // The ways in an order drawn anew, so that none comes first always.
    int order[bed_ways] = {0, 1, 2, 3};
    for (std::uint32_t last = bed_ways - 1; last > 0; --last) {
      std::swap(
          order[last],
          order[random_below(now.key, now.sweep(GrainDraw::slide), static_cast<std::uint64_t>(pass), last, last + 1)]);
    }
    for (const int way : order) {
      const bool straight = way_u(way) == 0 || way_v(way) == 0;
      for_edge_classes(layout, way, [&](const BedEdges& edges) {
        bed.slide(edges, straight ? standing.straight : standing.diagonal);
      });
    }
    if (!bed.has_slid()) return;
  }
}

}  // namespace

BedPlanes bed_layout(const Terrain& terrain, const GrainStepLaw& law, const WindFrame& frame) {
  BedPlanes bed;
  bed.width = frame.width;
  bed.length = frame.length;
  bed.torus = terrain.boundary() == Boundary::torus;
  bed.tangent = frame.tangent;
  bed.cosine = frame.cosine;
  bed.quantum = terrain.quantum();
  bed.fall = law.shadow_fall;
  bed.longest_shadow = frame.tangent > 0 ? largest_side : frame.length;
  bed.fall_near = static_cast<float>(law.shadow_fall * terrain.quantum());
  bed.fall_far = static_cast<float>(law.shadow_fall * terrain.quantum() / frame.cosine);
  return bed;
}

void run_grain_step(GrainPhases& bed, const BedPlanes& layout, const GrainStepLaw& law, double inflow, StepKey key,
                    const GroundLook& look) {
  for (int sub_step = 0; sub_step < law.sub_steps; ++sub_step) {
    const GrainMoment now{key, sub_step, law.sub_steps};
    bed.freeze();
    bed.fly(now);
    if (inflow > 0) bed.let_in(now, inflow);
    if (look && sub_step + 1 == law.sub_steps) bed.show_ground(look);
    bed.hand_out(now);
    bed.settle_accounts();
    slide_slopes(bed, layout, law.standing, now);
  }
  const GrainMoment end{key, 0, law.sub_steps};
  for (int way = 0; way < 2 && law.settling > 0; ++way) {
    for_edge_classes(layout, way, [&](const BedEdges& edges) { bed.creep(edges, end); });
  }
  if (law.bonding > 0) bed.bond(end);
}

GrainReport book_grains(Terrain& terrain, const GrainTally& tally) {
  GrainReport report;
  report.step.polls = static_cast<std::int64_t>(terrain.extent().cells());
  report.step.lifts = tally.lifts;
  report.step.travel = static_cast<double>(tally.travel_micrometres) * 1e-6 / terrain.cell_size();
  report.step.slabs_in = tally.in;
  report.step.slabs_out = tally.out;
  terrain.ledger().in += tally.in;
  terrain.ledger().out += tally.out;
  report.flights = tally.flights;
  report.cut_off = tally.cut_off;
  return report;
}

}  // namespace erg
