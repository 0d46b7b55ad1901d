// The kernels of sintering snow, compiled once for each instruction set into its own namespace (ERG_KERNELS). To keep
// the copies apart nothing here calls an inline function of the library; the shared cell rules are forced inline.

#include <cstdint>

#include "transport/snow_sweep.h"

namespace erg {
namespace ERG_KERNELS {
namespace {

// A loop over neighbouring cells. The count is copied first, so that the compiler need not read it again.
#define ERG_EACH(i, count) _Pragma("GCC ivdep") for (int i = 0, end_of_##i = (count); i < end_of_##i; ++i)

std::uint32_t weather(const SnowLaw& given_law, const SnowWeatherRow& row) {
  const SnowLaw law = given_law;  // a copy, which no store of the loop can change
  const float* __restrict level = row.level;
  const float* __restrict around = row.around;
  const float* __restrict landed = row.landed;
  const float* __restrict age = row.age;
  const std::uint32_t* __restrict surface = row.surface;
  const std::uint8_t* __restrict dark = row.dark;
  const float* __restrict west = row.west;
  const float* __restrict east = row.east;
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
                          .slope = by_x * (east[i] - west[i]) + by_y * (north[i] - south[i]),
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

void poll(const SnowPolls& polls) {
  alignas(64) std::uint32_t row[snow_lines];
  alignas(64) std::uint32_t lifts[snow_lines];
  const std::uint32_t* __restrict polled_row = polls.polled_row;
  const SnowCell* __restrict cells = polls.cells;
  const std::uint32_t key = polls.key;
  const std::uint32_t first_line = polls.first_line;
  const std::uint32_t chance_key = polls.chance_key;
  const auto rows = static_cast<std::uint32_t>(polls.rows);
  const int next_row = polls.next_row;
  const int next_line = polls.next_line;
  ERG_EACH(i, polls.lines) {
    const std::uint32_t word = snow_poll_word(key, first_line + static_cast<std::uint32_t>(i));
    const std::uint32_t at = polled_row[static_cast<int>(word >> 24)];
    const bool within = at < rows;
    const int cell = static_cast<int>(within ? at : 0) * next_row + i * next_line;
    row[i] = within ? at : 0;
    lifts[i] = within && snow_lifts(word, chance_key, cells[cell].snow, cells[cell].chances) ? 1 : 0;
  }
  for (int i = 0; i < polls.lines; ++i) polls.lifts[row[i]] |= static_cast<std::uint64_t>(lifts[i]) << i;
}

void find_runs(const std::int16_t* over, int next_row, int clearance_16, int reach, SnowCell* cells, int count) {
  alignas(64) std::int16_t height[64];
  alignas(64) std::int16_t run[64];
  const std::int16_t* __restrict from = over;
  ERG_EACH(i, 64) {
    height[i] = static_cast<std::int16_t>(flying_height(from[i], clearance_16));
    run[i] = unhindered_run;
  }
  for (int k = reach; k > 0; --k) {
    const std::int16_t* __restrict ahead = over + k * next_row;
    const auto rows = static_cast<std::int16_t>(k);
    ERG_EACH(i, 64) run[i] = ahead[i] > height[i] ? rows : run[i];
  }
  for (int i = 0; i < count; ++i) cells[i].run = run[i];
}

bool any_steep(const std::int32_t* ground_a, const std::int32_t* snow_a, const std::int32_t* ground_b,
               const std::int32_t* snow_b, int count, int step) {
  std::int32_t steep = 0;
  if (ground_a == nullptr) {
    ERG_EACH(i, count) {
      const std::int32_t difference = snow_a[i] - snow_b[i];
      steep |= (difference > step ? 1 : 0) | (difference < -step ? 1 : 0);
    }
    return steep != 0;
  }
  ERG_EACH(i, count) {
    const std::int32_t difference = ground_a[i] + snow_a[i] - ground_b[i] - snow_b[i];
    steep |= (difference > step ? 1 : 0) | (difference < -step ? 1 : 0);
  }
  return steep != 0;
}

void strength(const SnowLaw& given_law, int y, const std::int32_t* __restrict mobile,
              const std::int32_t* __restrict loose, float* __restrict strength, int count) {
  const SnowLaw law = given_law;
  ERG_EACH(x, count) strength[x] = snow_strength(law, x, y, mobile[x] - loose[x]);
}

#undef ERG_EACH

}  // namespace

extern const SnowKernels snow_kernels;
const SnowKernels snow_kernels{weather, rest, poll, find_runs, any_steep, strength};

}  // namespace ERG_KERNELS
}  // namespace erg
