// The rules of one cell of drifting, bonding snow, for every executor: how strongly the wind lifts it, where a slab
// that flies comes down, what an impact frees, when loose snow slides and bonds. Plain arithmetic, no state, no libm.
#pragma once

#include <bit>
#include <cstdint>

#include "core/cell_rule.h"
#include "core/random.h"

namespace erg {

/// A smooth function of a positive number, made once: eight places an octave, straight between them.
struct OctaveTable {
  static constexpr int octaves = 40;
  static constexpr int lowest_octave = -16;
  float values[8 * octaves + 1] = {};

  ERG_CELL_RULE float at(float x) const {
    constexpr std::uint32_t lowest = static_cast<std::uint32_t>(127 + lowest_octave) << 23;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    if (!(x > 0) || bits <= lowest) return values[0];
    const std::uint32_t place = bits - lowest;
    const std::uint32_t index = place >> 20;
    if (index >= 8 * octaves) return values[8 * octaves];
    const float share = static_cast<float>(place & 0xfffff) * 0x1p-20f;
    return values[index] + (values[index + 1] - values[index]) * share;
  }
};

/// Where the strength of bonded snow varies.
enum class StrengthPattern : std::uint8_t { even, noise, layers, both };

/// One step's snow and weather, in the units of cells, slabs and hours.
struct SnowLaw {
  // Wind.
  float wind = 10;                ///< m/s at 10 m
  float speed_by_height = 0.03f;  ///< growth of the local wind with the height over its surroundings, 1/slab
  float speed_by_slope = 4;       ///< the same with the slope
  float steepest_slope = 0.1f;
  float least_speed = 0.4f;  ///< of the wind over flat ground
  float most_speed = 1.8f;
  float friction = 0.0376f;  ///< friction velocity over the wind at 10 m
  // Loose snow.
  float threshold = 8;   ///< m/s at 10 m, of snow that landed an hour ago
  float lift_scale = 0;  ///< chance to lift = scale * u*t / u* * (u*^2 - u*t^2) / hop
  float clearance = 0;   ///< slabs: ground higher than a slab's start by more ends its hop
  float hop_cells = 1;   ///< factor of the table of hops, cells
  float rest_loose = 0.6f;
  float rest_hard = 0.02f;
  float rest_ground = 0.02f;
  float suspension = 0;  ///< chance that a hop carries a slab away for good
  int standing = 16;     ///< slabs: loose snow slides down a larger step
  int wall = 16;         ///< slabs: bedrock standing higher than this over the ground before it stops slabs
  // Bonded snow.
  float entrainment = 0;  ///< scale of the chance that the wind alone lifts bonded snow in a step
  float abrasion = 5;
  float bonded_threshold = 10;  ///< m/s
  float sine = 0.19f;           ///< of the angle at which slabs come down
  float cosine = 0.98f;
  float slope_scale = 0.05f;  ///< slab height over cell size
  float step_hours = 1.0f / 60;
  float bonding = 0.001f;  ///< chance that a loose slab bonds in a step
  float now = 0;           ///< hours since the beginning
  float snowfall = 0;      ///< slabs a cell and step
  // Strength.
  StrengthPattern pattern = StrengthPattern::noise;
  std::uint64_t noise_word = 0;
  int noise_columns = 1;  ///< lattice points over the grid
  int noise_rows = 1;
  float noise_by_column = 1;  ///< lattice points a cell
  float noise_by_row = 1;
  float noise_by_slab = 1;         ///< lattice points a slab of depth
  float strength_table[257] = {};  ///< of a noise from 0 to 1
  OctaveTable age_threshold;       ///< m/s, of hours since landing
  OctaveTable hop;                 ///< of the friction velocity
  OctaveTable hardening;           ///< of the age of bonded snow, h
};

/// A share from 0 to 1 of 24 random bits.
ERG_CELL_RULE float unit_24(std::uint32_t bits) { return static_cast<float>(bits & 0xffffff) * 0x1p-24f; }

/// The local wind, m/s. `over`: height of the smoothed surface over its surroundings, slabs; `slope`: rise along the
/// wind.
ERG_CELL_RULE float local_wind(const SnowLaw& law, float over, float slope) {
  const float bounded =
      slope > law.steepest_slope ? law.steepest_slope : (slope < -law.steepest_slope ? -law.steepest_slope : slope);
  const float factor = 1 + law.speed_by_height * over + law.speed_by_slope * bounded;
  return law.wind * (factor < law.least_speed ? law.least_speed : (factor > law.most_speed ? law.most_speed : factor));
}

/// Length of a hop in a local wind, cells.
ERG_CELL_RULE float hop_cells(const SnowLaw& law, float speed) {
  return law.hop_cells * law.hop.at(law.friction * speed);
}

/// Chance in 1/65536 that loose snow lifts in a step; `rest`: hours since it landed.
ERG_CELL_RULE std::uint32_t lift_chance(const SnowLaw& law, float speed, float rest) {
  const float age = rest > law.step_hours ? rest : law.step_hours;
  const float threshold = law.threshold + law.age_threshold.at(age);
  if (!(speed > threshold)) return 0;
  const float moving = law.friction * speed;
  const float still = threshold > 1 ? law.friction * threshold : law.friction;
  const float flux = still / moving * (moving * moving - still * still);
  const float chance = law.lift_scale * flux / hop_cells(law, speed);
  return chance < 1 ? static_cast<std::uint32_t>(chance * 65536) : 65536u;
}

/// Chance in 1/65536 that the wind alone frees and lifts a slab of bonded snow of this age (h) in a step.
ERG_CELL_RULE std::uint32_t entrainment_chance(const SnowLaw& law, float speed, float age) {
  const float excess = speed * speed / (law.bonded_threshold * law.bonded_threshold) - 1;
  if (!(excess > 0)) return 0;
  const float chance = law.entrainment * excess / law.hardening.at(age > 1 ? age : 1);
  return chance < 1 ? static_cast<std::uint32_t>(chance * 65536) : 65536u;
}

/// Noise of a lattice that closes over the edges, 0 to 1, stretched.
ERG_CELL_RULE float strength_noise(const SnowLaw& law, int x, int y, int height) {
  const float u = (static_cast<float>(x) + 0.5f) * law.noise_by_column;
  const float v = (static_cast<float>(y) + 0.5f) * law.noise_by_row;
  const float w = (static_cast<float>(height) + 16384.0f) * law.noise_by_slab;
  const int column = static_cast<int>(u);
  const int row = static_cast<int>(v);
  const int layer = static_cast<int>(w);
  float sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int c = column + (corner & 1);
    const int r = row + (corner >> 1 & 1);
    const int l = layer + (corner >> 2);
    const float share_u = corner & 1 ? u - static_cast<float>(column) : 1 - (u - static_cast<float>(column));
    const float share_v = corner & 2 ? v - static_cast<float>(row) : 1 - (v - static_cast<float>(row));
    const float share_w = corner & 4 ? w - static_cast<float>(layer) : 1 - (w - static_cast<float>(layer));
    const std::uint64_t place = static_cast<std::uint64_t>(r % law.noise_rows) << 40 ^
                                static_cast<std::uint64_t>(c % law.noise_columns) << 20 ^ static_cast<std::uint64_t>(l);
    sum += share_u * share_v * share_w * unit_24(static_cast<std::uint32_t>(mix64(law.noise_word ^ place) >> 40));
  }
  const float stretched = 0.5f + 2.0f * (sum - 0.5f);
  return stretched < 0 ? 0 : (stretched > 1 ? 1 : stretched);
}

/// Strength of bonded snow in cell (x, y) of the terrain, `height` slabs over its bedrock; 1 is the mean.
ERG_CELL_RULE float snow_strength(const SnowLaw& law, int x, int y, int height) {
  float strength = 1;
  if (law.pattern == StrengthPattern::noise || law.pattern == StrengthPattern::both) {
    strength *= law.strength_table[static_cast<int>(strength_noise(law, x, y, height) * 256)];
  }
  if (law.pattern == StrengthPattern::layers || law.pattern == StrengthPattern::both) {
    const auto layer = static_cast<std::uint64_t>((static_cast<float>(height) + 16384.0f) * law.noise_by_slab);
    strength *= law.strength_table[mix64(law.noise_word ^ ~layer) >> 56];
  }
  return strength;
}

/// Chance that an impact frees a bonded slab. `rise`: slabs from the cell upwind; `flown`: share of the hop; `age`: h.
ERG_CELL_RULE float abrasion_chance(const SnowLaw& law, float speed, float rise, float flown, float age,
                                    float strength) {
  const float excess = speed * speed / (law.bonded_threshold * law.bonded_threshold) - 1;
  if (!(excess > 0)) return 0;
  const float slope = rise * law.slope_scale;
  const float across = law.sine + slope * law.cosine;
  if (!(across > 0)) return 0;
  const float square = across * across / (1 + slope * slope);
  return law.abrasion * square * excess * flown / (law.hardening.at(age) * strength);
}

/// Loose slabs that bond in a step, of `loose`, rounded by 24 random bits.
ERG_CELL_RULE int bonding_slabs(const SnowLaw& law, int loose, std::uint32_t random) {
  const float expected = static_cast<float>(loose) * law.bonding;
  const int whole = static_cast<int>(expected + unit_24(random));
  return whole < loose ? whole : loose;
}

}  // namespace erg
