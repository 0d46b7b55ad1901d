// The rules of one cell of drifting, bonding snow, for every executor: how strongly the wind lifts it, where a slab
// that flies comes down, what an impact frees, how snow bonds. Plain arithmetic, no state, no libm.
#pragma once

#include <cstdint>

#include "core/cell_rule.h"
#include "core/random.h"

namespace erg::models {

/// A smooth function of a positive number, made once: eight places an octave, straight between them.
struct OctaveTable {
  static constexpr int octaves = 40;
  static constexpr int lowest_octave = -16;
  static constexpr int place_of_1 = -8 * lowest_octave;
  float values[8 * octaves + 1] = {};

  ERG_CELL_RULE float at(float x) const {
    constexpr int lowest = (127 + lowest_octave) << 23;
    constexpr int highest = ((127 + lowest_octave + octaves) << 23) - 1;
    const float positive = x > 0x1p-16f ? x : 0x1p-16f;
    const int bits = __builtin_bit_cast(int, positive);
    const int place = (bits < highest ? bits : highest) - lowest;
    const int index = place >> 20;
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
  int clearance_16 = 0;  ///< 1/16 slabs: ground higher than a slab's start by more ends its hop
  float hop_cells = 1;   ///< factor of the table of hops, cells
  float rest_loose = 0.6f;
  float rest_hard = 0.02f;
  float rest_ground = 0.02f;
  float suspension = 0;    ///< chance that a hop carries a slab away for good
  int critical_step = 16;  ///< slabs: loose snow slides down a larger step
  int wall = 16;           ///< slabs: bedrock standing higher than this over the ground before it stops slabs
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

/// Length of a hop in a local wind, cells. Longer hops than `longest_hop` are not counted further.
inline constexpr float longest_hop = 1000;
ERG_CELL_RULE float hop_cells(const SnowLaw& law, float speed) {
  const float cells = law.hop_cells * law.hop.at(law.friction * speed);
  return cells < longest_hop ? cells : longest_hop;
}

/// A chance as one of 65536, which 16 random bits are compared with.
ERG_CELL_RULE std::uint32_t chance_16(float chance) {
  const int scaled = static_cast<int>((chance < 1 ? chance : 1.0f) * 65536);
  return static_cast<std::uint32_t>(scaled < 65535 ? scaled : 65535);
}

/// Chance in 1/65536 that loose snow lifts in a step; `rest`: hours since it landed.
ERG_CELL_RULE std::uint32_t lift_chance(const SnowLaw& law, float speed, float rest) {
  const float age = rest > law.step_hours ? rest : law.step_hours;
  const float threshold = law.threshold + law.age_threshold.at(age);
  const float moving = law.friction * (speed > 0.001f ? speed : 0.001f);
  const float still = law.friction * (threshold > 1 ? threshold : 1.0f);
  const float excess = moving * moving - still * still;
  const float flux = still / moving * (excess > 0 ? excess : 0.0f);
  return chance_16(law.lift_scale * flux / hop_cells(law, speed));
}

/// How far the local wind is over what bonded snow withstands; 0 where it is not.
ERG_CELL_RULE float bonded_excess(const SnowLaw& law, float speed) {
  const float excess = speed * speed / (law.bonded_threshold * law.bonded_threshold) - 1;
  return excess > 0 ? excess : 0.0f;
}

/// Chance in 1/65536 that the wind alone frees and lifts a slab of bonded snow in a step. `hardness`: the law's
/// hardening of the snow's age, an hour at least.
ERG_CELL_RULE std::uint32_t entrainment_chance(const SnowLaw& law, float excess, float hardness) {
  return chance_16(law.entrainment * excess / hardness);
}

/// How readily impacts free snow of mean strength and of this hardness: the chance of a full hop's impact straight into
/// the surface, which may be over 1.
ERG_CELL_RULE float abrasion_power(const SnowLaw& law, float excess, float hardness) {
  return law.abrasion * excess / hardness;
}

/// The part of an impact's power that goes into the surface. `rise`: slabs from the cell upwind.
ERG_CELL_RULE float impact_share(const SnowLaw& law, float rise) {
  const float slope = rise * law.slope_scale;
  const float across = law.sine + slope * law.cosine;
  return across > 0 ? across * across / (1 + slope * slope) : 0.0f;
}

/// What a step's weather makes of a cell, packed so that a flight reads it at once. Fixed for the step.
struct TransportRates {
  std::uint32_t chances;  ///< to lift, of 65536: of loose snow in the lower half, of bonded snow in the upper
  std::uint32_t hops;  ///< mean hop in 1/64 rows, 0 where every slab stays; upper half: abrasion power, a short float
  std::int32_t over;   ///< surface over the smoothed surface, 1/16 slabs, at most `highest_over` either way
};
inline constexpr int highest_over = 32000;

/// The upper half of a float's bits, rounded: 8 binary digits.
ERG_CELL_RULE std::uint32_t short_float(float value) {
  return (__builtin_bit_cast(std::uint32_t, value) + 0x8000u) & 0xffff0000u;
}
ERG_CELL_RULE float abrasion_of(std::uint32_t hops) { return __builtin_bit_cast(float, hops & 0xffff0000u); }
ERG_CELL_RULE std::uint32_t mean_hop_64(std::uint32_t hops) { return hops & 0xffffu; }

/// What a cell's weather is made from.
struct SnowPlace {
  float level = 0;   ///< smoothed surface, slabs
  float around = 0;  ///< mean of its surroundings
  float slope = 0;   ///< of the smoothed surface along the wind
  std::int32_t surface = 0;
  float rest = 0;          ///< hours since a slab last landed
  float age = 0;           ///< of the bonded snow, h
  std::uint32_t dark = 0;  ///< 1 in the wind shadow
};

/// `rows`: of the wind's frame for one cell along the wind (the cosine of the wind's angle with the grid).
ERG_CELL_RULE TransportRates transport_rates(const SnowLaw& law, const SnowPlace& place, float rows) {
  const float speed = local_wind(law, place.level - place.around, place.slope);
  const std::uint32_t loose = lift_chance(law, speed, place.rest);
  const float excess = bonded_excess(law, speed);
  const float hardness = law.hardening.at(place.age);
  const std::uint32_t hard =
      entrainment_chance(law, excess, place.age > 1 ? hardness : law.hardening.values[OctaveTable::place_of_1]);
  const int hop_64 = static_cast<int>(hop_cells(law, speed) * rows * 64 + 0.5f);
  const float over = (static_cast<float>(place.surface) - place.level) * 16;
  const float bounded = over < highest_over ? (over > -highest_over ? over : -highest_over) : highest_over;
  TransportRates rates{};
  const std::uint32_t lit = place.dark - 1;  // all ones where light
  rates.chances = (loose | hard << 16) & lit;
  rates.hops =
      (static_cast<std::uint32_t>(hop_64 > 1 ? hop_64 : 1) & lit) | short_float(abrasion_power(law, excess, hardness));
  rates.over = static_cast<std::int32_t>(bounded);
  return rates;
}

/// Rows of a hop. Hops of one wind differ: half to one and a half times the mean, rounded at random; at least one.
ERG_CELL_RULE int snow_hop_rows(std::uint32_t hops, std::uint32_t random) {
  const std::uint32_t rows = (mean_hop_64(hops) * (128 + (random >> 24)) + (random & 0x3fff)) >> 14;
  return static_cast<int>(rows > 1 ? rows : 1);
}
ERG_CELL_RULE int longest_snow_hop(std::uint32_t mean_64) { return static_cast<int>((mean_64 * 384 >> 14) + 2); }

/// The share of a hop that is flown before higher ground ends it, of 256. A quotient of whole numbers below 2^24 whose
/// rows are fewer than 2^15 rounds down as that of whole numbers does.
ERG_CELL_RULE std::uint32_t share_of_hop(int flown, int whole) {
  return static_cast<std::uint32_t>(static_cast<int>(static_cast<float>(flown * 256) / static_cast<float>(whole)));
}

/// Height over the smoothed surface at which a slab that leaves here flies; higher ground ends its hop.
ERG_CELL_RULE int flying_height(int over, int clearance_16) {
  return over + clearance_16 < highest_over ? over + clearance_16 : highest_over;
}

/// Layer of the noise in which a height lies, and row in which a cell's row lies.
ERG_CELL_RULE int strength_layer(const SnowLaw& law, int height) {
  return static_cast<int>((static_cast<float>(height) + 16384.0f) * law.noise_by_slab);
}
ERG_CELL_RULE int strength_row(const SnowLaw& law, int y) {
  return static_cast<int>((static_cast<float>(y) + 0.5f) * law.noise_by_row);
}

/// Noise at a point of its lattice, which closes over the edges.
ERG_CELL_RULE float strength_point(const SnowLaw& law, int column, int row, int layer) {
  const std::uint64_t place =
      static_cast<std::uint64_t>(row < law.noise_rows ? row : row - law.noise_rows) << 40 ^
      static_cast<std::uint64_t>(column < law.noise_columns ? column : column - law.noise_columns) << 20 ^
      static_cast<std::uint64_t>(layer);
  return unit_24(static_cast<std::uint32_t>(mix64(law.noise_word ^ place) >> 40));
}

/// Noise between the points of the lattice, 0 to 1, stretched. `point(column, row, layer)`: as strength_point.
template <typename Point>
ERG_CELL_RULE float strength_noise(const SnowLaw& law, int x, int y, int height, const Point& point) {
  const float u = (static_cast<float>(x) + 0.5f) * law.noise_by_column;
  const float v = (static_cast<float>(y) + 0.5f) * law.noise_by_row;
  const float w = (static_cast<float>(height) + 16384.0f) * law.noise_by_slab;
  const int column = static_cast<int>(u);
  const int row = static_cast<int>(v);
  const int layer = static_cast<int>(w);
  const float share_u = u - static_cast<float>(column);
  const float share_v = v - static_cast<float>(row);
  const float share_w = w - static_cast<float>(layer);
  const auto part = [&](int right, int up, int deep) {
    return (right ? share_u : 1 - share_u) * (up ? share_v : 1 - share_v) * (deep ? share_w : 1 - share_w) *
           point(column + right, row + up, layer + deep);
  };
  const float sum = part(0, 0, 0) + part(1, 0, 0) + part(0, 1, 0) + part(1, 1, 0) + part(0, 0, 1) + part(1, 0, 1) +
                    part(0, 1, 1) + part(1, 1, 1);
  const float stretched = 0.5f + 2.0f * (sum - 0.5f);
  return stretched < 0 ? 0 : (stretched > 1 ? 1 : stretched);
}

/// Which of the two factors of strength a law has.
ERG_CELL_RULE bool has_noise(const SnowLaw& law) {
  return law.pattern == StrengthPattern::noise || law.pattern == StrengthPattern::both;
}
ERG_CELL_RULE bool has_layers(const SnowLaw& law) {
  return law.pattern == StrengthPattern::layers || law.pattern == StrengthPattern::both;
}

/// The factors of the strength of bonded snow in cell (x, y) of the terrain, `height` slabs over its bedrock: by the
/// noise, `point` as in strength_noise, and by the layer.
template <typename Point>
ERG_CELL_RULE float noise_strength(const SnowLaw& law, int x, int y, int height, const Point& point) {
  return law.strength_table[static_cast<int>(strength_noise(law, x, y, height, point) * 256)];
}
ERG_CELL_RULE float layer_strength(const SnowLaw& law, int height) {
  const auto layer = static_cast<std::uint64_t>(strength_layer(law, height));
  return law.strength_table[mix64(law.noise_word ^ ~layer) >> 56];
}

/// Strength of bonded snow in cell (x, y) of the terrain, `height` slabs over its bedrock; 1 is the mean.
ERG_CELL_RULE float snow_strength(const SnowLaw& law, int x, int y, int height) {
  const auto point = [&law](int column, int row, int layer) { return strength_point(law, column, row, layer); };
  float strength = 1;
  if (has_noise(law)) strength *= noise_strength(law, x, y, height, point);
  if (has_layers(law)) strength *= layer_strength(law, height);
  return strength;
}

/// Whether an impact of this power might free a slab of the weakest snow, for a drawn share: most need no look at the
/// noise of strength. It does where drawn * snow_strength < power.
ERG_CELL_RULE bool may_free(const SnowLaw& law, float drawn, float power) {
  return drawn * law.strength_table[0] * law.strength_table[0] < power;
}

/// Snow of a cell in a strip of lines: loose slabs, and all slabs in the upper half.
ERG_CELL_RULE std::uint32_t snow_word(std::int32_t loose, std::int32_t mobile) {
  return static_cast<std::uint32_t>(loose) | static_cast<std::uint32_t>(mobile) << 16;
}
ERG_CELL_RULE std::int32_t loose_of(std::uint32_t snow) { return static_cast<std::int32_t>(snow & 0xffff); }
ERG_CELL_RULE std::int32_t mobile_of(std::uint32_t snow) { return static_cast<std::int32_t>(snow >> 16); }

/// The snow of a cell from which a slab has lifted: a loose one where there is one.
ERG_CELL_RULE std::uint32_t without_slab(std::uint32_t snow) {
  return snow - ((snow & 0xffff) != 0 ? snow_word(1, 1) : snow_word(0, 1));
}

/// The chance of 65536 that a slab lifts here: of loose snow where there is any, else of bonded snow.
ERG_CELL_RULE std::uint32_t lift_chance_of(std::uint32_t snow, std::uint32_t chances) {
  const std::uint32_t hard = (snow >> 16) != 0 ? chances >> 16 : 0;
  return (snow & 0xffff) != 0 ? chances & 0xffff : hard;
}

/// Loose slabs that bond in a step, of `loose`, rounded by 24 random bits.
ERG_CELL_RULE int bonding_slabs(const SnowLaw& law, int loose, std::uint32_t random) {
  const float expected = static_cast<float>(loose) * law.bonding;
  const int whole = static_cast<int>(expected + unit_24(random));
  return whole < loose ? whole : loose;
}

/// Snow that rests in a cell.
struct RestingSnow {
  std::int32_t mobile;
  std::int32_t loose;
  float age;   ///< of the bonded part, h
  float rest;  ///< hours since a slab last landed
};

/// A step later: loose snow bonds from below; bonded snow grows older.
ERG_CELL_RULE RestingSnow rested(const SnowLaw& law, const RestingSnow& snow, std::uint32_t random) {
  const float bonded = static_cast<float>(snow.mobile - snow.loose);
  const float age = bonded > 0 ? snow.age + law.step_hours : 0.0f;
  const int bonding = bonding_slabs(law, snow.loose, random >> 8);
  const auto joining = static_cast<float>(bonding);
  const float together = bonded + joining;
  const float mixed = (age * bonded + (snow.rest + law.step_hours) * joining) / (together > 1 ? together : 1.0f);
  return {snow.mobile, snow.loose - bonding, bonding > 0 ? mixed : age, snow.rest};
}

}  // namespace erg::models
