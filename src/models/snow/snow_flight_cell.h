// The rules of slabs of snow in flight, for every executor that works in sub-sweeps: who lifts, how far a slab hops,
// what becomes of those that come down. Plain arithmetic, no state, no libm.
#pragma once

#include <cstdint>

#include "models/snow/snow_cell.h"

namespace erg::models {

/// A cell of a line on a graphics card, held together because a slab that lifts or comes down needs all of it. The
/// processor's strips find out what lifts beforehand and keep less (StripCell).
struct alignas(16) SnowCell {
  std::uint32_t snow = 0;     ///< snow_word
  std::uint32_t chances = 0;  ///< TransportRates
  std::uint32_t hops = 0;
  std::int16_t run = 0;     ///< rows that a slab can fly from here before higher
                            ///< ground ends its hop
  std::int16_t landed = 0;  ///< 1: a slab has come to rest here in this step
};
inline constexpr std::int16_t unhindered_run = 0x7fff;
inline constexpr std::int16_t over_wall = 0x7fff;  ///< a height over the smoothed surface that no slab flies at

/// What is drawn for one sub-sweep.
struct SnowSweep {
  bool polls = true;
  bool last = false;           ///< whatever comes down stays
  std::uint32_t step_key = 0;  ///< the same for all sub-sweeps of a step
  std::uint32_t key = 0;
  std::uint32_t polled_row[256] = {};  ///< of a block of K rows, for each random byte
};

// --- random words ---

/// Of a row, for what lifts there; what comes down takes the complement. That of a line in it: snow_line_word.
ERG_CELL_RULE std::uint64_t flight_row_word(std::uint32_t sweep_key, int row) {
  return mix64((std::uint64_t{sweep_key} << 32) + static_cast<std::uint64_t>(row));
}
/// Of a line in a row, from flight_row_word.
ERG_CELL_RULE std::uint64_t snow_line_word(std::uint64_t row_word, int line) {
  return mix64(row_word + static_cast<std::uint64_t>(line));
}
/// A further word.
ERG_CELL_RULE std::uint32_t next_snow_word(std::uint32_t word) { return mix32(word + 0x85ebca6bu); }

/// The key of the polls of a block of rows that begins at `row`: one permutation of its rows for all sub-sweeps of the
/// step. The upper byte of a line's word says which row of the block is polled.
ERG_CELL_RULE std::uint32_t snow_poll_key(const SnowSweep& sweep, int row) {
  return mix32(sweep.step_key + static_cast<std::uint32_t>(row) * 0x9e3779b9u);
}
ERG_CELL_RULE std::uint32_t snow_poll_word(std::uint32_t poll_key, std::uint32_t line) {
  return mix32(poll_key + line * 0x9e3779b9u);
}

// --- lifting ---

/// The share of 65536 that is drawn for a polled cell; below its chance a slab lifts. `sweep_key`: chances are the
/// sub-sweep's own.
ERG_CELL_RULE std::uint32_t snow_poll_draw(std::uint32_t poll_word, std::uint32_t sweep_key) {
  return mix32(poll_word ^ sweep_key) >> 16;
}
ERG_CELL_RULE bool snow_lifts(std::uint32_t poll_word, std::uint32_t sweep_key, std::uint32_t snow,
                              std::uint32_t chances) {
  return snow_poll_draw(poll_word, sweep_key) < lift_chance_of(snow, chances);
}

// --- flying ---

/// Slabs that come down in a cell together: how many, and in the lower half the shares of hops that they flew, each of
/// `whole_hop`.
inline constexpr std::uint64_t one_slab = std::uint64_t{1} << 32;
inline constexpr std::uint32_t whole_hop = 256;
ERG_CELL_RULE std::uint32_t slabs_of(std::uint64_t load) { return static_cast<std::uint32_t>(load >> 32); }

/// A hop: rows to where a slab comes down, and what it adds to the load there.
struct SnowHop {
  int rows;
  std::uint64_t load;
};
ERG_CELL_RULE SnowHop snow_hop(std::uint32_t hops, int run, std::uint32_t random) {
  const int rows = snow_hop_rows(hops, random);
  const int flown = run < rows ? run : rows;
  return {flown, one_slab + share_of_hop(flown, rows)};
}

/// Slabs that enter a line of an open grid in a sub-sweep; `inflow`: of a step.
ERG_CELL_RULE int entering_slabs(double inflow, int sweeps, std::uint32_t word) {
  return static_cast<int>(inflow / sweeps + static_cast<double>(unit_24(word >> 8)));
}
ERG_CELL_RULE std::uint32_t entering_word(const SnowSweep& sweep, int line) {
  return mix32(sweep.key ^ mix32(static_cast<std::uint32_t>(line) * 0x9e3779b9u + 1));
}
/// Rows to where a slab that enters over this cell comes down: where in its hop it crosses the edge is random.
ERG_CELL_RULE int entering_rows(std::uint32_t hops, int run, std::uint32_t word) {
  if (mean_hop_64(hops) == 0) return 0;
  const std::uint32_t part = mean_hop_64(hops) * (word >> 16) >> 16;
  const int rows = snow_hop_rows(part, next_snow_word(word ^ 0x9e3779b9u));
  return rows < run ? rows : run;
}

// --- coming down ---

/// Chances of 65536 that a slab stays, or is carried off.
struct SnowRests {
  std::uint32_t loose = 0;
  std::uint32_t hard = 0;
  std::uint32_t ground = 0;
  std::uint32_t suspension = 0;
};
inline constexpr std::uint32_t certain = 65536;

ERG_CELL_RULE std::uint32_t rest_16(float share) {
  return static_cast<std::uint32_t>((share > 0 ? (share < 1 ? share : 1.0f) : 0.0f) * 65536);
}
ERG_CELL_RULE SnowRests snow_rests(const SnowLaw& law) {
  return {rest_16(law.rest_loose), rest_16(law.rest_hard), rest_16(law.rest_ground), rest_16(law.suspension)};
}

/// The chance to stay on what slabs find; all stay in the shadow.
ERG_CELL_RULE std::uint32_t chance_to_stay(const SnowRests& rests, std::uint32_t snow, std::uint32_t hops) {
  if (mean_hop_64(hops) == 0) return certain;
  return loose_of(snow) > 0 ? rests.loose : (mobile_of(snow) > 0 ? rests.hard : rests.ground);
}
ERG_CELL_RULE bool snow_stays(std::uint64_t word, std::uint32_t chance) { return (word & 0xffff) < chance; }
ERG_CELL_RULE bool snow_carried_off(std::uint64_t word, const SnowRests& rests) {
  return (word >> 16 & 0xffff) < rests.suspension;
}

/// The power with which each slab of a load strikes bonded snow. `rise`: slabs from the cell upwind.
ERG_CELL_RULE float strike_power(const SnowLaw& law, std::uint32_t hops, std::uint64_t load, float rise) {
  const float flown =
      static_cast<float>(static_cast<std::uint32_t>(load)) / static_cast<float>(slabs_of(load) * whole_hop);
  return abrasion_of(hops) * impact_share(law, rise) * flown;
}

/// How many slabs of bonded snow the impacts of a load free, if there are so many. `landing_word`: the line's word for
/// what comes down; `strength()`: of the uppermost bonded snow, looked up only where it matters.
template <typename Strength>
ERG_CELL_RULE std::int32_t freed_slabs(const SnowLaw& law, std::uint64_t load, std::uint64_t landing_word, float power,
                                       const Strength& strength) {
  if (power <= 0) return 0;
  std::uint32_t word = mix32(static_cast<std::uint32_t>(landing_word >> 32));
  std::int32_t freed = 0;
  for (std::uint32_t slab = 0; slab < slabs_of(load); ++slab) {
    const float drawn = unit_24(word);
    word = next_snow_word(word);
    if (may_free(law, drawn, power) && drawn * strength() < power) ++freed;
  }
  return freed;
}

}  // namespace erg::models
