// The kernels of sintering snow, compiled once for each instruction set into its own namespace (ERG_KERNELS). To keep
// the copies apart nothing here calls an inline function of the library; the shared cell rules are forced inline.

#include <cstdint>

#include "kernels/each_lane.h"
#include "models/snow/snow_planes.h"

namespace erg::models {
namespace ERG_KERNELS {
namespace {

// --- means over boxes ---

void add_row(const std::uint16_t* __restrict entering, const std::uint16_t* __restrict leaving,
             double* __restrict columns, int count) {
  ERG_EACH(i, count) columns[i] += static_cast<double>(std::int32_t{entering[i]} - std::int32_t{leaving[i]});
}
void add_sums(const double* __restrict entering, const double* __restrict leaving, double* __restrict columns,
              int count) {
  ERG_EACH(i, count) columns[i] += entering[i] - leaving[i];
}

/// Sums of 1, 2, 4 ... neighbours, each from the last; those that together make up the window are added.
void add_up(double* __restrict columns, double* __restrict sums, int count, int window) {
  int done = 0;
  for (int size = 1; size <= window; size *= 2) {
    if ((window & size) != 0) {
      const double* __restrict from = columns + done;
      if (done == 0) {
        ERG_EACH(i, count) sums[i] = from[i];
      } else {
        ERG_EACH(i, count) sums[i] += from[i];
      }
      done += size;
    }
    if (done == window) return;
    const int left = count + window - 2 * size;
    const double* ahead = columns + size;
    ERG_EACH(i, left) columns[i] += ahead[i];
  }
}

void average(const double* __restrict sums, float share, float* __restrict means, int count) {
  ERG_EACH(i, count) means[i] = static_cast<float>(sums[i]) * share;
}

// --- rates ---

std::uint32_t rates(const SnowPlanes& planes, int y, const SnowLevels& levels) {
  const SnowLaw law = *planes.law;  // a copy, which no store of the loop can change
  const std::size_t cell = planes.cell(0, y);
  const std::size_t place = planes.place(0, y);
  const float* __restrict here = levels.here;
  const float* __restrict south = levels.south;
  const float* __restrict north = levels.north;
  const float* __restrict around = levels.around;
  const float* __restrict landed = planes.landed + cell;
  const float* __restrict age = planes.age + cell;
  const std::int32_t* __restrict mobile = planes.mobile + cell;
  const std::int32_t* __restrict loose = planes.loose + cell;
  const std::uint16_t* __restrict height = planes.height + cell;
  const std::uint8_t* __restrict dark = planes.dark + cell;
  FlightCell* __restrict cells = planes.cells + place;
  std::uint32_t* __restrict chances = planes.chances + place;
  std::uint16_t* __restrict powers = planes.powers + place;
  std::int16_t* __restrict over = planes.over + place;
  const float by_x = planes.slope_by_x;
  const float by_y = planes.slope_by_y;
  const float rows = planes.rows;
  std::uint32_t longest = 0;
  ERG_EACH(x, planes.nx) {
    const SnowPlace from{.level = here[x],
                         .around = around[x],
                         .slope = by_x * (here[x + 1] - here[x - 1]) + by_y * (north[x] - south[x]),
                         .surface = static_cast<std::int32_t>(height[x]),
                         .rest = law.now - landed[x],
                         .age = age[x],
                         .dark = dark[x]};
    const TransportRates made = transport_rates(law, from, rows);
    const std::uint32_t mean = mean_hop_64(made.hops);
    chances[x] = made.chances;
    powers[x] = static_cast<std::uint16_t>(made.hops >> 16);
    over[x] = static_cast<std::int16_t>(made.over);
    cells[x].snow = snow_word(loose[x], mobile[x]);
    cells[x].way = mean;
    longest = mean > longest ? mean : longest;
  }
  return longest;
}

// --- runs ---

constexpr int stretch = 128;  // cells that look ahead together; those beyond the end of a row do no harm

/// Cells in which higher ground stands so many rows ahead. A function of its own, or the compiler would join rows
/// instead of making vectors.
[[gnu::noinline]] void look_ahead(const std::int16_t* __restrict there, const std::int16_t* __restrict height,
                                  std::int16_t rows, std::int16_t* __restrict run) {
  ERG_EACH(i, stretch) run[i] = there[i] > height[i] ? rows : run[i];
}
/// The same where some of the lines have gone on one place more, and meet what stands `beside`.
[[gnu::noinline]] void look_aside(const std::int16_t* __restrict there, const std::int16_t* __restrict beside,
                                  const std::int16_t* __restrict moved, const std::int16_t* __restrict height,
                                  std::int16_t rows, std::int16_t* __restrict run) {
  ERG_EACH(i, stretch) {
    const auto met = static_cast<std::int16_t>(there[i] ^ ((there[i] ^ beside[i]) & moved[i]));
    run[i] = met > height[i] ? rows : run[i];
  }
}

/// Looks from cells (x, y) on to what their lines meet `rows` further on.
[[gnu::always_inline]] inline void look(const SnowPlanes& planes, int x, int y, int rows,
                                        const std::int16_t* __restrict height, std::int16_t* __restrict run) {
  const auto row_of = [&planes](int there) {
    return planes.ahead + static_cast<std::ptrdiff_t>(there) * planes.ahead_pitch;
  };
  const auto count = static_cast<std::int16_t>(rows);
  if (planes.along_x) {
    const int on = x + (planes.step_v > 0 ? rows : -rows);
    if (planes.moved == nullptr) return look_ahead(row_of(y) + on, height, count, run);
    const int least = y + (planes.step_u > 0 ? planes.least_moved[rows] : planes.ny - planes.least_moved[rows]);
    const int there = least < planes.ny ? least : least - planes.ny;
    const int next = there + (planes.step_u > 0 ? 1 : planes.ny - 1);
    const int beside = next < planes.ny ? next : next - planes.ny;
    return look_aside(row_of(there) + on, row_of(beside) + on, planes.moved + planes.place(x, rows), height, count,
                      run);
  }
  const int row = planes.step_v > 0 ? y : planes.ny - 1 - y;
  if (!planes.torus && row + rows >= planes.length) return;
  const int on = row + rows < planes.length ? row + rows : (row + rows) % planes.length;
  const int moved = planes.offsets[row + rows + 1] - planes.offsets[row + 1];
  const int columns = moved < 0 ? moved + planes.width : moved;
  look_ahead(row_of(planes.step_v > 0 ? on : planes.ny - 1 - on) + x + (planes.step_u > 0 ? columns : -columns), height,
             count, run);
}

/// Rows until higher ground, or `unhindered_run` where there is none within reach. Beyond an open edge there is none.
void runs(const SnowPlanes& planes, int y) {
  const int clearance_16 = planes.law->clearance_16;
  for (int x = 0; x < planes.nx; x += stretch) {
    alignas(64) std::int16_t height[stretch];
    alignas(64) std::int16_t run[stretch];
    const std::int16_t* __restrict from = planes.ahead + static_cast<std::ptrdiff_t>(y) * planes.ahead_pitch + x;
    ERG_EACH(i, stretch) {
      height[i] = static_cast<std::int16_t>(flying_height(from[i], clearance_16));
      run[i] = unhindered_run;
    }
    for (int rows = planes.reach; rows > 0; --rows) look(planes, x, y, rows, height, run);
    FlightCell* __restrict cells = planes.cells + planes.place(x, y);
    ERG_EACH(i, planes.nx - x < stretch ? planes.nx - x : stretch) {
      cells[i].way |= static_cast<std::uint32_t>(run[i]) << 16;
    }
  }
}

// --- snow that lies ---

/// Writes the snow that flights have left back into the terrain.
void scatter(const SnowPlanes& planes, int y) {
  const std::size_t cell = planes.cell(0, y);
  const FlightCell* __restrict cells = planes.cells + planes.place(0, y);
  std::int32_t* __restrict mobile = planes.mobile + cell;
  std::int32_t* __restrict loose = planes.loose + cell;
  float* __restrict landed = planes.landed + cell;
  const float now = planes.law->now;
  ERG_EACH(x, planes.nx) {
    mobile[x] = mobile_of(cells[x].snow);
    loose[x] = loose_of(cells[x].snow);
    landed[x] = (cells[x].way & snow_has_landed) != 0 ? now : landed[x];
  }
}

/// 64 bytes, each 0 or 1, as bits.
[[gnu::always_inline]] inline std::uint64_t bits_of(const std::uint8_t* bytes) {
  std::uint64_t bits = 0;
  for (int k = 0; k < 8; ++k) {
    std::uint64_t eight = 0;
    __builtin_memcpy(&eight, bytes + 8 * k, 8);
    bits |= (eight * 0x0102040810204080u >> 56) << (8 * k);  // one bit of each byte
  }
  return bits;
}

std::uint64_t steep(const SnowPlanes& planes, std::size_t a, std::size_t b, int count) {
  const std::int32_t* __restrict snow_a = planes.mobile + a;
  const std::int32_t* __restrict snow_b = planes.mobile + b;
  const std::int32_t step = planes.law->critical_step;
  alignas(64) std::uint8_t steep[64] = {};
  if (planes.relief) {
    const std::int32_t* __restrict ground_a = planes.bedrock + a;
    const std::int32_t* __restrict ground_b = planes.bedrock + b;
    ERG_EACH(i, count) {
      const std::int32_t difference = ground_a[i] + snow_a[i] - ground_b[i] - snow_b[i];
      steep[i] = (difference > step ? 1 : 0) | (difference < -step ? 1 : 0);
    }
  } else {
    ERG_EACH(i, count) {
      const std::int32_t difference = snow_a[i] - snow_b[i];
      steep[i] = (difference > step ? 1 : 0) | (difference < -step ? 1 : 0);
    }
  }
  return bits_of(steep);
}

void rest(const SnowPlanes& planes, int y) {
  const SnowLaw& law = *planes.law;
  const std::size_t cell = planes.cell(0, y);
  const std::int32_t* __restrict mobile = planes.mobile + cell;
  const float* __restrict landed = planes.landed + cell;
  std::int32_t* __restrict loose = planes.loose + cell;
  float* __restrict age = planes.age + cell;
  float* __restrict shown_loose = planes.shown_loose + cell;
  float* __restrict shown_bonded = planes.shown_bonded + cell;
  const std::uint32_t number = planes.number + static_cast<std::uint32_t>(y) * planes.number_by_y;
  const std::uint32_t key = planes.bonding_key + number * 0x9e3779b9u;
  const std::uint32_t next_key = planes.number_by_x * 0x9e3779b9u;
  ERG_EACH(x, planes.nx) {
    const RestingSnow before{mobile[x], loose[x], age[x], law.now - landed[x]};
    const RestingSnow after = rested(law, before, mix32(key + static_cast<std::uint32_t>(x) * next_key));
    loose[x] = after.loose;
    age[x] = after.age;
    shown_loose[x] = static_cast<float>(after.loose);
    shown_bonded[x] = static_cast<float>(mobile[x] - after.loose);
  }
}

/// Of the uppermost bonded snow.
void strength(const SnowPlanes& planes, int y, float* __restrict strength) {
  const SnowLaw law = *planes.law;  // a copy, which no store of the loops can change
  const std::int32_t* __restrict mobile = planes.mobile + planes.cell(0, y);
  const std::int32_t* __restrict loose = planes.loose + planes.cell(0, y);
  const auto point = [&law](int column, int row, int layer) { return strength_point(law, column, row, layer); };
  if (has_noise(law)) {
    ERG_EACH(x, planes.nx) strength[x] = noise_strength(law, x, y, mobile[x] - loose[x], point);
  } else {
    ERG_EACH(x, planes.nx) strength[x] = 1;
  }
  if (!has_layers(law)) return;
  ERG_EACH(x, planes.nx) strength[x] *= layer_strength(law, mobile[x] - loose[x]);
}

#include "models/snow/snow_flight.inl"

#undef ERG_EACH

}  // namespace

extern const SnowKernels snow_kernels;
const SnowKernels snow_kernels{
    rates, runs, scatter, rest, strength, poll_all, fly, steep, {add_row, add_sums, add_up, average}};

}  // namespace ERG_KERNELS
}  // namespace erg::models
