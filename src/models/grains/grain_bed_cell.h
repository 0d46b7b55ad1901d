// The rules of the bed that grains fly over, cell by cell and edge by edge: how the ground is frozen, how grains leave
// it and come down on it, what impacts knock loose, what slides, creeps and bonds. Shared by every executor, as the
// rules of a grain in grain_cell.h are.
//
// Within a phase of a step (grain_solver.h) items may be worked on in any order and side by side: each writes only what
// is its own, or adds whole numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "compute/kernel.h"
#include "core/grid.h"
#include "kernels/line_walk.h"
#include "kernels/shadow_reach.h"
#include "models/grains/grain_cell.h"

namespace erg::models {

/// The bed as plain arrays in the wind's frame (cell = v * width + u), counts of whole parcels. Not owned.
struct BedPlanes {
  int width = 0;
  int length = 0;
  bool torus = true;
  double tangent = 0;  ///< of the wind in its frame
  double cosine = 1;
  double quantum = 1;              ///< m
  double fall = 1;                 ///< of the shadow line, quanta a cell
  float fall_far = 0;              ///< m from a row to the next on a line along the wind
  float fall_near = 0;             ///< m from a row to the next on its own
  int rows_around = 0;             ///< rows before a torus beyond which no shadow is looked for
  std::int32_t lowest = 0;         ///< bedrock, from which the frozen ground counts
  const float* shelter = nullptr;  ///< share of the wind that plants leave
  const std::int32_t* bedrock = nullptr;
  std::int32_t* mobile = nullptr;
  std::int32_t* bonded = nullptr;             ///< of the mobile grains
  std::int32_t* departures = nullptr;         ///< left in this sub-step
  std::int32_t* arrivals = nullptr;           ///< came in this sub-step
  std::int32_t* disturbed = nullptr;          ///< came or went in this step
  std::int32_t* lifted = nullptr;             ///< flew off when polled in this step; null: not counted
  std::int32_t* ejection_requests = nullptr;  ///< impacts asked for so many
  std::int32_t* ejection_speed = nullptr;     ///< in 1/64 m/s, summed over the grains asked for
  GroundPoint* points = nullptr;              ///< the frozen ground with its rim

  ERG_CELL_RULE std::int64_t cells() const { return static_cast<std::int64_t>(width) * length; }
  ERG_CELL_RULE SurfaceSnapshot ground() const { return {points, width, length, torus, lowest * quantum}; }
  /// A point of the frozen ground or of its rim.
  ERG_CELL_RULE GroundPoint& point(int u, int v) const {
    return points[static_cast<std::int64_t>(v + 1) * (width + 2) + u + 1];
  }
  ERG_CELL_RULE std::int32_t height(std::int64_t cell) const { return bedrock[cell] + mobile[cell]; }
};

/// What is drawn for grains. Draws of a step are told apart by their sweep: a kind for each sub-step.
enum class GrainDraw : std::uint64_t { flight, inflow, reptation, abrasion, slide, creep, bond };

/// A sub-step of a step.
struct GrainMoment {
  StepKey key;
  int sub_step = 0;
  int sub_steps = 1;

  ERG_CELL_RULE std::uint64_t sweep(GrainDraw draw) const {
    return static_cast<std::uint64_t>(sub_step) * 8 + static_cast<std::uint64_t>(draw);
  }
  ERG_CELL_RULE GrainDice dice(GrainDraw draw, std::int64_t cell, int number) const {
    return {random_word(key, sweep(draw), static_cast<std::uint64_t>(cell), static_cast<std::uint64_t>(number))};
  }
  ERG_CELL_RULE double unit(GrainDraw draw, std::int64_t cell, int number) const {
    return random_unit(key, sweep(draw), static_cast<std::uint64_t>(cell), static_cast<std::uint64_t>(number));
  }
};

/// What one thread counts, in whole numbers so that sums do not depend on their order.
struct GrainCounters {
  FlightCounters flights;
  std::int64_t lifts = 0;
  std::int64_t in = 0;
  std::int64_t out = 0;
  std::int64_t cut_off = 0;
  std::int64_t travel_micrometres = 0;

  ERG_CELL_RULE void book(FlightEnd end, const Grain& grain) {
    travel_micrometres += static_cast<std::int64_t>(grain.along * 1e6f);
    out += end == FlightEnd::left ? 1 : 0;
    cut_off += end == FlightEnd::cut_off ? 1 : 0;
  }
};

/// Of 64 bits each.
inline constexpr int grain_counters = sizeof(GrainCounters) / sizeof(std::int64_t);

// --- the frozen ground ---

/// Of a m/s, in sums of impact speeds.
inline constexpr float speed_parts = 64;
/// Deeper than any shadow.
inline constexpr float no_shadow = -1e30f;

ERG_CELL_RULE void snapshot_cell(const BedPlanes& bed, int u, int v) {
  const std::int64_t cell = static_cast<std::int64_t>(v) * bed.width + u;
  const std::int64_t count = static_cast<std::int64_t>(bed.bedrock[cell]) + bed.mobile[cell] - bed.lowest;
  bed.point(u, v) = {static_cast<float>(static_cast<double>(count) * bed.quantum), no_shadow, bed.shelter[cell],
                     bed.mobile[cell] - bed.bonded[cell]};
}

/// The row, before the grid on a torus, from which a shadow can still reach into the grid when its highest cell stands
/// `relief` quanta over its lowest.
ERG_CELL_RULE int first_shadow_row(const BedPlanes& bed, std::int64_t relief) {
  if (!bed.torus) return 0;
  return -kernels::shadow_reach(static_cast<double>(relief), bed.fall, bed.cosine, bed.rows_around);
}

/// Heights (m) of the shadow line that comes to a cell: along the wind, and from the cell before it in its row's order.
struct ShadowLine {
  float far = no_shadow;
  float near = no_shadow;
};

/// Follows a line along the wind from row `from` to before `end`, as shadow_map in kernels/shadow.h does, and notes the
/// height of the shadow line over each cell if `notes`. Each line meets a cell once, so lines may be followed side by
/// side. `start`: the row in which all lines begin.
ERG_CELL_RULE void follow_shadow(const BedPlanes& bed, int line, int start, int from, int end, bool notes,
                                 ShadowLine& shadow) {
  for (int row = from; row < end; ++row) {
    const int sideways = kernels::line_offset(row, bed.tangent);
    const int column = wrap(line + sideways, bed.width);
    // A line that leaves an open grid comes in again as another.
    if (!bed.torus && row > start && column == 0 && sideways != kernels::line_offset(row - 1, bed.tangent))
      shadow = ShadowLine{};
    GroundPoint& here = bed.point(column, wrap(row, bed.length));
    if (notes) here.shadow = shadow.far > shadow.near ? shadow.far : shadow.near;
    shadow.far = (here.height > shadow.far ? here.height : shadow.far) - bed.fall_far;
    shadow.near = here.height - bed.fall_near;
  }
}

/// Points of the rim round the frozen ground.
ERG_CELL_RULE int rim_points(const BedPlanes& bed) { return 2 * (bed.length + 2) + 2 * bed.width; }

/// Makes point `number` of the rim that of the cell beyond the torus edge; the nearest inside where the grid is open.
ERG_CELL_RULE void snapshot_rim(const BedPlanes& bed, int number) {
  const auto inside = [&bed](int place, int count) {
    if (bed.torus) return wrap(place, count);
    return place < 0 ? 0 : place < count ? place : count - 1;
  };
  const int beside = 2 * (bed.length + 2);
  const int side = number & 1;
  const int u = number < beside ? (side == 0 ? -1 : bed.width) : (number - beside) / 2;
  const int v = number < beside ? number / 2 - 1 : (side == 0 ? -1 : bed.length);
  bed.point(u, v) = bed.point(inside(u, bed.width), inside(v, bed.length));
}

// --- flights ---

/// What a flight does to the bed.
struct BedWatch {
  const BedPlanes* bed;

  ERG_CELL_RULE void at(const Grain&) {}
  ERG_CELL_ACT void impact(int u, int v, int grains, float speed) {
    if (grains == 0) return;
    const std::int64_t cell = static_cast<std::int64_t>(v) * bed->width + u;
    compute::atomic_add(&bed->ejection_requests[cell], grains);
    compute::atomic_add(&bed->ejection_speed[cell], static_cast<std::int32_t>(speed * speed_parts) * grains);
  }
};

/// The cell that poll `poll` of a sub-step asks: one at random of each `sub_steps` cells in a row; none (-1) for the
/// part of the last block that lies beyond the grid.
ERG_CELL_RULE std::int64_t polled_cell(const GrainMoment& now, std::int64_t poll, std::int64_t cells, GrainDice& dice) {
  const auto inside = static_cast<std::int64_t>(dice.unit() * static_cast<float>(now.sub_steps));
  const std::int64_t cell = poll * now.sub_steps + inside;
  return cell < cells ? cell : -1;
}

/// Polls of a sub-step.
ERG_CELL_RULE std::int64_t polls_of(const GrainMoment& now, std::int64_t cells) {
  return (cells + now.sub_steps - 1) / now.sub_steps;
}

/// A grain that is no longer in the air rests, unless it left.
ERG_CELL_ACT void put_down(const GrainLaw& law, const BedPlanes& bed, FlightEnd end, const Grain& grain,
                           GrainDice& dice, GrainCounters& tally) {
  tally.book(end, grain);
  if (end == FlightEnd::left) return;
  const BedCell place = resting_place(law, bed.ground(), grain, dice);
  compute::atomic_add(&bed.arrivals[static_cast<std::int64_t>(place.v) * bed.width + place.u], 1);
}

/// Poll `poll` of the sub-step: a grain of the polled cell flies, if one can leave.
ERG_CELL_ACT void poll_grain(const GrainLaw& law, const BedPlanes& bed, const GrainMoment& now, std::int64_t poll,
                             GrainCounters& tally) {
  GrainDice dice = now.dice(GrainDraw::flight, poll, 0);
  const std::int64_t cell = polled_cell(now, poll, bed.cells(), dice);
  if (cell < 0) return;
  const SurfaceSnapshot ground = bed.ground();
  Grain grain;
  if (!lift_off(law, ground, static_cast<int>(cell % bed.width), static_cast<int>(cell / bed.width), dice, grain)) {
    return;
  }
  ++bed.departures[cell];  // nobody else polls this cell
  if (bed.lifted != nullptr) ++bed.lifted[cell];
  ++tally.lifts;
  BedWatch watch{&bed};
  const FlightEnd end = fly(law, ground, grain, dice, tally.flights, watch);
  put_down(law, bed, end, grain, dice, tally);
}

/// Cells of the upwind edges of an open grid.
ERG_CELL_RULE int upwind_cells(const GrainLaw& law, const BedPlanes& bed) {
  return bed.width + (law.toward_u > 0 ? bed.length - 1 : 0);
}

/// Grains that enter over upwind cell `number`, as if they had just left the ground there. `inflow`: a step.
ERG_CELL_ACT void inject_grains(const GrainLaw& law, const BedPlanes& bed, const GrainMoment& now, double inflow,
                                int number, GrainCounters& tally) {
  const bool side = number >= bed.width;
  const int v = side ? number - bed.width + 1 : 0;
  const SurfaceSnapshot ground = bed.ground();
  GrainDice dice = now.dice(GrainDraw::inflow, side ? bed.width + v : number, 0);
  const auto count = static_cast<int>(inflow / static_cast<double>(now.sub_steps) + static_cast<double>(dice.unit()));
  BedWatch watch{&bed};
  for (int k = 0; k < count; ++k) {
    Grain grain;
    set_off(law, ground, side ? 0 : number, v, dice, grain);
    const FlightEnd end = fly(law, ground, grain, dice, tally.flights, watch);
    put_down(law, bed, end, grain, dice, tally);
  }
  tally.in += count;
}

/// Resolves what impacts asked of the cell: takes loose grains and lets them hop. Where nothing is left loose, further
/// impacts free bonded grains with chance `abrasion`.
ERG_CELL_ACT void resolve_splash(const GrainLaw& law, const BedPlanes& bed, const GrainMoment& now, double abrasion,
                                 std::int64_t cell, GrainCounters& tally) {
  const int requests = bed.ejection_requests[cell];
  if (requests == 0) return;
  const int u = static_cast<int>(cell % bed.width);
  const int v = static_cast<int>(cell / bed.width);
  const SurfaceSnapshot ground = bed.ground();
  const int loose = ground.of_cell(u, v).loose - bed.departures[cell];
  const int going = requests < loose ? requests : loose;
  bed.departures[cell] += going;
  if (requests > loose) {
    const double wanted = (requests - loose) * abrasion;
    const int freed = static_cast<int>(wanted + now.unit(GrainDraw::abrasion, cell, 0));
    bed.bonded[cell] -= freed < bed.bonded[cell] ? freed : bed.bonded[cell];
  }
  const float speed = static_cast<float>(bed.ejection_speed[cell]) / static_cast<float>(requests) / speed_parts;
  for (int k = 0; k < going; ++k) {
    GrainDice dice = now.dice(GrainDraw::reptation, cell, k);
    Grain grain;
    const bool stays = reptate(law, ground, u, v, speed, dice, grain);
    put_down(law, bed, stays ? FlightEnd::rested : FlightEnd::left, grain, dice, tally);
  }
  bed.ejection_requests[cell] = bed.ejection_speed[cell] = 0;
}

/// Books all that left the cell and came to it.
ERG_CELL_RULE void apply_deltas_to(const BedPlanes& bed, std::int64_t cell) {
  bed.mobile[cell] += bed.arrivals[cell] - bed.departures[cell];
  bed.disturbed[cell] += bed.arrivals[cell] + bed.departures[cell];
  bed.arrivals[cell] = bed.departures[cell] = 0;
}

// --- the bed by itself ---

/// The four ways to a neighbour: across the wind, along it, and the two diagonals.
inline constexpr int bed_ways = 4;
ERG_CELL_RULE int way_u(int way) { return way == 1 ? 0 : way == 3 ? -1 : 1; }
ERG_CELL_RULE int way_v(int way) { return way == 0 ? 0 : 1; }

/// Edges of one way that share no cell, so that all of them can be worked on at once: items [0, outer * inner).
struct BedEdges {
  int way = 0;
  int first = 0;  ///< along which classes alternate
  int outer = 0;
  int inner = 0;
};

/// How many such classes a way has: even places, odd places, and the edge that closes a torus of odd extent.
ERG_CELL_RULE int edge_classes(const BedPlanes& bed, int way) {
  if ((way_u(way) != 0 && bed.width < 2) || (way_v(way) != 0 && bed.length < 2)) return 0;
  return 2 + (way_v(way) == 0 ? bed.width : bed.length) % 2;
}

ERG_CELL_RULE BedEdges edges_of(const BedPlanes& bed, int way, int number) {
  const bool across = way_v(way) == 0;
  const int extent = across ? bed.width : bed.length;
  const int paired = extent - extent % 2;
  const int count = number == 2 ? 1 : paired / 2;
  return {way, number == 2 ? paired : number, across ? bed.length : count, across ? count : bed.width};
}

/// An edge, seen from its higher cell.
struct BedEdge {
  std::int64_t cell = 0;  ///< the one that keys its draws
  std::int64_t high = 0;
  std::int64_t low = 0;
  std::int32_t difference = 0;  ///< of their heights, quanta
};

/// The edge of a class; false where it would lead out of an open grid.
ERG_CELL_RULE bool find_edge(const BedPlanes& bed, const BedEdges& edges, int outer, int inner, BedEdge& edge) {
  const bool across = way_v(edges.way) == 0;
  const int u = across ? edges.first + 2 * inner : inner;
  const int v = across ? outer : edges.first + 2 * outer;
  const int to_u = u + way_u(edges.way);
  const int to_v = v + way_v(edges.way);
  const bool over = to_u < 0 || to_u >= bed.width || to_v >= bed.length;
  if (over && !bed.torus) return false;
  // One step beyond the edge at most, so no division is needed to come back onto the torus.
  const int there_u = to_u < 0 ? bed.width - 1 : to_u < bed.width ? to_u : 0;
  const int there_v = to_v < bed.length ? to_v : 0;
  const std::int64_t here = static_cast<std::int64_t>(v) * bed.width + u;
  const std::int64_t there = static_cast<std::int64_t>(there_v) * bed.width + there_u;
  const std::int32_t difference = bed.height(here) - bed.height(there);
  edge = difference >= 0 ? BedEdge{here, here, there, difference} : BedEdge{here, there, here, -difference};
  return true;
}

/// Loose grains slide down an edge steeper than the critical step. True when some did.
ERG_CELL_RULE bool slide_grains(const BedPlanes& bed, const BedEdge& edge, std::int32_t critical_step) {
  if (edge.difference <= critical_step) return false;
  const std::int32_t wanted = (edge.difference - critical_step + 1) / 2;
  const std::int32_t loose = bed.mobile[edge.high] - bed.bonded[edge.high];
  const std::int32_t going = wanted < loose ? wanted : loose;
  bed.mobile[edge.high] -= going;
  bed.mobile[edge.low] += going;
  return going > 0;
}

/// A loose grain creeps down an edge with a chance of `chance` times the parcels between its cells.
ERG_CELL_RULE void creep_grain(const BedPlanes& bed, const BedEdge& edge, int way, double chance,
                               const GrainMoment& now) {
  const double likely = chance * edge.difference < 0.5 ? chance * edge.difference : 0.5;
  if (edge.difference < 1 || bed.mobile[edge.high] <= bed.bonded[edge.high]) return;
  if (now.unit(GrainDraw::creep, edge.cell, way) >= likely) return;
  --bed.mobile[edge.high];
  ++bed.mobile[edge.low];
}

/// With chance `share` all loose grains of the cell bond that have rested during the step.
ERG_CELL_RULE void bond_cell(const BedPlanes& bed, double share, const GrainMoment& now, std::int64_t cell) {
  const std::int32_t resting = bed.mobile[cell] - bed.bonded[cell] - bed.disturbed[cell];
  if (resting > 0 && now.unit(GrainDraw::bond, cell, 0) < share) bed.bonded[cell] += resting;
}

}  // namespace erg::models
