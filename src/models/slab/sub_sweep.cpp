#include "models/slab/sub_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "forcing/wind_frame.h"
#include "kernels/fixed_point.h"
#include "kernels/shadow.h"
#include "kernels/shadow_reach.h"
#include "models/slab/slab_law.h"

namespace erg::models {

using forcing::WindFrame;

namespace {

/// What the random words of a step are for; each has a key space of its own.
enum SweepWord : std::uint64_t { decisions = 16, polls, lines, slide_order, permutations };

void draw_lines(const WindFrame& frame, StepKey key, std::uint64_t line_age, SubSweep& drawn) {
  if (frame.tangent <= 0) return;
  drawn.oblique = true;
  const auto tangent_24 = static_cast<std::int64_t>(frame.tangent * 0x1p24);
  drawn.drift = (frame.length * tangent_24 + random_below(key, line_age, 0, lines, 1u << 24)) >> 24;
  drawn.phase = random_below(key, line_age, 1, lines, static_cast<std::uint32_t>(frame.length));
}

void draw_slide_order(const SlabLaw& law, StepKey key, std::uint64_t sweep, SubSweep& drawn) {
  drawn.edge_classes = law.neighbours == 8 ? 8 : 4;
  const auto classes = static_cast<std::uint32_t>(drawn.edge_classes);
  for (std::uint32_t k = 0; k < classes; ++k) drawn.order[k] = static_cast<std::uint8_t>(k);
  for (std::uint32_t last = classes - 1; last > 0; --last) {
    std::swap(drawn.order[last], drawn.order[random_below(key, sweep, last, slide_order, last + 1)]);
  }
}

/// The share of a sub-sweep's polls that forced erosion still needs.
std::uint32_t poll_share_16(const SlabLaw& law, const WindFrame& frame, const StepAccount& account) {
  const std::int64_t wanted = static_cast<std::int64_t>(frame.width) * frame.length - account.lifts;
  if (!law.forced_erosion || wanted >= account.last_lifts) return whole_share_16;
  return static_cast<std::uint32_t>(wanted * whole_share_16 / account.last_lifts);
}

}  // namespace

void StepAccount::book(const SubSweep& done, std::int64_t lifted) {
  ++sweep;
  idle = lifted > 0 ? 0 : idle + 1;
  lifts += lifted;
  last_lifts = lifted;
  complete = done.poll_share_16 < whole_share_16;
}

double hop_rounding(StepKey key) {
  // Multiples of the golden ratio fill [0, 1) evenly, however few steps there are.
  const std::uint64_t word = mix64(key.seed) + key.step * 0x9e3779b97f4a7c15u;
  return static_cast<double>(word >> 48) * 0x1p-16;
}

void PolledRows::permute(StepKey key, std::uint64_t round, std::uint64_t draw, int sweeps, int first, int end) {
  std::array<std::uint8_t, 64> order{};
  for (int number = first; number < end; ++number) {
    std::iota(order.begin(), order.begin() + sweeps, std::uint8_t{0});
    std::uint64_t word = random_word(key, round, static_cast<std::uint64_t>(number), draw);
    for (int last = sweeps - 1; last > 0; --last) {
      word = mix64(word);
      const auto other = static_cast<std::size_t>(((word >> 32) * static_cast<std::uint64_t>(last + 1)) >> 32);
      std::swap(order[static_cast<std::size_t>(last)], order[other]);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) of_sweep[sweep][number] = order[static_cast<std::size_t>(sweep)];
  }
}

void PolledRows::draw(StepKey key, int sweep, int sweeps, int first, int end) {
  permute(key, static_cast<std::uint64_t>(sweep / sweeps), SweepWord::permutations, sweeps, first, end);
}

SubSweep sub_sweep(const SlabLaw& law, const WindFrame& frame, bool open, StepKey key, const StepAccount& account,
                   int sweeps, const PolledRows& rows) {
  const int sweep = account.sweep;
  const int round = sweep / sweeps;
  const auto number = static_cast<std::uint64_t>(sweep);
  SubSweep drawn;
  drawn.sweeps = sweeps;
  drawn.sweep_word = random_word(key, number, 0, decisions);
  // Non-repeated polling cuts the lines into blocks for a whole round of K sub-sweeps, so it keeps its lines that long.
  const std::uint64_t line_age = law.repeated_polling ? number : static_cast<std::uint64_t>(round) << 32;
  drawn.poll_word = random_word(key, line_age, 0, polls);
  drawn.poll_share_16 = poll_share_16(law, frame, account);
  drawn.permuted = !law.repeated_polling;
  if (drawn.permuted) std::ranges::copy(rows.of_sweep[sweep % sweeps], drawn.polled_row);
  draw_lines(frame, key, line_age, drawn);
  const std::int64_t turns = frame.width / std::gcd<std::int64_t>(frame.width, drawn.drift);
  drawn.rows_around = std::min<std::int64_t>(turns, kernels::longest_shadow) * frame.length;
  drawn.p_sand_16 = static_cast<std::uint32_t>(std::llround(law.p_sand * 65536));
  drawn.p_bare_16 = static_cast<std::uint32_t>(std::llround(law.p_bare * 65536));
  drawn.lift_in_shadow = law.lift_in_shadow;
  const auto fall = [](double slabs) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(kernels::fixed_point(slabs), 1, 0xffffffff));
  };
  const kernels::ShadowFalls falls = kernels::shadow_falls(frame, law.shadow_fall);
  drawn.row_fall = fall(falls.row);
  drawn.next_fall = fall(falls.next);
  drawn.second_fall = fall(falls.second);
  drawn.wall_step = law.bare.straight;
  if (open && sweep < sweeps) drawn.inflow = law.inflow / sweeps;
  draw_slide_order(law, key, number, drawn);
  return drawn;
}

bool goes_on(const SlabLaw& law, const StepAccount& account, std::int64_t cells, int sweeps) {
  if (!law.forced_erosion) return account.sweep < sweeps;
  return !account.complete && account.lifts < cells && account.idle < idle_rounds * sweeps;
}

}  // namespace erg::models
