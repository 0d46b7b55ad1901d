// The kernels of sintering snow, compiled once for each instruction set into its own namespace (ERG_KERNELS). To keep
// the copies apart nothing here calls an inline function of the library; the shared cell rules are forced inline.

#include <cstdint>

#if defined(__AVX512BW__)
#include <immintrin.h>
#endif

#include "kernels/each_lane.h"
#include "kernels/fixed_point.h"
#include "models/snow/snow_sweep.h"

namespace erg {
namespace ERG_KERNELS {
namespace {

/// 64 bytes, each 0 or 1, as bits.
[[gnu::always_inline]] inline std::uint64_t bits_of(const std::uint8_t* bytes) {
#if defined(__AVX512BW__)
  const __m512i all = _mm512_loadu_si512(bytes);
  return _mm512_test_epi8_mask(all, all);
#else
  std::uint64_t bits = 0;
  for (int k = 0; k < 8; ++k) {
    std::uint64_t eight = 0;
    __builtin_memcpy(&eight, bytes + 8 * k, 8);
    bits |= (eight * 0x0102040810204080u >> 56) << (8 * k);  // one bit of each byte
  }
  return bits;
#endif
}

std::uint32_t weather(const SnowLaw& given_law, const SnowWeatherRow& row) {
  const SnowLaw law = given_law;  // a copy, which no store of the loop can change
  const float* __restrict level = row.level;
  const float* __restrict around = row.around;
  const float* __restrict landed = row.landed;
  const float* __restrict age = row.age;
  const std::uint16_t* __restrict surface = row.surface;
  const std::uint8_t* __restrict dark = row.dark;
  const float* __restrict south = row.south;
  const float* __restrict north = row.north;
  std::uint32_t* __restrict chances = row.chances;
  std::uint32_t* __restrict hops = row.hops;
  std::int16_t* __restrict over = row.over;
  const float by_x = row.slope_by_x;
  const float by_y = row.slope_by_y;
  const float rows = row.rows;
  std::uint32_t longest = 0;
  ERG_EACH(i, row.count) {
    const SnowPlace place{.level = level[i],
                          .around = around[i],
                          .slope = by_x * (level[i + 1] - level[i - 1]) + by_y * (north[i] - south[i]),
                          .surface = static_cast<std::int32_t>(surface[i]),
                          .rest = law.now - landed[i],
                          .age = age[i],
                          .dark = dark[i]};
    const SnowWeather made = snow_weather(law, place, rows);
    chances[i] = made.chances;
    hops[i] = made.hops;
    over[i] = static_cast<std::int16_t>(made.over);
    const std::uint32_t mean = mean_hop_64(made.hops);
    longest = mean > longest ? mean : longest;
  }
  return longest;
}

void rest(const SnowLaw& law, const SnowRestRow& row) {
  const std::int32_t* __restrict mobile = row.mobile;
  const float* __restrict landed = row.landed;
  std::int32_t* __restrict loose = row.loose;
  float* __restrict age = row.age;
  float* __restrict shown_loose = row.shown_loose;
  float* __restrict shown_bonded = row.shown_bonded;
  const std::uint32_t key = row.key + row.number * 0x9e3779b9u;
  const std::uint32_t next_key = row.next_number * 0x9e3779b9u;
  ERG_EACH(i, row.count) {
    const RestingSnow before{mobile[i], loose[i], age[i], law.now - landed[i]};
    const RestingSnow after = rested(law, before, mix32(key + static_cast<std::uint32_t>(i) * next_key));
    loose[i] = after.loose;
    age[i] = after.age;
    shown_loose[i] = static_cast<float>(after.loose);
    shown_bonded[i] = static_cast<float>(mobile[i] - after.loose);
  }
}

std::uint64_t find_steep(const std::int32_t* ground_a, const std::int32_t* snow_a, const std::int32_t* ground_b,
                         const std::int32_t* snow_b, int count, int step) {
  alignas(64) std::uint8_t steep[64] = {};
  if (ground_a == nullptr) {
    ERG_EACH(i, count) {
      const std::int32_t difference = snow_a[i] - snow_b[i];
      steep[i] = (difference > step ? 1 : 0) | (difference < -step ? 1 : 0);
    }
  } else {
    ERG_EACH(i, count) {
      const std::int32_t difference = ground_a[i] + snow_a[i] - ground_b[i] - snow_b[i];
      steep[i] = (difference > step ? 1 : 0) | (difference < -step ? 1 : 0);
    }
  }
  return bits_of(steep);
}

/// The same for blocks of 64 of any number of surfaces: whether one of each is steep. Few are; most need no closer
/// look.
void find_steep_blocks(const std::int32_t* __restrict ground_a, const std::int32_t* __restrict snow_a,
                       const std::int32_t* __restrict ground_b, const std::int32_t* __restrict snow_b, int count,
                       int step, std::uint8_t* __restrict blocks) {
  const auto most = 2 * static_cast<std::uint32_t>(step);
  for (int first = 0; first < count; first += 64) {
    const int end = count - first < 64 ? count : first + 64;
    std::uint32_t steep = 0;
    if (ground_a == nullptr) {
      for (int i = first; i < end; ++i) {
        steep |= static_cast<std::uint32_t>(snow_a[i] - snow_b[i] + step) > most ? 1 : 0;
      }
    } else {
      for (int i = first; i < end; ++i) {
        steep |= static_cast<std::uint32_t>(ground_a[i] + snow_a[i] - ground_b[i] - snow_b[i] + step) > most ? 1 : 0;
      }
    }
    blocks[first / 64] = static_cast<std::uint8_t>(steep);
  }
}

// --- strength ---

/// Draws the lattice for the rows of the terrain between two of its own, and some layers.
void draw_lattice(const SnowLaw& law, int row, int lowest, StrengthLattice& lattice) {
  lattice.row = row;
  lattice.lowest = lowest;
  float* place = lattice.points;
  for (int r = row; r <= row + 1; ++r) {
    for (int c = 0; c <= law.noise_columns; ++c, place += StrengthLattice::layers) {
      float* __restrict points = place;
      ERG_EACH(l, StrengthLattice::layers) points[l] = strength_point(law, c, r, lowest + l);
    }
  }
}

void strength(const SnowLaw& given_law, const SnowStrengthRow& row, StrengthLattice& lattice) {
  const SnowLaw law = given_law;  // a copy, which no store of the loops can change
  const std::int32_t* __restrict mobile = row.mobile;
  const std::int32_t* __restrict loose = row.loose;
  float* __restrict strength = row.strength;
  const int y = row.y;
  std::int32_t lowest = 0x7fffffff;
  std::int32_t highest = 0;
  ERG_EACH(x, row.count) {
    const std::int32_t layer = strength_layer(law, mobile[x] - loose[x]);
    lowest = layer < lowest ? layer : lowest;
    highest = layer > highest ? layer : highest;
  }
  const int at = strength_row(law, y);
  if (!has_noise(law)) {
    ERG_EACH(x, row.count) strength[x] = 1;
  } else if (highest + 1 >= lowest + StrengthLattice::layers) {
    const auto point = [&law](int c, int r, int l) { return strength_point(law, c, r, l); };
    ERG_EACH(x, row.count) strength[x] = noise_strength(law, x, y, mobile[x] - loose[x], point);
  } else {
    if (at != lattice.row || lowest < lattice.lowest || highest + 1 >= lattice.lowest + StrengthLattice::layers) {
      draw_lattice(law, at, lowest, lattice);
    }
    const float* __restrict points = lattice.points;
    const int next_row = (law.noise_columns + 1) * StrengthLattice::layers;
    const auto point = [points, next_row, at, low = lattice.lowest](int c, int r, int l) {
      return points[(r - at) * next_row + c * StrengthLattice::layers + l - low];
    };
    ERG_EACH(x, row.count) strength[x] = noise_strength(law, x, y, mobile[x] - loose[x], point);
  }
  if (!has_layers(law)) return;
  ERG_EACH(x, row.count) strength[x] *= layer_strength(law, mobile[x] - loose[x]);
}

// --- surface ---

void survey(const std::int32_t* __restrict bedrock, const std::int32_t* __restrict mobile, int count,
            SnowHeights& heights) {
  SnowHeights all = heights;
  ERG_EACH(i, count) {
    const std::int32_t here = bedrock[i] + mobile[i];
    all.lowest = here < all.lowest ? here : all.lowest;
    all.highest = here > all.highest ? here : all.highest;
    all.most_snow = mobile[i] > all.most_snow ? mobile[i] : all.most_snow;
    all.uneven |= bedrock[i] ^ all.level;
  }
  heights = all;
}

void raise(const std::int32_t* __restrict bedrock, const std::int32_t* __restrict mobile, int low,
           std::uint16_t* __restrict height, int count) {
  ERG_EACH(i, count) height[i] = static_cast<std::uint16_t>(bedrock[i] + mobile[i] - low);
}

void shade(const SnowShadowRow& row) {
  const std::uint16_t* __restrict surface = row.surface;
  std::int32_t* __restrict far = row.far;
  std::int32_t* __restrict near = row.near;
  std::uint8_t* __restrict dark = row.dark;
  const std::int32_t fall_far = row.fall_far;
  const std::int32_t fall_near = row.fall_near;
  ERG_EACH(i, row.count) {
    const std::int32_t height = std::int32_t{surface[i]} << fixed_point_bits;
    const std::int32_t shadow = far[i] > near[i] ? far[i] : near[i];
    dark[i] = height < shadow ? 1 : 0;
    far[i] = (height > far[i] ? height : far[i]) - fall_far;
    near[i] = height - fall_near;
  }
}

template <typename Sum, typename Number>
void add_row(const Number* __restrict entering, const Number* __restrict leaving, Sum* __restrict columns, int count) {
  if (leaving == nullptr) {
    ERG_EACH(i, count) columns[i] += static_cast<Sum>(entering[i]);
    return;
  }
  ERG_EACH(i, count) columns[i] += static_cast<Sum>(entering[i]) - static_cast<Sum>(leaving[i]);
}

/// Sums of 1, 2, 4 ... neighbours, each from the last; those that together make up the window are added.
template <typename Sum>
void add_up(Sum* __restrict columns, Sum* __restrict sums, int count, int window) {
  int done = 0;
  for (int size = 1; size <= window; size *= 2) {
    if ((window & size) != 0) {
      const Sum* __restrict from = columns + done;
      if (done == 0) {
        ERG_EACH(i, count) sums[i] = from[i];
      } else {
        ERG_EACH(i, count) sums[i] += from[i];
      }
      done += size;
    }
    if (done == window) return;
    const int left = count + window - 2 * size;
    const Sum* ahead = columns + size;
    ERG_EACH(i, left) columns[i] += ahead[i];
  }
}

template <typename Sum, typename Signed>
void average(const Sum* __restrict sums, float share, float* __restrict means, int count) {
  ERG_EACH(i, count) means[i] = static_cast<float>(static_cast<Signed>(sums[i])) * share;
}

#include "models/snow/snow_exchange.inl"
#include "models/snow/snow_flight.inl"

#undef ERG_EACH

}  // namespace

extern const SnowKernels snow_kernels;
const SnowKernels snow_kernels{weather,
                               rest,
                               draw_polls,
                               lift,
                               launch,
                               land,
                               draw_rows,
                               take_snow,
                               give_snow,
                               find_steep,
                               find_steep_blocks,
                               strength,
                               survey,
                               raise,
                               shade,
                               {add_row<std::uint32_t, std::uint16_t>, add_row<std::uint32_t, std::uint32_t>,
                                add_up<std::uint32_t>, average<std::uint32_t, std::int32_t>},
                               {add_row<std::uint64_t, std::uint16_t>, add_row<std::uint64_t, std::uint64_t>,
                                add_up<std::uint64_t>, average<std::uint64_t, std::int64_t>}};

}  // namespace ERG_KERNELS
}  // namespace erg
