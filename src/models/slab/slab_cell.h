// The rules of one cell in one sub-sweep, for every executor that works in sub-sweeps: the CPU engine's kernels and a
// GPU's read the same functions, so both give the same bits. No state, no libm.
#pragma once

#include <cstdint>

#include "core/cell_rule.h"
#include "core/random.h"
#include "kernels/fixed_point.h"

namespace erg::models {

/// Cells: no hop grows shorter with the height of its ground than this, or than it is in this wind anyway.
inline constexpr double shortest_hop = 1.0;

/// A slab that has flown this many lengths of the grid lands wherever it is, so that chances of 0 cannot fly for ever.
inline constexpr int longest_flight = 16;

/// What a random byte in a sub-sweep is for.
enum class Draw : std::uint32_t { share, poll, hop, cover, inflow, first_landing, second_landing };

/// The random word of one row (or block of rows) of lines in a sub-sweep.
ERG_CELL_RULE std::uint64_t row_word(std::uint64_t sweep_word, std::uint32_t row) {
  return mix64(sweep_word + 0x9e3779b97f4a7c15u * (row + 1));
}

/// The key of one draw in a row. Landing draws of the third, fourth ... slab at a cell follow `second_landing`.
ERG_CELL_RULE std::uint32_t draw_key(std::uint64_t row_word, std::uint32_t draw) {
  return mix32(static_cast<std::uint32_t>(row_word >> (draw & 1 ? 32 : 0)) + draw * 0x85ebca6bu);
}
ERG_CELL_RULE std::uint32_t draw_key(std::uint64_t row_word, Draw draw) {
  return draw_key(row_word, static_cast<std::uint32_t>(draw));
}

/// Four random bytes: those of lines 4 * quad ... 4 * quad + 3.
ERG_CELL_RULE std::uint32_t quad_word(std::uint32_t key, std::uint32_t quad) { return mix32(key + quad * 0x9e3779b9u); }

/// The random byte of one line.
ERG_CELL_RULE std::uint32_t line_byte(std::uint32_t key, std::uint32_t line) {
  return (quad_word(key, line >> 2) >> (8 * (line & 3))) & 0xff;
}

/// Rows in which the hops of a line are rounded alike where all hops have the same length (rows_256 / 256): a draw for
/// each row would cost a twentieth of the sub-sweep. Never more than the whole rows of a hop: a slab that took off
/// twice among rows rounded alike would make more of the shorter hops than of the longer ones, and fly short on the
/// mean.
ERG_CELL_RULE int hop_rows_alike(std::uint32_t rows_256) {
  constexpr int most = 8;
  const int whole = static_cast<int>(rows_256 >> kernels::fixed_point_bits);
  return whole < 1 ? 1 : whole < most ? whole : most;
}

/// Keys the bytes (line_byte) that round such hops, for the slabs that leave this row.
ERG_CELL_RULE std::uint32_t hop_key(std::uint64_t sweep_word, std::uint32_t row, std::uint32_t rows_256) {
  return draw_key(row_word(sweep_word, row / static_cast<std::uint32_t>(hop_rows_alike(rows_256))), Draw::hop);
}

/// Further random bytes for the same lines, cheaper than a fresh word: from a quad's word of the first landing draw,
/// that of its second landing or of its hops.
ERG_CELL_RULE std::uint32_t next_word(std::uint32_t word, Draw draw) {
  word = (word ^ (word >> 15)) * (draw == Draw::hop ? 0x9e3779b1u : 0x85ebca77u);
  return word ^ (word >> 16);
}

/// A chance in 1/256, rounded at random with the row's own word so that its mean is exact: 0 never, 256 always.
ERG_CELL_RULE std::uint32_t byte_chance(std::uint32_t chance_16, std::uint64_t row_word) {
  return (chance_16 + static_cast<std::uint32_t>(row_word >> 56)) >> 8;
}

/// Raises a chance (of 256) to stay by the cell's cover: p + rho (1 - p).
ERG_CELL_RULE std::uint32_t covered_chance(std::uint32_t chance, std::uint32_t cover) {
  return chance + (cover * (256 - chance) >> 8);
}

/// Where line 0 stands in a row that may lie beyond the grid: floor((row * drift + phase) / length).
ERG_CELL_RULE std::int32_t line_offset(std::int64_t row, std::int64_t drift, std::int64_t phase, std::int64_t length) {
  const std::int64_t scaled = row * drift + phase;
  return static_cast<std::int32_t>(scaled >= 0 ? scaled / length : -((-scaled + length - 1) / length));
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

/// Rows of a hop whose length is `rows_256` / 256, rounded by a random byte. A hop of no row: the slab that was to lift
/// lies where it lay. A slab in the air comes down a row further on at the least (rows_on), so that a hop shorter than
/// a row is, for each slab lifted, as long on the mean as it should be.
ERG_CELL_RULE std::uint32_t hop_rows(std::uint32_t rows_256, std::uint32_t random_byte) {
  return (rows_256 + random_byte) >> 8;
}
ERG_CELL_RULE std::uint32_t rows_on(std::uint32_t hop_rows) { return hop_rows > 0 ? hop_rows : 1; }

}  // namespace erg::models
