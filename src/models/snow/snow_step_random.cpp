#include "models/snow/snow_step_random.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "compute/executor.h"
#include "core/errors.h"
#include "kernels/fixed_point.h"
#include "kernels/line_walk.h"
#include "models/slab/slab_cell.h"
#include "models/slab/sub_sweep.h"
#include "models/slab/terrain_heights.h"

namespace erg::models {
namespace {

/// What the random words are for; each has a key space of its own.
enum SnowWord : std::uint64_t { fall = 62, bonds, slides, sweep_words = 80, rows, lines };

}  // namespace

void StepRandom::draw_sweeps(StepKey key, int polling) {
  sweeps.resize(static_cast<std::size_t>(polling + longest_flight + 1));
  PolledRows polled;
  polled.permute(key, 0, rows, polling, 0, PolledRows::permutations);
  const auto step_key = static_cast<std::uint32_t>(random_word(key, 0, 1, sweep_words));
  for (std::size_t number = 0; number < sweeps.size(); ++number) {
    SnowSweep& sweep = sweeps[number];
    sweep.polls = number < static_cast<std::size_t>(polling);
    sweep.last = number + 1 == sweeps.size();
    sweep.step_key = step_key;
    sweep.key = static_cast<std::uint32_t>(random_word(key, number, 0, sweep_words));
    if (!sweep.polls) continue;
    std::ranges::copy(polled.of_sweep[number], std::begin(sweep.polled_row));
  }
}

void StepRandom::draw_lines(const forcing::WindFrame& frame, StepKey key, std::uint32_t longest_mean_hop) {
  reach = longest_snow_hop(longest_mean_hop);
  ring_rows = static_cast<int>(std::bit_ceil(static_cast<unsigned>(reach + 1)));
  drift = 0;
  std::int64_t phase = 0;
  if (frame.tangent > 0) {
    const auto tangent_24 = static_cast<std::int64_t>(frame.tangent * 0x1p24);
    drift = (frame.length * tangent_24 + random_below(key, 0, 0, lines, 1u << 24)) >> 24;
    phase = random_below(key, 0, 1, lines, static_cast<std::uint32_t>(frame.length));
  }
  offsets.resize(static_cast<std::size_t>(frame.length + reach + 2));
  for (int row = -1; row <= frame.length + reach; ++row) {
    offsets[static_cast<std::size_t>(row + 1)] =
        wrap(kernels::line_offset(row, drift, phase, frame.length), frame.width);
  }
}

void draw_snow_slides(StepKey key, int round, SnowEdges (&order)[4]) {
  for (int kind = 0; kind < 4; ++kind) order[kind] = {kind < 2, kind & 1};
  for (std::uint32_t last = 3; last > 0; --last) {
    std::swap(order[last], order[random_below(key, static_cast<std::uint64_t>(round), last, slides, last + 1)]);
  }
}

std::uint64_t snowfall_word(StepKey key) { return random_word(key, 0, 0, fall); }
std::uint32_t bonding_key(StepKey key) { return static_cast<std::uint32_t>(random_word(key, 0, 0, bonds)); }

void check_snow_height(std::int32_t most_snow, std::int32_t relief) {
  const std::int32_t grown = std::max(most_snow, relief);
  if (grown <= highest_terrain) return;
  throw InputError("terrain",
                   "it is " + std::to_string(grown) + " slabs high, more than " + std::to_string(highest_terrain),
                   "use a larger slab height or less snow");
}

}  // namespace erg::models
