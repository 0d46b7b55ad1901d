// The rules of one cell in one sub-sweep, for every executor that works in sub-sweeps: those of slab_cell.k, the same
// for the engine's words of 64 bits, and the lengths of hops, which only the host computes. No state, no libm.
#pragma once

#include <cstdint>

#include "core/cell_rule.h"
#include "core/random.h"
#include "kernels/fixed_point.h"

namespace erg::models {

#include "models/slab/slab_cell.k"

/// Cells: no hop grows shorter with the height of its ground than this, or than it is in this wind anyway.
inline constexpr double shortest_hop = 1.0;

/// The draws by name.
enum class Draw : u32 {
  share = draw_share,
  poll = draw_poll,
  hop = draw_hop,
  cover = draw_cover,
  inflow = draw_inflow,
  first_landing = draw_first_landing,
  second_landing = draw_second_landing
};

// --- the same rules of words of 64 bits ---

ERG_CELL_RULE std::uint64_t row_word(std::uint64_t sweep_word, std::uint32_t row) {
  return mix64(sweep_word + 0x9e3779b97f4a7c15u * (row + 1));
}
ERG_CELL_RULE std::uint32_t draw_key(std::uint64_t row_word, std::uint32_t draw) {
  return half_key(static_cast<std::uint32_t>(row_word >> (draw & 1 ? 32 : 0)), draw);
}
ERG_CELL_RULE std::uint32_t draw_key(std::uint64_t row_word, Draw draw) {
  return draw_key(row_word, static_cast<std::uint32_t>(draw));
}
ERG_CELL_RULE std::uint32_t next_word(std::uint32_t word, Draw draw) {
  return next_word(word, static_cast<std::uint32_t>(draw));
}
ERG_CELL_RULE std::uint32_t hop_key(std::uint64_t sweep_word, std::uint32_t row, std::uint32_t rows_256) {
  return draw_key(row_word(sweep_word, row / static_cast<std::uint32_t>(hop_rows_alike(rows_256))), Draw::hop);
}
ERG_CELL_RULE std::uint32_t byte_chance(std::uint32_t chance_16, std::uint64_t row_word) {
  return (chance_16 + static_cast<std::uint32_t>(row_word >> 56)) >> 8;
}

/// How a hop grows with the height of the ground (HopLaw), on rows that are 1 / cosine cells long.
struct HopCurve {
  double strength = 0;
  double linear = 0;
  double quadratic = 0;
  double cosine = 1;
  double rounding = 0;     ///< in [0, 1): the step's own (hop_rounding), so that lengths are exact on the mean of steps
  double most_rows = 1e9;  ///< most_hop_rows
};

/// Rows that a hop grows to at most, however high its ground: `longest_flight` lengths of the grid, or the wind's own
/// hop where that is longer.
ERG_CELL_RULE double most_hop_rows(double strength, double cosine, int length) {
  const double around = static_cast<double>(longest_flight) * length;
  return around > strength * cosine ? around : strength * cosine;
}

/// Cells of a hop from ground this high (slabs) over the reference, before the shortest hop bounds it.
ERG_CELL_RULE double hop_cells(double strength, double linear, double quadratic, double above_reference) {
  double length = strength + linear * above_reference;
  if (above_reference > 0) length += quadratic * above_reference * above_reference;
  const double shortest = strength < shortest_hop ? strength : shortest_hop;
  return length > shortest ? length : shortest;
}

/// The same in rows * 256: 1 at least.
ERG_CELL_RULE std::uint32_t hop_rows_256(const HopCurve& curve, double above_reference) {
  const double rows = hop_cells(curve.strength, curve.linear, curve.quadratic, above_reference) * curve.cosine;
  const double kept = rows < curve.most_rows ? rows : curve.most_rows;
  const auto rows_256 = static_cast<std::int64_t>(kept * (1 << kernels::fixed_point_bits) + curve.rounding);
  return static_cast<std::uint32_t>(rows_256 > 1 ? rows_256 : 1);
}

}  // namespace erg::models
