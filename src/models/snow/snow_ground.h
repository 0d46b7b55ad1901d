// The rules of snow that lies: which edges slide, where falling snow comes to rest, how shadow lines run. For every
// executor; on the processor in the terrain's order, on a graphics card in the wind's frame.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/fixed_point.h"
#include "kernels/shadow_reach.h"
#include "models/snow/snow_cell.h"

namespace erg::models {

/// The layers that snow moves. Cell (u, v) of the wind's frame is cell origin + u * step_u + v * step_v of them.
struct SnowGround {
  int width = 0;
  int length = 0;
  bool torus = true;
  std::ptrdiff_t origin = 0;
  std::ptrdiff_t step_u = 1;
  std::ptrdiff_t step_v = 1;
  const std::int32_t* bedrock = nullptr;
  std::int32_t* mobile = nullptr;
  std::int32_t* loose = nullptr;
  float* landed = nullptr;

  ERG_CELL_RULE std::size_t cell(int u, int v) const {
    return static_cast<std::size_t>(origin + u * step_u + v * step_v);
  }
  ERG_CELL_RULE std::int32_t surface(std::size_t cell) const { return bedrock[cell] + mobile[cell]; }
  /// The number that a cell's random words are drawn with.
  ERG_CELL_RULE std::uint64_t number(int u, int v) const {
    return static_cast<std::uint64_t>(u) * static_cast<std::uint64_t>(length) + static_cast<std::uint64_t>(v);
  }
  /// Folds a place over the torus; false where it lies beyond an open edge.
  ERG_CELL_RULE bool fold(int& u, int& v) const {
    if (u >= 0 && u < width && v >= 0 && v < length) return true;
    if (!torus) return false;
    u = (u % width + width) % width;
    v = (v % length + length) % length;
    return true;
  }
};

/// The random word of a cell, from that of the step.
ERG_CELL_RULE std::uint64_t snow_cell_word(std::uint64_t step_word, std::uint64_t number) {
  return mix64(step_word + 0x9e3779b97f4a7c15u * (number + 1));
}

/// Slabs that fall on a cell in a step.
ERG_CELL_RULE int falling_slabs(const SnowLaw& law, std::uint64_t word) {
  return static_cast<int>(law.snowfall + unit_24(static_cast<std::uint32_t>(word)));
}

/// The lowest of the nine cells around a place, where snow that falls there comes to rest; of equals one at random.
ERG_CELL_RULE std::size_t lowest_of_nine(const SnowGround& ground, int u, int v, std::uint64_t word) {
  std::size_t lowest = ground.cell(u, v);
  for (int k = 0; k < 9; ++k) {
    const int turned = (k + static_cast<int>(word >> 32 & 0xff)) % 9;
    int near_u = u + turned / 3 - 1;
    int near_v = v + turned % 3 - 1;
    if (!ground.fold(near_u, near_v)) continue;
    const std::size_t near = ground.cell(near_u, near_v);
    if (ground.surface(near) < ground.surface(lowest)) lowest = near;
  }
  return lowest;
}

/// A loose slab slides over the edge between two cells if it is steeper than what stands; false if none does.
ERG_CELL_ACT bool slide_snow(const SnowGround& ground, std::size_t a, std::size_t b, const SnowLaw& law) {
  const std::int32_t difference = ground.surface(a) - ground.surface(b);
  if (difference <= law.critical_step && -difference <= law.critical_step) return false;
  const std::size_t from = difference > 0 ? a : b;
  const std::size_t to = difference > 0 ? b : a;
  if (ground.loose[from] <= 0) return false;
  --ground.mobile[from];
  --ground.loose[from];
  ++ground.mobile[to];
  ++ground.loose[to];
  ground.landed[to] = law.now;
  return true;
}

/// Factors of the slope along the wind: of the difference of a cell's two neighbours along the frame and across it.
struct SnowSlopes {
  double along;
  double across;
};
/// Half that difference is the slope in slabs a cell.
ERG_CELL_RULE SnowSlopes snow_slopes(const SnowLaw& law, double tangent, double cosine) {
  return {0.5 * cosine * law.slope_scale, 0.5 * tangent * cosine * law.slope_scale};
}

/// Shadow lines of a step. They follow the wind from row to row of its frame; heights and falls are in fixed point.
struct SnowShadow {
  std::int64_t fall_far = 0;   ///< a row
  std::int64_t fall_near = 0;  ///< to the next row, of the cell before alone
  std::int64_t tangent_24 = 0;
  int start = 0;  ///< the first row, before the grid on a torus, from which a
                  ///< shadow may still reach into it

  /// Columns that lines have moved sideways when they meet a row.
  ERG_CELL_RULE std::int64_t sideways(int row) const { return (row * tangent_24 + (std::int64_t{1} << 23)) >> 24; }
};

/// `fall`: of the shadow, slabs a cell; `relief`: slabs from the lowest surface to the highest.
ERG_CELL_RULE SnowShadow snow_shadow(double fall, double tangent, double cosine, bool open, int length, int relief) {
  return {kernels::fixed_point(fall / cosine), kernels::fixed_point(fall), static_cast<std::int64_t>(tangent * 0x1p24),
          open ? 0 : -kernels::shadow_reach(relief, fall, cosine, 2 * length)};
}

}  // namespace erg::models
